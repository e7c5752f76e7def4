"""Links as other formats have them: joints about any axis, fixed ones too; and what becomes of it.

In a robot description joints turn about z or slide along it, and no joint is fixed: link frames are
turned with their joints, and what is fixed to a link becomes a frame and a mass of it.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from kindsl.interchange.format import FormatError
from kindsl.interchange.robot_description import (
    DescribedFrame,
    DescribedLink,
    MassProperties,
    RobotDescription,
)
from kindsl.spatial.arrays import Array
from kindsl.spatial.inertia import move_inertia

LinkJoint = Literal["", "fixed", "revolute", "prismatic"]
BaseKind = Literal["fixed", "floating"]
IDENTITY = np.eye(4)
_GREATEST = 1e60


@dataclass(frozen=True, slots=True, eq=False)
class RigidLink:
    """A link with the joint that carries it.

    Attributes:
        name: The link's name.
        parent: Index of the parent among the links, less than its own; None for the root.
        joint: Name of the joint, empty for the root.
        joint_kind: Empty for the root.
        axis: Of a moving joint, in the joint's frame, shape (3,), not zero.
        parent_T_joint: The joint's frame in the parent's, shape (4, 4).
        joint_T_link: The link's frame in the joint's while it is at zero, shape (4, 4).
        mass_properties: In the link's frame, None where nothing is known.
        frames: Fixed to the link.
    """

    name: str
    parent: int | None = None
    joint: str = ""
    joint_kind: LinkJoint = ""
    axis: Array = field(default_factory=lambda: np.array([0.0, 0.0, 1.0]))
    parent_T_joint: Array = field(default_factory=lambda: IDENTITY)
    joint_T_link: Array = field(default_factory=lambda: IDENTITY)
    mass_properties: MassProperties | None = None
    frames: tuple[DescribedFrame, ...] = ()


@dataclass(slots=True, eq=False)
class _Body:
    """A link with all that is fixed to it, while it is put together."""

    link: RigidLink
    parent: int | None
    parent_T_joint: Array
    masses: list[MassProperties] = field(default_factory=list)
    frames: list[DescribedFrame] = field(default_factory=list)


def described(name: str, base: BaseKind, links: Sequence[RigidLink]) -> RobotDescription:
    """Return the robot whose links these are, each subtree together.

    Args:
        name: The robot's name.
        base: Whether the root is free to move.
        links: The root first, parents before children.

    Raises:
        FormatError: A number is not finite, or beyond all measure.
    """
    for link in links:
        _check_finite(link)
    bodies: list[_Body] = []
    placed: dict[int, tuple[int, Array]] = {}
    for index in _depth_first(links):
        link = links[index]
        if link.joint_kind == "fixed" and link.parent is not None:
            body, body_T_parent = placed[link.parent]
            body_T_link = body_T_parent @ link.parent_T_joint @ link.joint_T_link
            bodies[body].frames.append(DescribedFrame(link.name, body_T_link))
        else:
            body, body_T_link = len(bodies), _add_body(link, bodies, placed)
        placed[index] = body, body_T_link
        _attach(link, bodies[body], body_T_link)
    return RobotDescription(name, base == "floating", _with_own_names(bodies))


def fixed_remarks(links: Sequence[RigidLink], noun: str) -> Iterator[str]:
    """Yield what became of links that do not move by themselves, and which have no mass."""
    for index, link in enumerate(links):
        if link.joint_kind == "fixed":
            carrier = _carrier(links, index).name
            yield f"the {noun} '{link.name}', fixed to '{carrier}', became a frame of it"
    carriers = [_carrier(links, i).name for i, link in enumerate(links) if link.mass_properties]
    without = [link.name for link in links if _moves(link) and link.name not in carriers]
    for name in without:
        yield f"the {noun} '{name}' has no inertia"


def _check_finite(link: RigidLink) -> None:
    numbers = [link.axis, link.parent_T_joint, link.joint_T_link]
    numbers += [frame.link_T_frame for frame in link.frames]
    if link.mass_properties is not None:
        body = link.mass_properties
        numbers += [np.array([body.mass]), body.com, body.inertia]
    if not all((np.abs(array) < _GREATEST).all() for array in numbers):
        raise FormatError(f"'{link.name}' has a number that is not finite")


def _moves(link: RigidLink) -> bool:
    return link.joint_kind in ("revolute", "prismatic")


def _carrier(links: Sequence[RigidLink], index: int) -> RigidLink:
    while links[index].joint_kind == "fixed":
        index = links[index].parent or 0
    return links[index]


def _depth_first(links: Sequence[RigidLink]) -> Iterator[int]:
    below: dict[int, list[int]] = {}
    for index, link in enumerate(links):
        if link.parent is not None:
            below.setdefault(link.parent, []).append(index)
    pending = [0]
    while pending:
        index = pending.pop()
        yield index
        pending += reversed(below.get(index, []))


def _add_body(link: RigidLink, bodies: list[_Body], placed: dict[int, tuple[int, Array]]) -> Array:
    """Add the body of a link that moves, or of the root; return the link's frame in its own."""
    if link.parent is None:
        bodies.append(_Body(link, None, IDENTITY))
        return IDENTITY
    parent, body_T_parent = placed[link.parent]
    joint_T_body = IDENTITY.copy()
    joint_T_body[:3, :3] = z_to(link.axis)
    bodies.append(_Body(link, parent, body_T_parent @ link.parent_T_joint @ joint_T_body))
    return np.asarray(joint_T_body.T @ link.joint_T_link)


def z_to(axis: Array) -> Array:
    """Return a rotation that takes z to an axis, shape (3, 3); none if it is z already.

    It is the smallest one on z's side; on the other, one after a half turn about x, since the
    smallest is not defined near -z.
    """
    half_turn = np.diag([1.0, -1.0, -1.0] if axis[2] < 0.0 else [1.0, 1.0, 1.0])
    x, y, z = half_turn @ axis / float(np.linalg.norm(axis))
    k = 1.0 / (1.0 + z)
    smallest = [[1.0 - k * x * x, -k * x * y, x], [-k * x * y, 1.0 - k * y * y, y], [-x, -y, z]]
    return np.asarray(half_turn @ np.array(smallest))


def about_origin(mass: float, about_com: Array, link_T_inertial: Array) -> MassProperties:
    """Return mass properties in the link's frame.

    Args:
        mass: Kilograms.
        about_com: Tensor about the centre of mass along the inertial frame's axes, shape (3, 3).
        link_T_inertial: A frame whose origin is the centre of mass, shape (4, 4).
    """
    return _moved(MassProperties(mass, np.zeros(3), about_com), link_T_inertial)


def _moved(body: MassProperties, A_T_B: Array) -> MassProperties:
    R, r = A_T_B[:3, :3], A_T_B[:3, 3]
    com, inertia = move_inertia(np.asarray(body.mass), body.com, body.inertia, R, r)
    return MassProperties(body.mass, com, inertia)


def _attach(link: RigidLink, body: _Body, body_T_link: Array) -> None:
    if link.mass_properties is not None:
        body.masses.append(_moved(link.mass_properties, body_T_link))
    for frame in link.frames:
        body.frames.append(DescribedFrame(frame.name, body_T_link @ frame.link_T_frame))


def _with_own_names(bodies: Sequence[_Body]) -> tuple[DescribedLink, ...]:
    """Return the links; a frame whose name another frame has gets a number."""
    taken: set[str] = set()
    return tuple(_described(body, [_own(frame, taken) for frame in body.frames]) for body in bodies)


def _own(frame: DescribedFrame, taken: set[str]) -> DescribedFrame:
    name, number = frame.name, 2
    while name in taken:
        name, number = f"{frame.name}_{number}", number + 1
    taken.add(name)
    return DescribedFrame(name, frame.link_T_frame)


def _described(body: _Body, frames: list[DescribedFrame]) -> DescribedLink:
    return DescribedLink(
        body.link.name,
        _lumped(body.masses),
        tuple(frames),
        body.parent,
        body.link.joint,
        body.link.joint_kind,
        body.parent_T_joint,
    )


def _lumped(parts: list[MassProperties]) -> MassProperties | None:
    if not parts:
        return None
    if len(parts) == 1:
        return parts[0]
    mass = sum(part.mass for part in parts)
    moment = np.sum([part.mass * part.com for part in parts], axis=0)
    inertia = np.sum([part.inertia for part in parts], axis=0)
    return MassProperties(mass, moment / mass if mass else np.zeros(3), inertia)
