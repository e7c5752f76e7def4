"""Links as other formats have them: joints about any axis, fixed ones too; and what becomes of it.

In a linkage joints turn about z or slide along it, and no joint is fixed: link frames are
turned with their joints, and what is fixed to a link becomes a frame and a mass of it.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Literal

from kindsl.language.text.groups import grouped
from kindsl.mechanics.rigid.body import MassDistribution, seen_from
from kindsl.mechanics.rigid.joint_kind import JointKind
from kindsl.mechanics.rigid.pose import IDENTITY, ORIGIN, RigidPose, Vector3, rotation_from_z
from kindsl.robots.interchange.format import FormatError
from kindsl.robots.interchange.xml_reading import LinkJoint
from kindsl.robots.mechanism.linkage import BodyPart, Linkage, RigidBody

BaseKind = Literal["fixed", "floating"]
_GREATEST = 1e60


@dataclass(frozen=True, slots=True)
class RigidLink:
    """A link with the joint that carries it.

    Attributes:
        name: The link's name.
        parent: Index of the parent among the links, less than its own; None for the root.
        joint: Name of the joint, empty for the root.
        joint_kind: Empty for the root.
        axis: Of a moving joint, in the joint's frame, not zero.
        parent_T_joint: The joint's frame in the parent's; the root's frame in the world's.
        joint_T_link: The link's frame in the joint's while it is at zero.
        parent_T_origin: What the joint's pose is written in, in the parent's frame.
        written_T_joint: The joint's frame in the one that is written.
        body: In the link's frame, None where nothing is known.
        frames: Names and poses of frames fixed to the link.
    """

    name: str
    parent: int | None = None
    joint: str = ""
    joint_kind: LinkJoint = ""
    axis: Vector3 = (0.0, 0.0, 1.0)
    parent_T_joint: RigidPose = IDENTITY
    joint_T_link: RigidPose = IDENTITY
    parent_T_origin: RigidPose = IDENTITY
    written_T_joint: RigidPose = IDENTITY
    body: MassDistribution | None = None
    frames: tuple[tuple[str, RigidPose], ...] = ()


def robot_of_links(
    name: str, base: BaseKind, links: Sequence[RigidLink], noun: str = "link"
) -> tuple[Linkage, tuple[str, ...]]:
    """Return the robot whose links these are, and notes on links and frames that are none there.

    Args:
        name: The robot's name.
        base: Whether the root is free to move.
        links: As `linkage_of_links` takes them.
        noun: What the format calls a link.

    Raises:
        FormatError: A number is not finite, or beyond all measure.
    """
    robot = linkage_of_links(name, base, links)
    return robot, (*_root_remarks(links[0], base), *_fixed_remarks(links, noun, robot))


def linkage_of_links(name: str, base: BaseKind, links: Sequence[RigidLink]) -> Linkage:
    """Return the robot whose links these are, each subtree together.

    A fixed base has the world's frame, in which gravity is along -z, wherever the root's frame is;
    a floating one has the root's.

    Args:
        name: The robot's name.
        base: Whether the root is free to move.
        links: The root first, parents before children.

    Raises:
        FormatError: A number is not finite, or beyond all measure.
    """
    for link in links:
        _check_finite(link)
    bodies: list[RigidBody] = []
    parts: list[list[BodyPart]] = []
    placed: dict[int, tuple[int, RigidPose]] = {}
    for index in _depth_first(links):
        link = links[index]
        if link.joint_kind == "fixed" and link.parent is not None:
            body, body_T_parent = placed[link.parent]
            body_T_link = body_T_parent.then(link.parent_T_joint).then(link.joint_T_link)
        else:
            body, (made, body_T_link) = len(bodies), _body_of(link, base, placed)
            bodies.append(made)
            parts.append([])
        placed[index] = body, body_T_link
        mass = None if link.body is None else seen_from(link.body, body_T_link)
        frames = (BodyPart(n, body_T_link.then(pose), is_link=False) for n, pose in link.frames)
        parts[body] += (BodyPart(link.name, body_T_link, mass), *frames)
    made_of = zip(bodies, parts, strict=True)
    whole = (body._replace(parts=tuple(its)) for body, its in made_of)
    return Linkage(tuple(whole), base == "floating", name)


def _fixed_remarks(links: Sequence[RigidLink], noun: str, robot: Linkage) -> Iterator[str]:
    """Yield what became of links that do not move by themselves, and which have no mass."""
    parts = (part for body in robot.bodies for part in body.parts)
    merged = {part.name for part in parts if part.is_link and part.is_in_place}
    carriers: list[int] = []
    for index, link in enumerate(links):
        is_fixed = link.joint_kind == "fixed" and link.parent is not None
        carriers.append(carriers[link.parent or 0] if is_fixed else index)
        if is_fixed:
            carrier = links[carriers[index]].name
            became = "merged with it" if link.name in merged else "became a frame of it"
            yield f"the {noun} '{link.name}', fixed to '{carrier}', {became}"
    heavy = {carriers[index] for index, link in enumerate(links) if link.body is not None}
    for index, link in enumerate(links):
        if link.joint_kind in ("revolute", "prismatic") and index not in heavy:
            yield f"the {noun} '{link.name}' has no inertia"


def _root_remarks(root: RigidLink, base: BaseKind) -> Iterator[str]:
    """Yield what became of the root's pose in the world."""
    pose = root.parent_T_joint
    if base == "fixed" and pose != IDENTITY:
        yield f"the frame of the fixed base '{root.name}' is now the world's"
    elif base == "floating" and pose.rotation != IDENTITY.rotation:
        yield f"the initial orientation of the floating base '{root.name}' dropped"


def _check_finite(link: RigidLink) -> None:
    poses = [link.parent_T_joint, link.joint_T_link, *(pose for _, pose in link.frames)]
    numbers = [*link.axis, *(number for pose in poses for number in pose.numbers)]
    if link.body is not None:
        numbers += link.body.numbers
    if not all(abs(number) < _GREATEST for number in numbers):
        raise FormatError(f"'{link.name}' has a number that is not finite")


def _depth_first(links: Sequence[RigidLink]) -> Iterator[int]:
    below = grouped((link.parent, index) for index, link in enumerate(links))
    pending = [0]
    while pending:
        index = pending.pop()
        yield index
        pending += reversed(below.get(index, []))


def _body_of(
    link: RigidLink, base: BaseKind, placed: dict[int, tuple[int, RigidPose]]
) -> tuple[RigidBody, RigidPose]:
    """Return the body of a link that moves, or of the root; and the link's frame in its own."""
    if link.parent is None:
        return RigidBody(()), link.parent_T_joint if base == "fixed" else IDENTITY
    parent, body_T_parent = placed[link.parent]
    joint_T_body = RigidPose(rotation_from_z(link.axis), ORIGIN)
    pose = body_T_parent.then(link.parent_T_joint).then(joint_T_body)
    origin, written = body_T_parent.then(link.parent_T_origin), link.written_T_joint
    kind: JointKind = "prismatic" if link.joint_kind == "prismatic" else "revolute"
    body = RigidBody((), parent, link.joint, kind, pose, origin, written.then(joint_T_body))
    return body, joint_T_body.inverse().then(link.joint_T_link)


def about_origin(
    mass: float, tensor: Iterable[float], link_T_inertial: RigidPose
) -> MassDistribution:
    """Return mass and inertia in the link's frame.

    Args:
        mass: Kilograms.
        tensor: `xx yy zz xy xz yz` of the inertia tensor about the centre of mass, along the
            inertial frame's axes.
        link_T_inertial: A frame whose origin is the centre of mass.
    """
    xx, yy, zz, xy, xz, yz = tensor
    moments = (xx, yy, zz, 0.0 - xy, 0.0 - xz, 0.0 - yz)
    return seen_from(MassDistribution(mass, ORIGIN, moments), link_T_inertial)
