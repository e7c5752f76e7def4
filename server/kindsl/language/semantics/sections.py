"""Generated from grammar/kindsl.lark by `make tables`; do not edit."""

# ruff: noqa
# fmt: off
from typing import NamedTuple

from kindsl.language.semantics.blocks import Block, PoseBlock, Vector
from kindsl.language.semantics.expressions import Expression
from kindsl.language.semantics.places import Name, Place
from kindsl.language.syntax.tree import Island


class Child(NamedTuple):
    """A `child`: the names that stand there."""

    link: Name
    joint: Name

    @property
    def island(self) -> Island:
        """The island it lies in."""
        return self[0].island

    @property
    def start(self) -> int:
        """Start of its first name."""
        return self[0].start

    @property
    def end(self) -> int:
        """End of its last name."""
        return self[-1].end


class Frame(PoseBlock):
    """The sections of `frame`, the first of each."""

    __slots__ = ()

    @property
    def link(self) -> str:
        """The name of the link that it belongs to."""
        return self.owner


class JointFrame(PoseBlock):
    """The sections of `ref_frame`, the first of each."""

    __slots__ = ()


class Inertia(Block):
    """The sections of `inertia_params` or `inertia_properties`, the first of each.

    Attributes:
        mass: `mass`, kg.
        com: `CoM`, m.
        moments: `Ix`, `Iy`, `Iz`, `Ixy`, `Ixz`, `Iyz`, kg·m².
        frame: `ref_frame`.
    """

    __slots__ = ('com', 'frame', 'mass', 'moments')
    attributes = {'mass': 'mass', 'com': 'com', 'moment': 'moments', 'inertia_frame': 'frame'}
    mass: Expression | None
    com: Vector | None
    moments: dict[str, Expression]
    frame: Name | None


class LinkSections(Block):
    """The sections of `RobotBase` or `link`, the first of each.

    Attributes:
        id: `id`.
        inertia: `inertia_params`, `inertia_properties`.
        children: `children`.
        frames: `frames`.
    """

    __slots__ = ('children', 'frames', 'id', 'id_place', 'inertia')
    attributes = {'id': 'id', 'inertia': 'inertia', 'children': 'children', 'frames': 'frames'}
    id: int | None
    id_place: Place | None
    inertia: Inertia | None
    children: tuple[Child, ...]
    frames: tuple[Frame, ...]


class JointSections(Block):
    """The sections of `r_joint` or `p_joint`, the first of each.

    Attributes:
        id: `id`.
        frame: `ref_frame`.
    """

    __slots__ = ('frame', 'id', 'id_place')
    attributes = {'id': 'id', 'joint_frame': 'frame'}
    id: int | None
    id_place: Place | None
    frame: JointFrame | None


ROWS = {'child': Child}


BLOCKS = {'frame': Frame, 'joint_frame': JointFrame, 'inertia': Inertia}
