"""Replacements in a text."""

from bisect import bisect_left
from collections.abc import Callable, Iterable, Sequence
from typing import NamedTuple

from kindsl.language.text.lines import newline_of

# What is compared in one go: of ten thousand items nearly all are the same.
_BLOCK = 256


class TextEdit(NamedTuple):
    """Replace `start` to `end` (code points, end exclusive) by `text`."""

    start: int
    end: int
    text: str


def in_line_style(edit: TextEdit, text: str) -> TextEdit:
    """Return an edit with the line ends that a text has."""
    if "\n" not in edit.text:
        return edit
    return edit._replace(text=edit.text.replace("\r\n", "\n").replace("\n", newline_of(text)))


def apply_edits(text: str, edits: Iterable[TextEdit]) -> str:
    """Return `text` with all edits made at once.

    Raises:
        ValueError: Two edits overlap.
    """
    pieces: list[str] = []
    done = 0
    for edit in sorted(edits, key=lambda e: (e.start, e.end)):
        if edit.start < done:
            raise ValueError(f"edits overlap at offset {edit.start}")
        pieces += text[done : edit.start], edit.text
        done = edit.end
    return "".join((*pieces, text[done:]))


def difference(old: str, new: str) -> TextEdit:
    """Return the shortest edit that turns one text into another."""
    before, after = in_common(old, new)
    return TextEdit(before, len(old) - after, new[before : len(new) - after])


def in_common(some: Sequence[object], others: Sequence[object]) -> tuple[int, int]:
    """Return how many items two rows share from the start, and how many of the rest at the end.

    Both rows are of one type: texts, lists or tuples.
    """
    n_some, n_others = len(some), len(others)
    shorter = min(n_some, n_others)
    before = n_same(shorter, lambda a, b: some[a:b] == others[a:b])
    after = n_same(
        shorter - before,
        lambda a, b: some[n_some - b : n_some - a] == others[n_others - b : n_others - a],
    )
    return before, after


def n_same(limit: int, are_same: Callable[[int, int], bool]) -> int:
    """Return for how many of some places, from the first, two rows are the same.

    Args:
        limit: How many places there are.
        are_same: Whether they are the same between two places, the second exclusive.
    """
    for first in range(0, limit, _BLOCK):
        stop = min(first + _BLOCK, limit)
        if not are_same(first, stop):
            longer = range(first + 1, stop)
            return first + bisect_left(longer, True, key=lambda end: not are_same(first, end))
    return limit
