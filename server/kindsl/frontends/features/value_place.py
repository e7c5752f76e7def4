"""The meaning of a value where it stands: the mass, the CoM's y, a rotation about the new y."""

from collections.abc import Sequence
from typing import NamedTuple

from kindsl.frontends.features.tree_path import path_at
from kindsl.frontends.features.wording import code
from kindsl.language.semantics.expressions import Expression
from kindsl.language.semantics.places import Name
from kindsl.language.syntax.arithmetic import name_of
from kindsl.language.syntax.tables import DECLARES, FORMS, VALUES, ValueKind
from kindsl.language.syntax.tree import Island, Node
from kindsl.language.syntax.vocabulary import Meaning, meanings

VALUE_NODES = frozenset(FORMS)
_TURNS = ("about x", "about the new y", "about the new z")


class ValuePlace(NamedTuple):
    """The place of a value in a document.

    Attributes:
        meaning: Its section and component, their class and unit.
        owner: The kind of its owner: `frame`, `link`, `base` or `joint`.
    """

    meaning: Meaning
    owner: str
    owner_name: str

    @property
    def label(self) -> str:
        """The value's name: `mass`, `CoM y`, `rotation about the new y`."""
        section, component = self.meaning.section, self.meaning.component
        return section if component is None else f"{section} {component_name(self.meaning)}"

    @property
    def title(self) -> str:
        """The value's name, and its owner's."""
        return f"{self.label} of {self.owner} {code(self.owner_name)}"


def component_name(meaning: Meaning) -> str:
    """Return what a component of a vector is called: `y`, or `about the new y`."""
    names = _TURNS if meaning.kind is ValueKind.ANGLE else "xyz"
    return names[meaning.component or 0]


def value_place(path: Sequence[Node], local: int) -> ValuePlace | None:
    """Return the place of the value at an offset of an island, None where no value stands."""
    section = next((node for node in path if node.kind in VALUES), None)
    if section is None:
        return None
    owner = next(node for node in reversed(path) if node.kind in DECLARES)
    of_section = meanings(section)
    before = (t for t in section.tokens() if t.kind == "," and t.start < t.end <= local)
    meaning = of_section[min(sum(1 for _ in before), len(of_section) - 1)]
    return ValuePlace(meaning, owner.kind, name_of(owner))


def place_of_name(name: Name) -> ValuePlace | None:
    """Return the place of the value that a parameter or constant stands in."""
    return value_place(path_at(name.island, name.start), name.start)


def expression_at(island: Island, path: Sequence[Node]) -> Expression | None:
    """Return the whole value on a path, not a part of it."""
    node = next((node for node in path if node.kind in VALUE_NODES), None)
    return Expression(node, island) if node is not None else None
