"""Things by what they have in common."""

from collections.abc import Hashable, Iterable
from typing import TypeVar

_Key = TypeVar("_Key", bound=Hashable)
_Thing = TypeVar("_Thing")


def grouped(pairs: Iterable[tuple[_Key | None, _Thing]]) -> dict[_Key, list[_Thing]]:
    """Return the things of each key, both in their order, but for those without a key."""
    found: dict[_Key, list[_Thing]] = {}
    for key, thing in pairs:
        if key is not None:
            found.setdefault(key, []).append(thing)
    return found
