"""URDF to a robot description."""

import re
from collections.abc import Iterator
from functools import partial
from typing import Any

from kindsl.language.semantics.parameters import JointProperties
from kindsl.language.text.phrases import counted
from kindsl.mechanics.rigid.body import MassDistribution, Symmetric
from kindsl.mechanics.rigid.pose import (
    IDENTITY,
    RigidPose,
    Vector3,
    meant_angle,
    pose_from_fixed_axes,
)
from kindsl.robots.interchange.format import (
    AS_WRITTEN,
    FormatError,
    ReadingChoices,
    ReadRobot,
    mimic_dropped,
    told_joints,
)
from kindsl.robots.interchange.rigid_links import BaseKind, RigidLink, about_origin, robot_of_links
from kindsl.robots.interchange.urdf.checking import (
    WORLD,
    checked,
    end_of,
    numbers_of,
    rotation_of,
)
from kindsl.robots.interchange.urdf.commenting import comments_of
from kindsl.robots.interchange.urdf.numbers import numbers_of_urdf
from kindsl.robots.interchange.xml_terms import JOINT_KINDS, TENSOR, drawings_dropped
from kindsl.robots.mechanism.linkage import Linkage

_OF_LEGS = re.compile(r"(?<![a-z])(foot|feet|leg|ankle|knee|thigh|calf|shank|toe)(?![a-z])", re.I)
_USUAL_AXIS = (1.0, 0.0, 0.0)
_ELSEWHERE = (("transmission", "transmission"), ("gazebo", "Gazebo extension"))


def robot_of_urdf(text: bytes | str, name: str, choices: ReadingChoices = AS_WRITTEN) -> ReadRobot:
    """Return the robot of a URDF's text.

    Args:
        text: As in the file. Meshes are not read.
        name: The name of a robot without one.
        choices: Whether the root link floats.

    Raises:
        FormatError: The text is unreadable or beyond the Kinematics-DSL.
    """
    robot, floating = checked(text), choices.floating
    joints = robot.findall("joint")
    children: dict[str, list[Any]] = {}
    for joint in joints:
        children.setdefault(end_of(joint, "parent"), []).append(joint)
    bodies = {str(link.get("name")): _body(link) for link in robot.findall("link")}
    carried = {end_of(joint, "child") for joint in joints}
    root = next(link for link in bodies if link not in carried)
    first = RigidLink(root, body=bodies[root])
    lost: tuple[str, ...] = ()
    tells_base = root == WORLD
    below = children.get(root, [])
    if len(below) == 1 and below[0].get("type") == "floating":
        first, floating = _floating(below[0], bodies), True
        lost, tells_base = (f"the link '{root}', which does not move, dropped",), True
    links = _links(first, children, bodies)
    base: BaseKind = "floating" if floating else "fixed"
    read, moved = robot_of_links(robot.get("name") or name, base, links, "URDF")
    legs = _legged_remarks(read) if base == "fixed" and root != WORLD else ()
    remarks = (*_remarks(robot), *lost, *legs, *moved)
    moving = (joint for joint in joints if joint.get("type") not in ("fixed", "floating"))
    told = told_joints((str(joint.get("name")), _properties(joint)) for joint in moving)
    numbers = partial(numbers_of_urdf, text)
    return ReadRobot(read, remarks, told, tells_base, dict(comments_of(robot)), numbers)


def _legged_remarks(robot: Linkage) -> Iterator[str]:
    """Yield that a robot may float: one with legs, whose base weighs something."""
    mass = robot.bodies[0].mass
    names = (*robot.body_names, *robot.joint_names)
    if mass is not None and mass.mass and any(map(_OF_LEGS.search, names)):
        base = f"the base '{robot.base_name}' is fixed, and its mass without effect"
        yield f"{base}: for a robot on legs, use --floating-base"


def _properties(joint: Any) -> JointProperties:
    limit, dynamics = joint.find("limit"), joint.find("dynamics")
    is_limited = joint.get("type") != "continuous"
    return JointProperties(
        _number(limit, "lower") if is_limited else None,
        _number(limit, "upper") if is_limited else None,
        _number(limit, "effort"),
        _number(limit, "velocity"),
        damping=_number(dynamics, "damping"),
        friction=_number(dynamics, "friction"),
    )


def _number(element: Any, name: str) -> float | None:
    if element is None or element.get(name) is None:
        return None
    return numbers_of(element, name, 1)[0]


def _floating(joint: Any, bodies: dict[str, MassDistribution | None]) -> RigidLink:
    name = end_of(joint, "child")
    return RigidLink(name, parent_T_joint=pose_of_origin(joint.find("origin")), body=bodies[name])


def _links(
    first: RigidLink, children: dict[str, list[Any]], bodies: dict[str, MassDistribution | None]
) -> list[RigidLink]:
    links = [first]
    for index, link in enumerate(links):
        links += [_carried(joint, index, bodies) for joint in children.get(link.name, [])]
    return links


def _carried(joint: Any, parent: int, bodies: dict[str, MassDistribution | None]) -> RigidLink:
    name, kind = str(joint.get("name")), joint.get("type")
    if kind not in JOINT_KINDS:
        raise FormatError(f"the joint '{name}' is {kind}, which the language does not support")
    child = end_of(joint, "child")
    told = None if kind == "fixed" else joint.find("axis")
    axis = _triple(told, "xyz", _USUAL_AXIS)
    pose = pose_of_origin(joint.find("origin"))
    return RigidLink(child, parent, name, JOINT_KINDS[kind], axis, pose, body=bodies[child])


def _body(link: Any) -> MassDistribution | None:
    inertial = link.find("inertial")
    if inertial is None:
        return None
    mass = numbers_of(inertial.find("mass"), "value", 1)[0]
    return about_origin(
        mass, _tensor(inertial.find("inertia")), pose_of_origin(inertial.find("origin"))
    )


def _tensor(inertia: Any) -> Symmetric:
    if inertia is None:
        return (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    xx, yy, zz, xy, xz, yz = (numbers_of(inertia, name, 1)[0] for name in TENSOR)
    return xx, yy, zz, xy, xz, yz


def pose_of_origin(origin: Any) -> RigidPose:
    """Return the pose of an `<origin>`, that of no element being none."""
    if origin is None:
        return IDENTITY
    zero = (0.0, 0.0, 0.0)
    if origin.get("quat_xyzw") is not None:
        return RigidPose(rotation_of(origin), _triple(origin, "xyz", zero))
    roll, pitch, yaw = map(meant_angle, _triple(origin, "rpy", zero))
    return pose_from_fixed_axes(_triple(origin, "xyz", zero), (roll, pitch, yaw))


def _triple(element: Any, name: str, default: Vector3) -> Vector3:
    if element is None or element.get(name) is None:
        return default
    x, y, z = numbers_of(element, name, 3)
    return x, y, z


def _remarks(robot: Any) -> Iterator[str]:
    yield from drawings_dropped(robot)
    for tag, noun in _ELSEWHERE:
        if number := len(robot.findall(tag)):
            yield f"{counted(number, noun)} dropped: not supported"
    for joint in robot.iterfind("joint[mimic]"):
        yield mimic_dropped(str(joint.get("name")), joint.find("mimic").get("joint") or "?")
