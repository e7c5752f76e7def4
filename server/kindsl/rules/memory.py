"""Results made of a body before, as long as their sources stay the same."""

from collections.abc import Callable
from typing import Generic, TypeVar

from kindsl.semantics.declarations import Link
from kindsl.text.facts import Fact

_T = TypeVar("_T")
Given = tuple[object, ...]


class Memory(Generic[_T]):
    """The results of one file on bodies; the last is kept with each body's island."""

    __slots__ = ("_made",)

    def __init__(self, what: str) -> None:
        self._made: Fact[dict[int, tuple[Given, _T]]] = Fact(what)

    def of(self, body: Link, given: Given, make: Callable[[], _T]) -> _T:
        """Return what is made of a body; made again only where something given differs.

        Args:
            body: A body as written.
            given: All that it is made of besides the body; nothing that keeps another island alive.
            make: Makes it.
        """
        facts = body.island.facts
        of_island = facts.get(self._made)
        if of_island is None:
            of_island = facts.keep(self._made, {})
        known = of_island.get(body.name.start)
        if known is None or known[0] != given:
            known = of_island[body.name.start] = given, make()
        return known[1]
