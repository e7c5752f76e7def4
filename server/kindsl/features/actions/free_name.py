"""A name for what an action makes."""

from collections.abc import Collection
from itertools import chain, count


def free_name(wanted: str, taken: Collection[str]) -> str:
    """Return the name that is wanted, with a number from 2 on where it is taken."""
    names = chain((wanted,), (f"{wanted}_{number}" for number in count(2)))
    return next(name for name in names if name not in taken)
