"""What was made of a body before, as long as what it was made of stays the same."""

from collections.abc import Callable
from typing import TypeVar

from kindsl.semantics.declarations import Link

_T = TypeVar("_T")


def remembered(body: Link, what: str, given: tuple[object, ...], make: Callable[[], _T]) -> _T:
    """Return what is made of a body; made again only where something given is not equal any more.

    It is kept with the body's island, one result of each kind.

    Args:
        body: A body as written.
        what: What is made of it.
        given: All that it is made of besides the body; nothing that keeps another island alive.
        make: Makes it.
    """
    facts, key = body.island.facts, (what, body.name.start)
    known = facts.get(key)
    if not isinstance(known, tuple) or known[0] != given:
        known = facts[key] = given, make()
    made: _T = known[1]
    return made
