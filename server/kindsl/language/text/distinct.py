"""Names made unique by a number at their end."""

from collections.abc import Collection, Iterable
from itertools import chain, count


def free_name(wanted: str, taken: Collection[str]) -> str:
    """Return the name that is wanted, with a number from 2 on where it is taken."""
    names = chain((wanted,), (f"{wanted}_{number}" for number in count(2)))
    return next(name for name in names if name not in taken)


def distinct(names: Iterable[str]) -> list[str]:
    """Return names made unique; the first of equal ones keeps its name."""
    found: dict[str, None] = {}
    for name in names:
        found[free_name(name, found)] = None
    return list(found)
