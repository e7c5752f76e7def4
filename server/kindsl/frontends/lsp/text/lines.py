"""Lines and columns of a text that is held in pieces, found without walking through it."""

from bisect import bisect_right

from kindsl.frontends.lsp.text import code_units as convert
from kindsl.frontends.lsp.text.row import Piece, Row
from kindsl.language.text.facts import kept
from kindsl.language.text.lines import LineIndex


class Lines:
    """The starts of a text's lines; only CR LF, LF and CR end a line.

    Attributes:
        row: The text.
    """

    __slots__ = ("_recent", "row")

    def __init__(self, row: Row) -> None:
        self.row = row
        self._recent = (-1, 0, 0)

    @property
    def length(self) -> int:
        """Of the text, in code points."""
        return self.row.length

    @property
    def last(self) -> int:
        """Number of the last line."""
        return self.row.ends.total

    def text(self, start: int, end: int) -> str:
        """Return the text between two offsets."""
        return self.row.text(start, end)

    def start(self, line: int) -> int:
        """Return the offset at which a line begins; the text's end for a line past it."""
        if line <= 0:
            return 0
        if line > self.last:
            return self.length
        row = self.row
        number = row.ends.first_from(line) - 1
        within = _starts(row.pieces[number])[line - row.ends[number]]
        return row.lengths[number] + within

    def line(self, offset: int) -> int:
        """Return the number of the line that an offset is in."""
        return self._line_and_start(offset)[0]

    def line_text(self, line: int) -> str:
        """Return the text of a line without its end."""
        text = self.row.text(self.start(line), self.start(line + 1))
        if text.endswith("\r\n"):
            return text[:-2]
        return text[:-1] if text.endswith(("\n", "\r")) else text

    def offset(self, line: int, units: int, encoding: str) -> int:
        """Return the offset of a client's position, clamped to its line and to the text."""
        start = self.start(line)
        if line > self.last or line < 0:
            return start
        return start + convert.column(self.line_text(line), max(units, 0), encoding)

    def position(self, offset: int, encoding: str) -> tuple[int, int]:
        """Return the line and the client's column of an offset, clamped to the text."""
        offset = min(max(offset, 0), self.length)
        line, start = self._line_and_start(offset)
        return line, self.units(start, offset, encoding)

    def units(self, start: int, offset: int, encoding: str) -> int:
        """Return the width of a stretch, measured on from the last offset with the same start."""
        if self.row.is_ascii or encoding == convert.UTF32:
            return offset - start
        recent_start, recent_offset, units = self._recent
        if recent_start != start or recent_offset > offset:
            recent_offset, units = start, 0
        units += convert.width(self.row.text(recent_offset, offset), encoding)
        self._recent = (start, offset, units)
        return units

    def _line_and_start(self, offset: int) -> tuple[int, int]:
        """Return the number of the line that an offset is in, and where that begins."""
        row = self.row
        number = row.piece_at(offset)
        starts, origin = _starts(row.pieces[number]), row.lengths[number]
        within = bisect_right(starts, offset - origin) - 1
        line = row.ends[number] + within
        return line, origin + starts[within] if within else self.start(line)


@kept
def _starts(piece: Piece) -> list[int]:
    return LineIndex(piece.text).starts
