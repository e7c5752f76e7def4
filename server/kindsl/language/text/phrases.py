"""Pieces of English sentences."""

from collections.abc import Iterable


def counted(number: int, noun: str) -> str:
    """Return a number with its noun, in the plural unless it is one: `1 joint`, `2 joints`."""
    return f"{number} {noun}" if number == 1 else f"{number} {noun}s"


def listed(words: Iterable[str]) -> str:
    """Return words as `a, b and c`."""
    parts = list(words)
    if len(parts) < 2:
        return "".join(parts)
    return f"{', '.join(parts[:-1])} and {parts[-1]}"


def alternatives(words: Iterable[str]) -> str:
    """Return words as `a, b or c`."""
    parts = list(words)
    if len(parts) < 2:
        return "".join(parts)
    return f"{', '.join(parts[:-1])} or {parts[-1]}"
