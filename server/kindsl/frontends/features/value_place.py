"""The meaning of a value: the mass, the CoM's y, a rotation about the new y."""

from collections.abc import Sequence
from typing import NamedTuple

from kindsl.frontends.features.quantity_text import INERTIA, KILOGRAMS, METRES
from kindsl.frontends.features.wording import code
from kindsl.language.semantics.declarations import ValueKind
from kindsl.language.semantics.expressions import Expression, name_of
from kindsl.language.syntax.tables import FORMS
from kindsl.language.syntax.tree import Island, Node
from kindsl.language.syntax.vocabulary import BLOCKS, of_kind

_SECTIONS = of_kind("scalar", "moments", "vector")
_OWNERS = frozenset((*BLOCKS, "frame"))
_AXES = ("x", "y", "z")
_TURNS = ("about x", "about the new y", "about the new z")
VALUE_NODES = frozenset(FORMS)


class ValuePlace(NamedTuple):
    """The place of a value in a document.

    Attributes:
        section: `mass`, `CoM`, `translation`, `rotation`, or a moment's name.
        component: 0 to 2 in a vector, None outside of one.
        kind: The class of the parameters that may stand there.
        unit: The unit of the number.
        owner: Kind of its owner: `frame`, `link`, `base` or `joint`.
        owner_name: Its name, empty where it is missing.
    """

    section: str
    component: int | None
    kind: ValueKind
    unit: str
    owner: str
    owner_name: str

    @property
    def label(self) -> str:
        """The value's name: `mass`, `CoM y`, `rotation about the new y`."""
        if self.component is None:
            return self.section
        names = _TURNS if self.kind is ValueKind.ANGLE else _AXES
        return f"{self.section} {names[self.component]}"

    @property
    def title(self) -> str:
        """The value's name, and its owner's."""
        return f"{self.label} of {self.owner} {code(self.owner_name)}"


def value_place(path: Sequence[Node], local: int) -> ValuePlace | None:
    """Return the place of the value at an offset of an island, None where no value stands.

    Args:
        path: The constructs around the offset, the outermost first.
        local: The offset.
    """
    section = next((node for node in path if node.kind in _SECTIONS), None)
    if section is None:
        return None
    vector = next((node for node in path if node.kind == "vector"), None)
    component = None if vector is None else _component(vector, local)
    kind, unit = _meaning(section)
    return ValuePlace(next(section.tokens()).text, component, kind, unit, *_owner(path))


def _owner(path: Sequence[Node]) -> tuple[str, str]:
    """Return the kind and the name of the innermost link, joint or frame on a path."""
    node = next(node for node in reversed(path) if node.kind in _OWNERS)
    return node.kind, name_of(node)


def expression_at(island: Island, path: Sequence[Node]) -> Expression | None:
    """Return the whole value on a path, not a part of it."""
    node = next((node for node in path if node.kind in VALUE_NODES), None)
    return Expression(node, island) if node is not None else None


def _component(vector: Node, local: int) -> int:
    return sum(1 for c in vector.children if c.kind == "," and c.start < c.end <= local)


def _meaning(section: Node) -> tuple[ValueKind, str]:
    return _MEANINGS.get(section.kind, (ValueKind.DYNAMICS, ""))


_MEANINGS = {
    "translation": (ValueKind.LENGTH, METRES),
    "rotation": (ValueKind.ANGLE, "rad"),
    "mass": (ValueKind.DYNAMICS, KILOGRAMS),
    "com": (ValueKind.DYNAMICS, METRES),
    "moment": (ValueKind.DYNAMICS, INERTIA),
}
