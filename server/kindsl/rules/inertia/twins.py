"""What the names of links say of their twins, found once in a link's life."""

from kindsl.limbs.names import mirrored_name, part_name
from kindsl.rules.memory import Memory
from kindsl.semantics.declarations import Link

_PARTS = Memory[str]("part")
_TWINS = Memory[str | None]("right twin")


def part_of(body: Link) -> str:
    """Return which part a body is, as `part_name` does."""
    return _PARTS.of(body, (), lambda: part_name(body.name))


def right_twin_of(body: Link) -> str | None:
    """Return the name of a left body's twin, as `mirrored_name` does."""
    return _TWINS.of(body, (), lambda: mirrored_name(body.name))
