"""An edit of the text as its syntax sees it: the edits between two rows that share pieces."""

from collections.abc import Iterator, Sequence

from kindsl.frontends.lsp.text.row import Piece, Row, in_common, n_same
from kindsl.language.text.edits import TextEdit


def edits_between(pieces: Sequence[Piece], starts: Sequence[int], row: Row) -> Iterator[TextEdit]:
    """Yield disjoint edits that lead from a text in pieces to one that shares most of them.

    Args:
        pieces: Of the text before.
        starts: Their offsets, and its length.
        row: The text after.
    """
    before, after = in_common(pieces, row.pieces)
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
    """Yield the least edit that puts a text for some pieces, if they are not that text."""
    old = "".join([piece.text for piece in pieces])
    if old == new:
        return
    shorter = min(len(old), len(new))
    n_old, n_new = len(old), len(new)
    before = n_same(shorter, lambda a, b: old[a:b] == new[a:b])
    after = n_same(
        shorter - before, lambda a, b: old[n_old - b : n_old - a] == new[n_new - b : n_new - a]
    )
    yield TextEdit(start + before, start + n_old - after, new[before : n_new - after])
