"""One version of a text that an editor shows or a file holds."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from lsprotocol import types

from kindsl.lsp.text import uris
from kindsl.lsp.text.changes import Change, edits_of
from kindsl.lsp.text.lines import Lines, PlainPiece
from kindsl.text.edits import TextEdit
from kindsl.text.span import Span

if TYPE_CHECKING:
    from kindsl.syntax.document import SyntaxDocument


class Document:
    """A text at one version; what it says never changes, a keystroke makes another.

    A version knows its lines at once and its syntax when that is first asked for, which is left
    to the worker: the message loop follows a typist however long the parser takes.

    Attributes:
        uri: As the client spells it.
        version: The client's number; None for a file that no editor shows.
        encoding: How the client counts columns.
        lines: Where its lines begin.
        facts: What was derived from this version, kept as long as it is.
        touched: What the last notification wrote, from its first change to its last; None before.
    """

    __slots__ = ("_basis", "_tree", "encoding", "facts", "lines", "touched", "uri", "version")

    def __init__(
        self,
        uri: str,
        version: int | None,
        lines: Lines,
        encoding: str,
        basis: "_Basis | None" = None,
    ) -> None:
        self.uri = uri
        self.version = version
        self.encoding = encoding
        self.lines = lines
        self.facts: dict[object, Any] = {}
        self.touched: Span | None = None
        self._basis = basis
        self._tree: SyntaxDocument | None = None

    @property
    def is_toml(self) -> bool:
        """Whether it is a configuration file rather than a robot."""
        return uris.basename(self.uri).endswith(".toml")

    @property
    def is_parsed(self) -> bool:
        """Whether its syntax is known already."""
        return self._tree is not None

    @property
    def text(self) -> str:
        """The whole text."""
        return self.lines.text(0, self.lines.length)

    @property
    def tree(self) -> "SyntaxDocument":
        """Its syntax; only the blocks are parsed that differ from an earlier version's."""
        if self._tree is None:
            from kindsl.syntax.document import parse

            basis, lines = self._basis, self.lines
            tree = parse(self.text) if basis is None else basis.tree.edited(basis.edits(lines))
            if 2 * lines.n_pieces < len(tree):
                self.lines = Lines(tree.islands, tree.starts)
            self._tree = tree
        return self._tree

    def rest(self) -> None:
        """Drop the syntax; it is parsed again when it is next asked for."""
        text = self.text
        self._tree = self._basis = None
        self.lines = Lines((PlainPiece(text),), (0,))

    def changed(self, changes: Sequence[Change], version: int) -> "Document":
        """Return the next version."""
        edits = edits_of(self.lines, changes, self.encoding)
        lines = self.lines.edited(edits)
        changed = Document(self.uri, version, lines, self.encoding, self._basis_with(edits))
        if edits:
            behind = self.lines.length - edits[-1].end
            changed.touched = Span(edits[0].start, lines.length - behind)
        return changed

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

    def _basis_with(self, edits: list[TextEdit]) -> "_Basis | None":
        """Return the nearest version whose syntax is known, and what has changed since."""
        tree, basis = self._tree, self._basis
        if tree is not None:
            basis = _Basis(tree, tree.length, tree.length, ())
        if basis is None or not edits:
            return basis
        before = min(basis.before, edits[0].start)
        after = min(basis.after, self.lines.length - edits[-1].end)
        return _Basis(basis.tree, before, after, tuple(edits) if tree is not None else None)


class _Basis(NamedTuple):
    """An earlier version's syntax and what has changed since.

    Attributes:
        tree: The syntax.
        before: How much of the text is the same from the start.
        after: How much of it is the same up to the end.
        exact: The edits, if there was but one notification since.
    """

    tree: "SyntaxDocument"
    before: int
    after: int
    exact: tuple[TextEdit, ...] | None

    def edits(self, lines: Lines) -> Sequence[TextEdit]:
        """Return edits that lead to the text with these lines."""
        if self.exact is not None:
            return self.exact
        old_end = self.tree.length - self.after
        new_end = lines.length - self.after
        overlap = max(self.before - min(old_end, new_end), 0)
        start = self.before - overlap
        return (TextEdit(start, old_end, lines.text(start, new_end)),)


def document(uri: str, version: int | None, text: str, encoding: str) -> Document:
    """Return a document that has just been opened or read."""
    return Document(uri, version, Lines((PlainPiece(text),), (0,)), encoding)
