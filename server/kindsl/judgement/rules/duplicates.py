"""Things with the same name or number."""

from collections.abc import Callable, Hashable, Iterable
from typing import TypeVar

from kindsl.language.semantics.declarations import Frame, Joint, Link

_Thing = TypeVar("_Thing")
_NamedThing = TypeVar("_NamedThing", Frame, Joint, Link)


def repeats(
    things: Iterable[_Thing], key: Callable[[_Thing], Hashable]
) -> list[tuple[_Thing, _Thing]]:
    """Return each thing that repeats the key of an earlier one, as (first, repeat).

    Empty keys are left out.
    """
    first: dict[Hashable, _Thing] = {}
    found: list[tuple[_Thing, _Thing]] = []
    for thing in things:
        value = key(thing)
        if value is not None and value != "":
            known = first.setdefault(value, thing)
            if known is not thing:
                found.append((known, thing))
    return found


def repeated_names(things: Iterable[_NamedThing]) -> list[tuple[_NamedThing, _NamedThing]]:
    """Return each thing that repeats the name of an earlier one, as (first, repeat)."""
    return repeats(things, lambda thing: str(thing.name))
