"""Pieces of English sentences."""

from collections.abc import Iterable


def counted(number: int, noun: str) -> str:
    """Return a number with its noun, in the plural unless it is one: `1 joint`, `2 joints`."""
    return f"{number} {noun}" if number == 1 else f"{number} {noun}s"


def listed(words: Iterable[str], last: str = "and") -> str:
    """Return words as `a, b and c`."""
    *others, end = list(words) or [""]
    return f"{', '.join(others)} {last} {end}" if others else end


def alternatives(words: Iterable[str]) -> str:
    """Return words as `a, b or c`."""
    return listed(words, "or")
