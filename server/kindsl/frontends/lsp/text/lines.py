"""Lines and columns of a text that is held in pieces, found without walking through it.

Clients count columns in code units of UTF-8, UTF-16 or UTF-32, everybody else in code points.
"""

from bisect import bisect_left, bisect_right
from collections.abc import Sequence

from lsprotocol import types

from kindsl.frontends.lsp.text.row import Piece, Row
from kindsl.language.text.facts import kept
from kindsl.language.text.lines import LineIndex
from kindsl.language.text.span import Span

ContentChange = (
    types.TextDocumentContentChangePartial | types.TextDocumentContentChangeWholeDocument
)

UTF8 = types.PositionEncodingKind.Utf8
UTF32 = types.PositionEncodingKind.Utf32


class Lines(Row):
    """A text with the starts of its lines; only CR LF, LF and CR end a line."""

    __slots__ = ("_recent",)

    def __init__(self, pieces: Sequence[Piece]) -> None:
        super().__init__(pieces)
        self._recent = (-1, 0, 0)

    @property
    def last(self) -> int:
        """Number of the last line."""
        return self.ends[-1]

    def start(self, line: int) -> int:
        """Return the offset at which a line begins; the text's end for a line past it."""
        if line <= 0:
            return 0
        if line > self.last:
            return self.length
        number = bisect_left(self.ends, line) - 1
        within = _starts(self.pieces[number])[line - self.ends[number]]
        return self.lengths[number] + within

    def line(self, offset: int) -> int:
        """Return the number of the line that an offset is in."""
        return self._line_and_start(offset)[0]

    def line_text(self, line: int) -> str:
        """Return the text of a line without its end."""
        text = self.text(self.start(line), self.start(line + 1))
        if text.endswith("\r\n"):
            return text[:-2]
        return text[:-1] if text.endswith(("\n", "\r")) else text

    def offset(self, line: int, units: int, encoding: str) -> int:
        """Return the offset of a client's position, clamped to its line and to the text."""
        start = self.start(line)
        if line > self.last or line < 0:
            return start
        return start + column(self.line_text(line), max(units, 0), encoding)

    def position(self, offset: int, encoding: str) -> tuple[int, int]:
        """Return the line and the client's column of an offset, clamped to the text."""
        offset = min(max(offset, 0), self.length)
        line, start = self._line_and_start(offset)
        return line, self.units(start, offset, encoding)

    def units(self, start: int, offset: int, encoding: str) -> int:
        """Return the width of a stretch, measured on from the last offset with the same start."""
        if self.is_ascii or encoding == UTF32:
            return offset - start
        recent_start, recent_offset, units = self._recent
        if recent_start != start or recent_offset > offset:
            recent_offset, units = start, 0
        units += width(self.text(recent_offset, offset), encoding)
        self._recent = (start, offset, units)
        return units

    def _line_and_start(self, offset: int) -> tuple[int, int]:
        number = self.piece_at(offset)
        starts, origin = _starts(self.pieces[number]), self.lengths[number]
        within = bisect_right(starts, offset - origin) - 1
        line = self.ends[number] + within
        return line, origin + starts[within] if within else self.start(line)


def changed(lines: Lines, changes: Sequence[ContentChange], encoding: str) -> tuple[Lines, Span]:
    """Return the lines after some changes, and the stretch that they touched.

    Each change is in the positions that the one before it has left.
    """
    new = lines.copy()
    before = after = new.length
    for change in changes:
        start, end = _place(new, change, encoding)
        before, after = min(before, start), min(after, new.length - end)
        new.replace(start, end, change.text)
    return new, Span(before, new.length - after)


def width(text: str, encoding: str) -> int:
    """Return the number of code units of a text."""
    if encoding == UTF32 or text.isascii():
        return len(text)
    if encoding == UTF8:
        return len(text.encode("utf-8", "surrogatepass"))
    return len(text) + sum(character > "\uffff" for character in text)


def column(text: str, units: int, encoding: str) -> int:
    """Return how many characters lie before a number of code units, at most all.

    A number that points inside a character counts as its beginning.
    """
    if encoding == UTF32 or text.isascii():
        return min(units, len(text))
    for index, character in enumerate(text):
        units -= width(character, encoding)
        if units < 0:
            return index
    return len(text)


def _place(lines: Lines, change: ContentChange, encoding: str) -> tuple[int, int]:
    """Return the span that a change replaces; the ends of a range may come in either order."""
    if isinstance(change, types.TextDocumentContentChangeWholeDocument):
        return 0, lines.length
    ends = change.range.start, change.range.end
    start, end = sorted(lines.offset(end.line, end.character, encoding) for end in ends)
    return start, end


@kept
def _starts(piece: Piece) -> list[int]:
    return LineIndex(piece.text).starts
