"""A text as a row of pieces: the one form in which `lsp` holds and changes texts.

Pieces are islands of the syntax where that is known, plain where it is not. Each keeps what was
derived from it; what all of them add up to is kept as running sums, so that a new version costs a
copy of three lists and what it touches.
"""

from bisect import bisect_right
from collections.abc import Iterable, Iterator, Sequence
from itertools import accumulate
from typing import Protocol, Self

from kindsl.language.text.edits import TextEdit, difference, in_common
from kindsl.language.text.facts import Fact, Facts

_LINE_ENDS = Fact[int]("line ends")


class Piece(Protocol):
    """A part of a text that never changes, and what was derived from it."""

    text: str
    facts: Facts


class PlainPiece:
    """A part of a text whose syntax is not known."""

    __slots__ = ("facts", "text")

    def __init__(self, text: str) -> None:
        self.text = text
        self.facts = Facts()


class Row:
    """Pieces whose texts joined are a text; changed only until it is handed out.

    No two pieces share a CR LF, and none is empty but the only one.

    Attributes:
        pieces: In the order of the text.
        lengths: Of the text before each piece, then of all, in code points.
        ends: How many lines end before each piece, then in all.
    """

    __slots__ = ("_n_wide", "ends", "lengths", "pieces")

    def __init__(self, pieces: Sequence[Piece]) -> None:
        self.pieces = list(pieces)
        self.lengths = [0, *accumulate(len(piece.text) for piece in pieces)]
        self.ends = [0, *accumulate(map(_line_ends, pieces))]
        self._n_wide = sum(map(_is_wide, pieces))

    def copy(self) -> Self:
        """Return the same row, to be changed apart from this one."""
        copied = type(self)(())
        copied.pieces, copied._n_wide = self.pieces.copy(), self._n_wide
        copied.lengths, copied.ends = self.lengths.copy(), self.ends.copy()
        return copied

    @property
    def length(self) -> int:
        """Of the text, in code points."""
        return self.lengths[-1]

    @property
    def is_ascii(self) -> bool:
        """True if all code points are as wide in any encoding."""
        return not self._n_wide

    def piece_at(self, offset: int) -> int:
        """Return the number of the piece that holds an offset, the last for the text's end."""
        return min(bisect_right(self.lengths, max(offset, 0)) - 1, len(self.pieces) - 1)

    def text(self, start: int, end: int) -> str:
        """Return the text between two offsets."""
        first, last = self.piece_at(start), self.piece_at(end)
        text = "".join([piece.text for piece in self.pieces[first : last + 1]])
        origin = self.lengths[first]
        return text[max(start - origin, 0) : max(end - origin, 0)]

    def replace(self, start: int, end: int, text: str) -> None:
        """Put a text for what stands between two offsets, one piece for those it touches."""
        first = self.piece_at(start)
        last = max(self.piece_at(end - 1), first)
        origin = self.lengths[first]
        old = "".join([piece.text for piece in self.pieces[first : last + 1]])
        new = old[: start - origin] + text + old[end - origin :]
        if first and (not new or (new[0] == "\n" and self.pieces[first - 1].text[-1] == "\r")):
            first -= 1
            new = self.pieces[first].text + new
        following = self.pieces[last + 1].text if last + 1 < len(self.pieces) else ""
        if following and (not new or (new[-1] == "\r" and following[0] == "\n")):
            last += 1
            new += following
        self._put(first, last + 1, [PlainPiece(new)])

    def held_in(self, pieces: Sequence[Piece]) -> Self:
        """Return a row of the same text in other pieces, most of which are these."""
        if not pieces:
            return self
        row = self.copy()
        before, after = in_common(self.pieces, [*pieces])
        row._put(before, len(self.pieces) - after, pieces[before : len(pieces) - after])
        return row

    def _put(self, first: int, last: int, pieces: Sequence[Piece]) -> None:
        self._n_wide += sum(map(_is_wide, pieces)) - sum(map(_is_wide, self.pieces[first:last]))
        self.pieces[first:last] = pieces
        replace_in_sums(self.lengths, first, last, [len(piece.text) for piece in pieces])
        replace_in_sums(self.ends, first, last, map(_line_ends, pieces))


def replace_in_sums(sums: list[int], first: int, last: int, numbers: Iterable[int]) -> None:
    """Put numbers for those from `first` to `last`, exclusive, in the sums up to each number."""
    new = list(accumulate(numbers, initial=sums[first]))
    shift = new[-1] - sums[last]
    sums[first : last + 1] = new
    if shift:
        behind = first + len(new)
        sums[behind:] = [each + shift for each in sums[behind:]]


def edits_between(pieces: Sequence[Piece], starts: Sequence[int], row: Row) -> Iterator[TextEdit]:
    """Yield disjoint edits that lead from a text in pieces to one that shares most of them.

    The starts of the pieces end with the length of the text before.
    """
    before, after = in_common([*pieces], row.pieces)
    stop = len(pieces) - after
    numbers = {id(pieces[number]): number for number in range(before, stop)}
    done, new = before, ""
    for piece in row.pieces[before : len(row.pieces) - after]:
        number = numbers.get(id(piece), -1)
        if number < done:
            new += piece.text
            continue
        yield from _edit(pieces[done:number], starts[done], new)
        done, new = number + 1, ""
    yield from _edit(pieces[done:stop], starts[done], new)


def _edit(pieces: Sequence[Piece], start: int, new: str) -> Iterator[TextEdit]:
    """Yield the smallest edit that replaces the text of some pieces, if it changes."""
    old = "".join([piece.text for piece in pieces])
    if old == new:
        return
    edit = difference(old, new)
    yield TextEdit(start + edit.start, start + edit.end, edit.text)


def _line_ends(piece: Piece) -> int:
    known = piece.facts.get(_LINE_ENDS)
    if known is None:
        text = piece.text
        known = text.count("\n")
        if "\r" in text:
            known += text.count("\r") - text.count("\r\n")
        piece.facts.keep(_LINE_ENDS, known)
    return known


def _is_wide(piece: Piece) -> bool:
    return not piece.text.isascii()
