"""A robot as plain numbers and names, between another format and the Kinematics-DSL."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from math import dist
from typing import NamedTuple

from kindsl.mechanics.rigid.body import MassDistribution
from kindsl.mechanics.rigid.pose import IDENTITY, RigidPose

_ROUNDING = 1e-14


def is_in_place(pose: RigidPose) -> bool:
    """Return whether a frame is the one that its pose is given in."""
    return dist(pose.numbers, IDENTITY.numbers) < _ROUNDING


@dataclass(frozen=True, slots=True)
class DescribedFrame:
    """A frame fixed to a link: `link_T_frame` is its pose in the link's."""

    name: str
    link_T_frame: RigidPose

    @property
    def is_of_link(self) -> bool:
        """True if it is the link's own frame, for which nobody needs another name."""
        return is_in_place(self.link_T_frame)


class DescribedPart(NamedTuple):
    """A link of the other format that is part of a body.

    Attributes:
        name: The link's name.
        body_T_link: Its frame in the body's.
        body: Its mass distribution in the body's frame, None where nothing is known.
    """

    name: str
    body_T_link: RigidPose
    body: MassDistribution | None


@dataclass(frozen=True, slots=True)
class DescribedLink:
    """A body with the joint that supports it.

    Attributes:
        name: The link's name.
        body: Its mass distribution in the link's frame, None where nothing is known.
        frames: Frames fixed to it.
        parent: Index of the parent in the description, None for the base.
        joint: Name of the supporting joint, empty for the base.
        joint_kind: `"revolute"` or `"prismatic"`, about or along the joint frame's z.
        parent_T_joint: The joint frame in the parent's link frame.
        parts: The links that the body is made of.
        parent_T_origin: What the joint's pose is written in, in the parent's link frame.
        written_T_joint: The joint frame in the frame that is written.
    """

    name: str
    body: MassDistribution | None
    frames: tuple[DescribedFrame, ...]
    parent: int | None
    joint: str
    joint_kind: str
    parent_T_joint: RigidPose
    parts: tuple[DescribedPart, ...] = ()
    parent_T_origin: RigidPose = IDENTITY
    written_T_joint: RigidPose = IDENTITY


@dataclass(frozen=True, slots=True)
class RobotDescription:
    """A tree of links, the base first, parents before children.

    Attributes:
        name: The robot's name.
        is_floating: Whether the base floats.
        links: The links.
        comments: Lines of text on the robot (without a name), on links and joints, by `"robot"`,
            `"link"` or `"joint"` and the name.
    """

    name: str
    is_floating: bool
    links: tuple[DescribedLink, ...]
    comments: Mapping[tuple[str, str], tuple[str, ...]] = field(default_factory=dict)
