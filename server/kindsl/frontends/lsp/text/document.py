"""One version of a text that an editor shows or a file holds."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from lsprotocol import types

from kindsl.frontends.lsp.text import uris
from kindsl.frontends.lsp.text.lines import ContentChange, Lines, changed
from kindsl.frontends.lsp.text.row import PlainPiece, edits_between
from kindsl.judgement.config.file_names import TRANSFORMS_SUFFIX
from kindsl.language.text.facts import Facts
from kindsl.language.text.span import Span
from kindsl.robots.interchange.syntaxes import OWN_SUFFIX, is_xml_name, syntax_of

if TYPE_CHECKING:
    from kindsl.language.syntax.document import SyntaxDocument


class Document:
    """A text at one version; what it says never changes, a keystroke makes another.

    A version knows its lines at once and its syntax when that is first asked for, which is left
    to the worker: the message loop follows a typist however long the parser takes.

    Attributes:
        uri: As the client spells it.
        version: The client's number; None for a file that no editor shows.
        encoding: How the client counts columns.
        lines: Where its lines begin.
        facts: Results derived from this version, kept as long as it is.
        touched: The span that the last notification wrote, first change to last; None before.
    """

    __slots__ = ("_basis", "_tree", "encoding", "facts", "lines", "touched", "uri", "version")

    def __init__(
        self,
        uri: str,
        version: int | None,
        lines: Lines,
        encoding: str,
        basis: "SyntaxDocument | None" = None,
    ) -> None:
        self.uri = uri
        self.version = version
        self.encoding = encoding
        self.lines = lines
        self.facts = Facts()
        self.touched: Span | None = None
        self._basis = basis
        self._tree: SyntaxDocument | None = None

    @property
    def is_toml(self) -> bool:
        """True if it is a configuration file rather than a robot."""
        return uris.basename(self.uri).endswith(".toml")

    @property
    def is_transforms(self) -> bool:
        """True if it lists the transforms that RobCoGen generates of a robot."""
        return uris.basename(self.uri).endswith(TRANSFORMS_SUFFIX)

    @property
    def is_robot(self) -> bool:
        """True if it describes a robot in the Kinematics-DSL."""
        return not self.is_toml and not self.is_transforms and not self.is_xml

    @property
    def is_xml(self) -> bool:
        """True if it describes a robot in XML, by its name, whatever language the editor takes."""
        return is_xml_name(uris.basename(self.uri))

    @property
    def is_judged(self) -> bool:
        """True if it describes a robot on which rules have a word."""
        return self.is_robot or self.is_xml

    @property
    def text(self) -> str:
        """The whole text."""
        return self.lines.text(0, self.lines.length)

    @property
    def tree(self) -> "SyntaxDocument":
        """Its syntax; only the blocks are parsed that differ from an earlier version's."""
        if self._tree is None:
            tree = self._parsed()
            self.lines = self.lines.held_in(tree.islands)
            self._tree = tree
            self._basis = None
        return self._tree

    def changed(self, changes: Sequence[ContentChange], version: int) -> "Document":
        """Return the next version."""
        basis = self._basis  # before the tree, which the worker puts in its place
        basis = basis if self._tree is None else self._tree
        lines, touched = changed(self.lines, changes, self.encoding)
        document = Document(self.uri, version, lines, self.encoding, basis)
        document.touched = touched
        return document

    def offset(self, position: types.Position) -> int:
        """Return the code point that a client's position means, clamped."""
        return self.lines.offset(position.line, position.character, self.encoding)

    def line_start(self, line: int) -> int:
        """Return the code point that a line begins with, clamped."""
        return self.lines.start(line)

    def position(self, offset: int) -> types.Position:
        """Return the client's position of a code point."""
        return types.Position(*self.lines.position(offset, self.encoding))

    def wire_range(self, start: int, end: int) -> dict[str, dict[str, int]]:
        """Return the client's range in the protocol's form, for what is sent in great numbers."""
        first, before = self.lines.position(start, self.encoding)
        last, after = self.lines.position(end, self.encoding)
        return {
            "start": {"line": first, "character": before},
            "end": {"line": last, "character": after},
        }

    def range(self, start: int, end: int) -> types.Range:
        """Return the client's range of a stretch of code points."""
        return types.Range(self.position(start), self.position(end))

    def _parsed(self) -> "SyntaxDocument":
        basis = self._basis
        if basis is None:
            return syntax_of(self.uri if self.is_xml else OWN_SUFFIX, self.text)
        starts = (*basis.starts, basis.length)
        return basis.edited(tuple(edits_between(basis.islands, starts, self.lines)))


def document(uri: str, version: int | None, text: str, encoding: str) -> Document:
    """Return a document that has just been opened or read."""
    return Document(uri, version, Lines([PlainPiece(text)]), encoding)
