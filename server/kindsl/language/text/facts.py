"""Facts derived from a thing that never changes, kept with it as long as it lives."""

from collections.abc import Callable
from functools import wraps
from typing import Any, Generic, Protocol, TypeVar

T = TypeVar("T")


class Fact(Generic[T]):
    """A key for one kind of fact, under which its owner keeps and finds it."""

    __slots__ = ("name",)

    def __init__(self, name: str) -> None:
        self.name = name

    def __repr__(self) -> str:
        return f"Fact({self.name!r})"


class Facts:
    """The facts that are known of one thing, at most one of each kind."""

    __slots__ = ("_kept",)

    def __init__(self) -> None:
        self._kept: dict[Fact[Any], Any] = {}

    def get(self, fact: Fact[T]) -> T | None:
        """Return a fact, None if it has not been derived yet."""
        known: T | None = self._kept.get(fact)
        return known

    def keep(self, fact: Fact[T], value: T) -> T:
        """Keep a fact from now on; return it."""
        self._kept[fact] = value
        return value

    def made_of(self, fact: Fact[tuple[object, T]], given: object, make: Callable[[], T]) -> T:
        """Return a fact that depends on something else too; it is derived anew when that changes.

        Args:
            given: All that it is made of besides the thing.
        """
        known = self.get(fact)
        if known is None or known[0] != given:
            known = self.keep(fact, (given, make()))
        return known[1]

    def forget(self, fact: Fact[Any]) -> None:
        """Forget a fact, if it is kept."""
        self._kept.pop(fact, None)


class HasFacts(Protocol):
    """Thing that never changes."""

    @property
    def facts(self) -> Facts:
        """Facts derived from it."""


_Thing = TypeVar("_Thing", bound=HasFacts)


def kept(make: Callable[[_Thing], T]) -> Callable[[_Thing], T]:
    """Return a function that derives the same, once in the life of each thing."""
    fact = Fact[tuple[T]](make.__name__)

    @wraps(make)
    def known(thing: _Thing) -> T:
        found = thing.facts.get(fact)
        return (found or thing.facts.keep(fact, (make(thing),)))[0]

    return known
