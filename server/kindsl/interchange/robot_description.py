"""A robot as plain numbers and names, between URDF and the Kinematics-DSL."""

from dataclasses import dataclass

from kindsl.spatial.arrays import Array


@dataclass(frozen=True, slots=True, eq=False)
class MassProperties:
    """Mass properties of a body in its link frame.

    Attributes:
        mass: Kilograms.
        com: Centre of mass, shape (3,), metres.
        inertia: Tensor about the link frame's origin and axes, shape (3, 3), kg m^2.
    """

    mass: float
    com: Array
    inertia: Array


@dataclass(frozen=True, slots=True, eq=False)
class DescribedFrame:
    """A frame fixed to a link: `link_T_frame`, shape (4, 4)."""

    name: str
    link_T_frame: Array


@dataclass(frozen=True, slots=True, eq=False)
class DescribedLink:
    """A body with the joint that supports it.

    Attributes:
        name: The link's name.
        mass_properties: None where nothing is known.
        frames: Frames fixed to it.
        parent: Index of the parent in the description, None for the base.
        joint: Name of the supporting joint, empty for the base.
        joint_kind: `"revolute"` or `"prismatic"`, about or along the joint frame's z.
        parent_T_joint: The joint frame in the parent's link frame, shape (4, 4).
    """

    name: str
    mass_properties: MassProperties | None
    frames: tuple[DescribedFrame, ...]
    parent: int | None
    joint: str
    joint_kind: str
    parent_T_joint: Array


@dataclass(frozen=True, slots=True, eq=False)
class RobotDescription:
    """A tree of links, the base first, parents before children."""

    name: str
    is_floating: bool
    links: tuple[DescribedLink, ...]
