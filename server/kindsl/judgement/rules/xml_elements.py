"""The elements of robots in XML that rules look at."""

import re
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from kindsl.judgement.rules.base import Related
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.places import Place

if TYPE_CHECKING:
    from kindsl.robots.interchange.robot_island import RobotIsland
    from kindsl.robots.interchange.xml_reading import XmlElement

# As many places of one finding are read one by one; of more its sentence gives the number.
A_FEW = 3
_LIMITED = ("revolute", "prismatic")
_MOMENT = re.compile(r"\bI([xyz])([xyz]?)\b(?=(?:[^']*'[^']*')*[^']*$)")
# The greatest of both is given beside the limits of a joint.
EFFORT = ("effort", "velocity")


def in_words_of_xml(message: str) -> str:
    """Return a sentence with moments as XML calls them, names in quotes as they are."""
    return _MOMENT.sub(lambda found: f"i{found[1]}{found[2] or found[1]}", message)


def elements(model: Model, tag: str) -> "Iterator[tuple[RobotIsland, XmlElement]]":
    """Yield the elements of a kind of a robot in XML, with the islands that they are in."""
    if model.document.is_xml:
        from kindsl.robots.interchange.robot_island import RobotIsland

        for island in model.islands:
            if isinstance(island, RobotIsland):
                element: Any = island.element
                if element is not None and element.tag == tag:
                    yield island, element
                elif element is not None and element.tag == "body":
                    yield from ((island, each) for each in element.findall(tag))


class LimitedJoint(NamedTuple):
    """A joint that may have limits, in a URDF must.

    Attributes:
        island: Where it stands.
        element: The joint.
        kind: Its type, as in a URDF.
        unit: The unit of its position.
        limit: Where its limits are, None where it has none.
        lower: The lower one, None where it is not given.
        upper: The upper one.
    """

    island: "RobotIsland"
    element: "XmlElement"
    kind: str
    unit: str
    limit: "XmlElement | None"
    lower: float | None
    upper: float | None

    @property
    def name(self) -> str:
        """The joint's name, of one without its body's."""
        is_own = self.element is self.island.element
        return (not is_own and self.element.get("name")) or self.island.full_name

    @property
    def is_broken(self) -> bool:
        """True if a limit is written that is no number."""
        if self.limit is None:
            return False
        pairs = (("lower", self.lower), ("upper", self.upper))
        written = self.island.held
        return any(v is None and written(self.limit, name) is not None for name, v in pairs)

    @property
    def is_needed(self) -> bool:
        """True if a joint without limits cannot move: in an SDF or MJCF it has none then."""
        return self.island.has_attributes and self.limit is not self.element

    def at(self, limit: str) -> Place:
        """Return the place of a limit, or of the element, or of the joint."""
        return self.island.place(self.element if self.limit is None else self.limit, limit)


def joints_of(model: Model) -> Iterator[LimitedJoint]:
    """Yield the joints of any type."""
    for island, joint in elements(model, "joint"):
        kind, *limits = island.limits(joint)
        unit = "m" if kind == "prismatic" else model.document.angle_unit
        yield LimitedJoint(island, joint, kind, unit, *limits)


def limited_joints(model: Model) -> Iterator[LimitedJoint]:
    """Yield the joints that limits are for."""
    return (joint for joint in joints_of(model) if joint.kind in _LIMITED)


def is_without_limits(ends: Sequence[float]) -> bool:
    """Return whether limits are 1, 2 or 5 times a power of ten, equal but for the sign: none.

    Those of bases that float, and of rings closed by a simulator, are such.
    """
    greatest = max(map(abs, ends), default=0.0)
    is_round = f"{greatest:e}".startswith(("1.000000e", "2.000000e", "5.000000e"))
    return is_round and {abs(end) for end in ends if end} == {greatest}


def told_together(found: Sequence[tuple[LimitedJoint, str]]) -> tuple[str, tuple[Related, ...]]:
    """Return the first joint's name with the number of others, and places of a few of these.

    Args:
        found: One joint or more, with the limit to look at, or an empty text.
    """
    (first, _), *others = found
    more = f" and {len(others)} more" if others else ""
    related = (Related(joint.at(limit), f"joint '{joint.name}'") for joint, limit in others[:A_FEW])
    return f"'{first.name}'{more}", tuple(related)
