"""Replacements in a text."""

from collections.abc import Iterable
from itertools import takewhile
from typing import NamedTuple


class TextEdit(NamedTuple):
    """Replace `start` to `end` (code points, end exclusive) by `text`."""

    start: int
    end: int
    text: str


def apply_edits(text: str, edits: Iterable[TextEdit]) -> str:
    """Return `text` with all edits made at once.

    Args:
        text: The text that the offsets refer to.
        edits: Disjoint edits in any order; two insertions at one place keep their order.

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
    most = min(len(old), len(new))
    start = sum(1 for _ in takewhile(bool, (old[i] == new[i] for i in range(most))))
    most -= start
    same = sum(1 for _ in takewhile(bool, (old[-i] == new[-i] for i in range(1, most + 1))))
    return TextEdit(start, len(old) - same, new[start : len(new) - same])
