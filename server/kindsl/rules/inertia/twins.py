"""Twins of links by their names, found once for a name."""

from functools import lru_cache

from kindsl.limbs.names import mirrored_name, part_name
from kindsl.semantics.declarations import Link

_MOST_NAMES = 4096
_part = lru_cache(_MOST_NAMES)(part_name)
_right_twin = lru_cache(_MOST_NAMES)(mirrored_name)


def part_of(body: Link) -> str:
    """Return which part a body is, as `part_name` does."""
    return _part(str(body.name))


def right_twin_of(body: Link) -> str | None:
    """Return the name of a left body's twin, as `mirrored_name` does."""
    return _right_twin(str(body.name))
