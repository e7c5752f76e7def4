"""Lines of a document that is held in pieces, found without walking through its text.

A keystroke changes one piece; the number of line ends in the others is remembered with them, so
that the table of a new version costs one addition a piece.
"""

from bisect import bisect_left, bisect_right
from collections.abc import Sequence
from itertools import accumulate
from typing import Protocol

from kindsl.lsp.text import code_units as convert
from kindsl.text.edits import TextEdit
from kindsl.text.lines import LineIndex


class Piece(Protocol):
    """A part of a text that never changes, and what was derived from it."""

    text: str
    facts: dict[object, object]


class PlainPiece:
    """The whole of a text that is not in the language."""

    __slots__ = ("facts", "text")

    def __init__(self, text: str) -> None:
        self.text = text
        self.facts: dict[object, object] = {}


class Lines:
    """Where the lines of a text begin; only CR LF, LF and CR end a line.

    Attributes:
        length: Of the text, in code points.
        last: Number of the last line.
    """

    __slots__ = ("_ends_before", "_is_ascii", "_pieces", "_recent", "_starts", "last", "length")

    def __init__(self, pieces: Sequence[Piece], starts: Sequence[int]) -> None:
        self._pieces = pieces
        self._starts = starts
        self._ends_before = [0, *accumulate(map(_line_ends, pieces))]
        self._is_ascii = all(piece.text.isascii() for piece in pieces)
        self._recent = (-1, 0, 0)
        self.last = self._ends_before[-1]
        self.length = starts[len(pieces) - 1] + len(pieces[-1].text) if pieces else 0

    @property
    def n_pieces(self) -> int:
        """How many pieces the text is held in."""
        return len(self._pieces)

    def edited(self, edits: Sequence[TextEdit]) -> "Lines":
        """Return the lines after disjoint edits, in the order of the text, made at once."""
        pieces, starts = list(self._pieces), list(self._starts[: len(self._pieces)])
        first = len(pieces)
        for edit in reversed(edits):
            first = _splice(pieces, starts, edit)
        del starts[first + 1 :]
        lengths = (len(piece.text) for piece in pieces[first:-1])
        starts[first:] = accumulate(lengths, initial=starts[first] if first < len(starts) else 0)
        return Lines(pieces, starts)

    def start(self, line: int) -> int:
        """Return the offset at which a line begins; the text's end for a line past it."""
        if line <= 0:
            return 0
        if line > self.last:
            return self.length
        piece = bisect_left(self._ends_before, line) - 1
        within = _index(self._pieces[piece]).starts[line - self._ends_before[piece]]
        return self._starts[piece] + within

    def line(self, offset: int) -> int:
        """Return the number of the line that an offset is in."""
        return self._line_and_start(offset)[0]

    def _line_and_start(self, offset: int) -> tuple[int, int]:
        """Return the number of the line that an offset is in, and where that begins."""
        if not self._pieces:
            return 0, 0
        piece = max(bisect_right(self._starts, offset, hi=len(self._pieces)) - 1, 0)
        starts, origin = _index(self._pieces[piece]).starts, self._starts[piece]
        within = bisect_right(starts, offset - origin) - 1
        line = self._ends_before[piece] + within
        return line, origin + starts[within] if within else self.start(line)

    def text(self, start: int, end: int) -> str:
        """Return the text between two offsets."""
        first = max(bisect_right(self._starts, start, hi=len(self._pieces)) - 1, 0)
        pieces: list[str] = []
        for index in range(first, len(self._pieces)):
            begin = self._starts[index]
            if begin >= end:
                break
            pieces.append(self._pieces[index].text[max(start - begin, 0) : end - begin])
        return "".join(pieces)

    def line_text(self, line: int) -> str:
        """Return the text of a line without its end."""
        return without_end(self.text(self.start(line), self.start(line + 1)))

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
        if self._is_ascii or encoding == convert.UTF32:
            return offset - start
        recent_start, recent_offset, units = self._recent
        if recent_start != start or recent_offset > offset:
            recent_offset, units = start, 0
        units += convert.width(self.text(recent_offset, offset), encoding)
        self._recent = (start, offset, units)
        return units


def _splice(pieces: list[Piece], starts: list[int], edit: TextEdit) -> int:
    """Put one piece for those that an edit touches; return its number.

    No two pieces share a CR LF, and none is empty but the only one.
    """
    first = max(bisect_right(starts, edit.start) - 1, 0)
    last = max(bisect_right(starts, max(edit.end - 1, edit.start)) - 1, first)
    origin = starts[first] if starts else 0
    old = "".join([piece.text for piece in pieces[first : last + 1]])
    text = old[: edit.start - origin] + edit.text + old[edit.end - origin :]
    if first and (not text or (text[0] == "\n" and pieces[first - 1].text.endswith("\r"))):
        first -= 1
        text = pieces[first].text + text
    following = pieces[last + 1].text if last + 1 < len(pieces) else ""
    if following and (not text or (text[-1] == "\r" and following[0] == "\n")):
        last += 1
        text += following
    pieces[first : last + 1] = [PlainPiece(text)]
    starts[first : last + 1] = starts[first : first + 1] or [0]
    return first


def without_end(line: str) -> str:
    """Return a line without the characters that end it."""
    if line.endswith("\r\n"):
        return line[:-2]
    return line[:-1] if line.endswith(("\n", "\r")) else line


def _index(piece: Piece) -> LineIndex:
    index = piece.facts.get(LineIndex)
    if not isinstance(index, LineIndex):
        index = piece.facts[LineIndex] = LineIndex(piece.text)
    return index


def _line_ends(piece: Piece) -> int:
    count = piece.facts.get(_line_ends)
    if not isinstance(count, int):
        text = piece.text
        count = text.count("\n")
        if "\r" in text:
            count += text.count("\r") - text.count("\r\n")
        piece.facts[_line_ends] = count
    return count
