"""One version of a text that an editor shows or a file holds."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from lsprotocol import types

from kindsl.lsp import uris
from kindsl.lsp.changes import Change, edits_of
from kindsl.lsp.lines import Lines, PlainPiece
from kindsl.text.edits import apply_edits

if TYPE_CHECKING:
    from kindsl.syntax.document import SyntaxDocument


class Document:
    """A text at one version; never changed, a keystroke makes another.

    Attributes:
        uri: As the client spells it.
        version: The client's number; None for a file that no editor shows.
        encoding: How the client counts columns.
        facts: What was derived from this version, kept as long as it is.
    """

    __slots__ = ("_content", "_lines", "encoding", "facts", "uri", "version")

    def __init__(
        self, uri: str, version: int | None, content: "SyntaxDocument | str", encoding: str
    ) -> None:
        self.uri = uri
        self.version = version
        self.encoding = encoding
        self.facts: dict[object, Any] = {}
        self._content = content
        self._lines: Lines | None = None

    @property
    def is_toml(self) -> bool:
        """Whether it is a configuration file rather than a robot."""
        return uris.basename(self.uri).endswith(".toml")

    @property
    def text(self) -> str:
        """The whole text."""
        return self._content if isinstance(self._content, str) else self._content.text

    @property
    def tree(self) -> "SyntaxDocument":
        """Its syntax; parsed when first asked for, which takes a while for a long text."""
        if isinstance(self._content, str):
            from kindsl.syntax.document import parse

            self._content, self._lines = parse(self._content), None
        return self._content

    @property
    def lines(self) -> Lines:
        """Where its lines begin."""
        if self._lines is None:
            content = self._content
            if isinstance(content, str):
                self._lines = Lines((PlainPiece(content),), (0,))
            else:
                self._lines = Lines(content.islands, content.starts)
        return self._lines

    def changed(self, changes: Sequence[Change], version: int) -> "Document":
        """Return the next version; only the blocks that the changes touch are parsed again."""
        edits = edits_of(self.lines, changes, self.encoding)
        content = self._content
        if isinstance(content, str):
            return Document(self.uri, version, apply_edits(content, edits), self.encoding)
        return Document(self.uri, version, content.edited(edits), self.encoding)

    def offset(self, position: types.Position) -> int:
        """Return the code point that a client's position means, clamped."""
        return self.lines.offset(position.line, position.character, self.encoding)

    def line_start(self, line: int) -> int:
        """Return the code point that a line begins with, clamped."""
        return self.lines.start(line)

    def position(self, offset: int) -> types.Position:
        """Return the client's position of a code point."""
        return types.Position(*self.lines.position(offset, self.encoding))

    def range(self, start: int, end: int) -> types.Range:
        """Return the client's range of a stretch of code points."""
        return types.Range(self.position(start), self.position(end))
