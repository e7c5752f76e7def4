"""A mechanism in plain floats: names, parents, poses, masses. What pictures need, without NumPy."""

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from math import isfinite
from typing import NamedTuple, Protocol

from kindsl.language.semantics.declarations import Frame, Joint, Link
from kindsl.language.semantics.kinematic_tree import Edge
from kindsl.language.semantics.model import Model
from kindsl.mechanics.rigid.body import MassDistribution
from kindsl.mechanics.rigid.pose import IDENTITY, RigidPose
from kindsl.mechanics.rigid.topology import Topology, check_topology
from kindsl.robots.mechanism.numbering import require_base


class AttachedFrame(NamedTuple):
    """A named frame fixed to a body.

    Attributes:
        name: Its name, unique among the links and frames.
        body: Index of the body that carries it, 0 for the base.
        pose: The frame in the body's frame.
    """

    name: str
    body: int
    pose: RigidPose


@dataclass(frozen=True, slots=True)
class Skeleton(Topology):
    """A tree of rigid bodies; names of bodies and frames are unique together.

    Attributes:
        placements: Joint frames in their predecessors' frames, n of them.
        masses: Of the base and the links, about the bodies' origins and axes, n + 1 of them.
        is_floating: Whether the base floats; if not, its inertia does not matter.
        frames: Further named frames.

    Raises:
        ValueError: On construction, if there is no link, numbering or names are not as above, or a
            value is not finite.
    """

    placements: tuple[RigidPose, ...]
    masses: tuple[MassDistribution, ...]
    is_floating: bool
    frames: tuple[AttachedFrame, ...] = ()

    def __post_init__(self) -> None:
        check_topology(self, (frame.name for frame in self.frames))
        for name, pose in zip(self.joint_names, self.placements, strict=True):
            _check_finite(f"pose of joint '{name}'", pose.numbers)
        for frame in self.frames:
            _check_finite(f"pose of frame '{frame.name}'", frame.pose.numbers)
        for name, body in zip(self.body_names, self.masses, strict=True):
            _check_finite(f"inertia of '{name}'", (body.mass, *body.com, *body.moments))

    def zero_poses(self) -> list[RigidPose]:
        """Return the poses of the bodies in the base's frame at zero."""
        poses = [IDENTITY]
        for parent, placement in zip(self.parents, self.placements, strict=True):
            poses.append(poses[parent].then(placement))
        return poses


class Reader(Protocol):
    """The way from written values to numbers: strict, or as far as known."""

    def joint_pose(self, joint: Joint) -> RigidPose:
        """Return a joint's frame in its predecessor's."""

    def frame_pose(self, frame: Frame) -> RigidPose:
        """Return an optional frame in its link's."""

    def body(self, link: Link) -> MassDistribution:
        """Return a link's mass distribution about its frame."""


def skeleton_of(model: Model, edges: Sequence[Edge], reader: Reader) -> Skeleton:
    """Return the numbered bodies.

    Args:
        model: The document's model.
        edges: The supporting edge of each link, in the order of the bodies 1 to n.
        reader: Makes numbers of what is written.

    Raises:
        ValueError: A name stands for two things, a value is infinite, there is no link; besides,
            what the reader raises.
    """
    base = require_base(model)
    links = [edge.link for edge in edges if edge.link is not None]
    joints = [edge.joint for edge in edges if edge.joint is not None]
    index = {body: i for i, body in enumerate([base, *links])}
    return Skeleton(
        str(base.name),
        tuple(str(link.name) for link in links),
        tuple(str(joint.name) for joint in joints),
        tuple(joint.kind for joint in joints),
        tuple(index[edge.predecessor] for edge in edges),
        tuple(reader.joint_pose(joint) for joint in joints),
        tuple(reader.body(body) for body in index),
        base.is_floating,
        tuple(
            AttachedFrame(name, index[body], reader.frame_pose(frame))
            for name, body, frame in named_frames(index)
        ),
    )


def named_frames(bodies: Collection[Link]) -> Iterator[tuple[str, Link, Frame]]:
    """Yield the optional frames of bodies by the names under which they are drawn.

    One whose name is taken is called `link.frame`; one without a name is left out.
    """
    taken = {str(body.name) for body in bodies}
    for body in bodies:
        for frame in body.frames:
            name = str(frame.name) if frame.name not in taken else f"{body.name}.{frame.name}"
            if name and name not in taken:
                taken.add(name)
                yield name, body, frame


def _check_finite(quantity: str, numbers: Sequence[float]) -> None:
    if not all(map(isfinite, numbers)):
        raise ValueError(f"{quantity} holds a value that is not finite")
