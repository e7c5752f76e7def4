"""Places in a document that stay valid while other islands are edited."""

from typing import NamedTuple, Protocol

from kindsl.language.syntax.tree import Island, Node

_BREAKS = ("\r", "\n")


class Located(Protocol):
    """Whatever lies at a place: a name, an expression, a section, a whole link."""

    @property
    def island(self) -> Island:
        """The island it lies in."""

    @property
    def start(self) -> int:
        """First code point, counted from the island's start."""

    @property
    def end(self) -> int:
        """One past the last code point, counted from the island's start."""


class Place(NamedTuple):
    """A range of an island's text."""

    island: Island
    start: int
    end: int


class Name(str):
    """A name as it is meant (without the escape `^`), and where it stands.

    It compares and prints as its text, so models read naturally.
    """

    __slots__ = ("end", "island", "start")

    island: Island
    start: int
    end: int

    @classmethod
    def at(cls, text: str, island: Island, start: int, end: int) -> "Name":
        """Return the name `text` that stands from `start` to `end` of an island."""
        name = cls(text)
        name.island = island
        name.start = start
        name.end = end
        return name


class Construct:
    """The meaning of a node of the syntax; it lies where the node lies."""

    __slots__ = ("island", "node")

    def __init__(self, node: Node, island: Island) -> None:
        self.node = node
        self.island = island

    @property
    def start(self) -> int:
        """First code point, from the island's start."""
        return self.node.start

    @property
    def end(self) -> int:
        """One past the last code point, from the island's start."""
        return self.node.end


def has_problem_within(at: Located) -> bool:
    """Return whether something in a piece of text, or right beside it, is not in the language."""
    return any(
        problem.start <= at.end and problem.end >= at.start for problem in at.island.problems
    )


def with_lines(at: Located) -> Place:
    """Return a place with the blanks behind it, or with its lines if nothing else is on them."""
    text = at.island.text
    start = len(text[: at.start].rstrip(" \t"))
    end = len(text) - len(text[at.end :].lstrip(" \t"))
    is_last = end == len(text)
    if (not start or text[:start].endswith(_BREAKS)) and (is_last or text.startswith(_BREAKS, end)):
        end += 0 if is_last else 2 if text.startswith("\r\n", end) else 1
        return Place(at.island, start, end)
    return Place(at.island, at.start, end)
