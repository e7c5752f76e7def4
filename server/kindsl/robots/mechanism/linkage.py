"""A robot in plain numbers: bodies, each made of parts that are fixed together, on joints."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from math import cos, dist, isfinite, sin
from typing import NamedTuple

from kindsl.mechanics.rigid.body import NO_BODY, MassDistribution, lumped, seen_from
from kindsl.mechanics.rigid.joint_kind import JointKind
from kindsl.mechanics.rigid.pose import IDENTITY, ORIGIN, Z_AXIS, RigidPose
from kindsl.mechanics.rigid.topology import Topology, check_topology

_ROUNDING = 1e-14
_GREATEST = 1e100  # so that no product of three overflows


class BodyPart(NamedTuple):
    """A link, or a frame, that is fixed to a body.

    Attributes:
        pose: Its frame in the body's.
        mass: Its mass distribution in the body's frame, None where nothing is known.
        is_link: Whether it is a link of its file, else a frame.
    """

    name: str
    pose: RigidPose = IDENTITY
    mass: MassDistribution | None = None
    is_link: bool = True

    def seen_from(self, pose: RigidPose) -> "BodyPart":
        """Return the same part of a body whose frame is at a pose in another frame, in that."""
        mass = None if self.mass is None else seen_from(self.mass, pose)
        return self._replace(pose=pose.then(self.pose), mass=mass)

    @property
    def is_in_place(self) -> bool:
        """True if its frame is the body's."""
        return dist(self.pose.numbers, IDENTITY.numbers) < _ROUNDING


class RigidBody(NamedTuple):
    """A body and the joint that supports it.

    Attributes:
        parts: What it is made of: the link that names it first, then what is fixed to that.
        parent: Index of its predecessor, less than its own; None for the base.
        joint: Name of the supporting joint, empty for the base.
        kind: `"revolute"` (turns about the joint frame's z) or `"prismatic"` (slides along it).
        placement: The joint frame in the predecessor's frame.
        origin: What the joint's pose is written relative to, in the predecessor's frame.
        written_T_joint: The joint frame in the frame that is written.
    """

    parts: tuple[BodyPart, ...]
    parent: int | None = None
    joint: str = ""
    kind: JointKind = "revolute"
    placement: RigidPose = IDENTITY
    origin: RigidPose = IDENTITY
    written_T_joint: RigidPose = IDENTITY

    @property
    def name(self) -> str:
        """The name of its first link."""
        return self.parts[0].name

    @property
    def mass(self) -> MassDistribution | None:
        """The mass distribution of all parts together, None where nothing is known of any."""
        known = [part.mass for part in self.parts if part.mass is not None]
        return lumped(known) if known else None

    @property
    def frames(self) -> tuple[BodyPart, ...]:
        """The parts besides its first link: all are frames of it."""
        return self.parts[1:]

    @property
    def frames_elsewhere(self) -> list[BodyPart]:
        """The frames that are not the body's own, for which nobody needs another name."""
        return [frame for frame in self.frames if not frame.is_in_place]

    def weighing(self, mass: MassDistribution | None) -> "RigidBody":
        """Return the same body with another mass distribution, assigned to its first link."""
        first, *others = self.parts
        parts = (first._replace(mass=mass), *(part._replace(mass=None) for part in others))
        return self._replace(parts=parts)


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


@dataclass(frozen=True)
class Linkage:
    """A tree of bodies, the base first, parents before children.

    Link i and its supporting joint have the index i - 1 in what has a length of n.

    Attributes:
        bodies: The base and the n links.
        is_floating: Whether the base floats; if not, its mass does not matter.
        name: The robot's name.
    """

    bodies: tuple[RigidBody, ...]
    is_floating: bool = False
    name: str = ""

    @property
    def base_name(self) -> str:
        """The base's name."""
        return self.bodies[0].name

    @property
    def n_links(self) -> int:
        """Number of moving links, which is also the number of joints."""
        return len(self.bodies) - 1

    @cached_property
    def body_names(self) -> tuple[str, ...]:
        """The base's name and the links'."""
        return tuple(body.name for body in self.bodies)

    @property
    def link_names(self) -> tuple[str, ...]:
        """Names of the n links."""
        return self.body_names[1:]

    @cached_property
    def joint_names(self) -> tuple[str, ...]:
        """Names of the n supporting joints."""
        return tuple(body.joint for body in self.bodies[1:])

    @cached_property
    def joint_kinds(self) -> tuple[JointKind, ...]:
        """Kinds of the n joints."""
        return tuple(body.kind for body in self.bodies[1:])

    @cached_property
    def parents(self) -> tuple[int, ...]:
        """RigidBody index of each link's parent, less than the link's own."""
        return tuple(body.parent or 0 for body in self.bodies[1:])

    @cached_property
    def placements(self) -> tuple[RigidPose, ...]:
        """Joint frames in their predecessors' frames, n of them."""
        return tuple(body.placement for body in self.bodies[1:])

    @cached_property
    def masses(self) -> tuple[MassDistribution, ...]:
        """Mass distributions of all bodies in their frames; nothing where nothing is known."""
        return tuple(body.mass or NO_BODY for body in self.bodies)

    @cached_property
    def frames(self) -> tuple[AttachedFrame, ...]:
        """The frames of all bodies; one whose name is taken is left out, a body's own first."""
        taken = set(self.body_names)
        elsewhere = {part.name for body in self.bodies for part in body.frames_elsewhere}
        found = []
        for index, body in enumerate(self.bodies):
            for part in body.frames:
                is_other = part.is_in_place and part.name in elsewhere
                if part.name not in taken and not is_other:
                    taken.add(part.name)
                    found.append(AttachedFrame(part.name, index, part.pose))
        return tuple(found)

    def links(self) -> Iterator[tuple[int, int]]:
        """Yield each link's body index and its parent's, parents first."""
        return enumerate(self.parents, start=1)

    @cached_property
    def zero_poses(self) -> tuple[RigidPose, ...]:
        """The poses of the bodies in the base's frame at zero."""
        poses = [IDENTITY]
        for parent, placement in zip(self.parents, self.placements, strict=True):
            poses.append(poses[parent].then(placement))
        return tuple(poses)

    def with_placements(self, placements: Iterable[RigidPose]) -> "Linkage":
        """Return the same robot with its joints elsewhere."""
        pairs = zip(self.bodies[1:], placements, strict=True)
        moved = (body._replace(placement=placement) for body, placement in pairs)
        return replace(self, bodies=(self.bodies[0], *moved))

    def with_frames(self, poses: Mapping[str, RigidPose]) -> "Linkage":
        """Return the same robot with frames elsewhere in their bodies, by name."""
        moved = (
            body._replace(
                parts=tuple(p._replace(pose=poses.get(p.name, p.pose)) for p in body.parts)
            )
            for body in self.bodies
        )
        return replace(self, bodies=tuple(moved))

    def with_masses(self, masses: Iterable[MassDistribution | None]) -> "Linkage":
        """Return the same robot with other masses of all its bodies."""
        pairs = zip(self.bodies, masses, strict=True)
        return replace(self, bodies=tuple(body.weighing(mass) for body, mass in pairs))

    @property
    def base_mass_counts(self) -> bool:
        """True if the base's mass matters: it floats, or is all there is."""
        return self.is_floating or not self.n_links

    def without_mass_at_rest(self) -> "Linkage":
        """Return the same robot with nothing known of a fixed base's mass, which has no effect."""
        if self.base_mass_counts or self.bodies[0].mass is None:
            return self
        return replace(self, bodies=(self.bodies[0].weighing(None), *self.bodies[1:]))

    def moved_to(self, q: Sequence[float]) -> "Linkage":
        """Return the robot whose zero is a configuration of this one.

        Args:
            q: Joint positions in the order of the links, radians and metres.
        """
        motions = map(motion, self.joint_kinds, q)
        return self.with_placements(map(RigidPose.then, self.placements, motions))


def checked(linkage: Linkage) -> Linkage:
    """Return a robot whose numbers are usable, and whose names of bodies and joints are unique.

    Raises:
        ValueError: They are not, or a parent is not before its link.
    """
    check_topology(
        Topology(
            linkage.base_name,
            linkage.link_names,
            linkage.joint_names,
            linkage.joint_kinds,
            linkage.parents,
        ),
        (frame.name for frame in linkage.frames),
    )
    numbers = {
        **{
            f"inertia of '{body.name}'": mass.numbers
            for body, mass in zip(linkage.bodies, linkage.masses, strict=True)
        },
        **{f"pose of joint '{body.joint}'": body.placement.numbers for body in linkage.bodies[1:]},
        **{f"pose of frame '{frame.name}'": frame.pose.numbers for frame in linkage.frames},
    }
    for quantity, found in numbers.items():
        if not all(abs(number) < _GREATEST for number in found):
            what = "beyond 1e100" if all(map(isfinite, found)) else "not finite"
            raise ValueError(f"{quantity} holds a value that is {what}")
    return linkage


def motion(kind: JointKind, value: float) -> RigidPose:
    """Return the pose of a joint's moving side in its fixed one: about z, or along it."""
    if kind == "prismatic":
        return RigidPose(IDENTITY.rotation, (0.0, 0.0, value))
    c, s = cos(value), sin(value)
    return RigidPose(((c, -s, 0.0), (s, c, 0.0), Z_AXIS), ORIGIN)
