"""The declarations of a document, as written: links, joints, frames, inertia."""

from collections.abc import Iterator
from enum import StrEnum
from typing import NamedTuple, TypeAlias

from kindsl.language.semantics.expressions import Expression
from kindsl.language.semantics.places import Construct, Name, Place
from kindsl.language.syntax.tree import Island, Node
from kindsl.language.text.facts import Facts
from kindsl.mechanics.rigid.joint_kind import JointKind


class ValueKind(StrEnum):
    """The class of a value, which is the class of the parameters in it."""

    LENGTH = "length"
    ANGLE = "angle"
    DYNAMICS = "dynamics"


Components: TypeAlias = tuple[Expression, Expression, Expression]


class Vector(Construct):
    """Three components as written; their text is empty where the parser supplied them."""

    __slots__ = ("components",)

    def __init__(self, node: Node, island: Island, components: Components) -> None:
        self.node = node
        self.island = island
        self.components = components


class Pose(NamedTuple):
    """Translation in metres, then rotation: intrinsic x, y, z in radians. None where missing."""

    translation: Vector | None
    rotation: Vector | None


class Inertia(Construct):
    """The inertia section of a link.

    Attributes:
        mass: Kilograms.
        com: Centre of mass in metres.
        moments: Moments `Ix Iy Iz` and products `Ixy Ixz Iyz` by name, kg·m², the first of each.
        frame: The frame that centre of mass and moments are given in; the link frame if None.
    """

    __slots__ = ("com", "frame", "mass", "moments")

    def __init__(
        self,
        node: Node,
        island: Island,
        mass: Expression | None,
        com: Vector | None,
        moments: dict[str, Expression],
        frame: Name | None,
    ) -> None:
        self.node = node
        self.island = island
        self.mass = mass
        self.com = com
        self.moments = moments
        self.frame = frame


class Child(NamedTuple):
    """`link via joint`, with the names that stand there."""

    link: Name
    joint: Name

    @property
    def island(self) -> Island:
        """The island it lies in."""
        return self.link.island

    @property
    def start(self) -> int:
        """Start of the link's name."""
        return self.link.start

    @property
    def end(self) -> int:
        """End of the joint's name."""
        return self.joint.end


class Frame(Construct):
    """An optional frame, given with respect to its link's frame. `link` is the link's name."""

    __slots__ = ("link", "name", "pose")

    def __init__(self, node: Node, island: Island, name: Name, link: str, pose: Pose) -> None:
        self.node = node
        self.island = island
        self.name = name
        self.link = link
        self.pose = pose


class Link(Construct):
    """A link, or the robot's base.

    Attributes:
        name: Its name, empty where it is missing.
        id: Its number as written (0 for the base), None where missing or no number.
        id_place: Where the number stands.
        inertia: The first inertia section.
        children: Pairs of link and joint name.
        frames: Its optional frames.
        is_base: Whether it is the `RobotBase`.
        is_floating: Whether it is a floating base.
        facts: What later layers derived from it.
    """

    __slots__ = (
        "children", "facts", "frames", "id", "id_place", "inertia", "is_base", "is_floating",
        "name",
    )  # fmt: skip

    def __init__(self, node: Node, island: Island, name: Name) -> None:
        self.node = node
        self.island = island
        self.name = name
        self.id: int | None = None
        self.id_place: Place | None = None
        self.inertia: Inertia | None = None
        self.children: tuple[Child, ...] = ()
        self.frames: tuple[Frame, ...] = ()
        self.is_base = False
        self.is_floating = False
        self.facts = Facts()

    def __repr__(self) -> str:
        return f"Link({str(self.name)!r}, id={self.id})"


class Joint(Construct):
    """A joint with its frame, given with respect to the predecessor's link frame.

    Attributes:
        name: Its name, empty where it is missing.
        kind: `"revolute"` or `"prismatic"`.
        id: Its optional, obsolete number.
        id_place: Where the number stands.
        pose: The joint frame.
    """

    __slots__ = ("id", "id_place", "kind", "name", "pose")

    def __init__(self, node: Node, island: Island, name: Name, kind: JointKind) -> None:
        self.node = node
        self.island = island
        self.name = name
        self.kind: JointKind = kind
        self.id: int | None = None
        self.id_place: Place | None = None
        self.pose = Pose(None, None)

    def __repr__(self) -> str:
        return f"Joint({str(self.name)!r}, {self.kind})"


class Declarations(NamedTuple):
    """The declarations of one island."""

    robot: Name | None
    bases: tuple[Link, ...]
    links: tuple[Link, ...]
    joints: tuple[Joint, ...]

    def bodies(self) -> Iterator[Link]:
        """Yield the bases, then the links."""
        yield from self.bases
        yield from self.links


def pose_values(pose: Pose) -> Iterator[tuple[Expression, ValueKind]]:
    """Yield the values of a pose with their class."""
    for vector, kind in ((pose.translation, ValueKind.LENGTH), (pose.rotation, ValueKind.ANGLE)):
        if vector is not None:
            for component in vector.components:
                yield component, kind


def inertia_values(inertia: Inertia) -> Iterator[Expression]:
    """Yield mass, centre of mass and moments."""
    if inertia.mass is not None:
        yield inertia.mass
    if inertia.com is not None:
        yield from inertia.com.components
    yield from inertia.moments.values()


def link_values(link: Link) -> Iterator[tuple[Expression, ValueKind]]:
    """Yield all values in a link with their class."""
    if link.inertia is not None:
        for value in inertia_values(link.inertia):
            yield value, ValueKind.DYNAMICS
    for frame in link.frames:
        yield from pose_values(frame.pose)
