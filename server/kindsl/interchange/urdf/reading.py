"""URDF to a robot description: fixed joints merged, axes turned to z."""

import logging
from collections.abc import Iterator
from dataclasses import dataclass, field
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np

from kindsl.interchange.robot_description import (
    DescribedFrame,
    DescribedLink,
    MassProperties,
    RobotDescription,
)
from kindsl.interchange.urdf.checking import Remarkable, UrdfError, checked
from kindsl.interchange.urdf.xacro_expansion import expanded
from kindsl.spatial.arrays import Array
from kindsl.spatial.inertia import move_inertia
from kindsl.text.words import counted

__all__ = ["UrdfError", "UrdfRobot", "read_urdf"]

_KINDS = {"revolute": "revolute", "continuous": "revolute", "prismatic": "prismatic"}


@dataclass(frozen=True, slots=True)
class UrdfRobot:
    """What was read, and remarks on what could not be kept."""

    robot: RobotDescription
    remarks: tuple[str, ...]


@dataclass(slots=True)
class _Body:
    """A link with all that is fixed to it, while it is put together."""

    name: str
    joint: str
    joint_kind: str
    parent: int | None
    parent_T_joint: Array
    masses: list[MassProperties] = field(default_factory=list)
    frames: list[DescribedFrame] = field(default_factory=list)


def read_urdf(path: Path, *, floating: bool = False) -> UrdfRobot:
    """Return the robot of a URDF file.

    Args:
        path: The file. Meshes are not read.
        floating: Whether the root link floats.

    Raises:
        UrdfError: The file is unreadable or beyond the Kinematics-DSL.
        ModuleNotFoundError: yourdfpy is not installed.
    """
    content, remarkable = checked(expanded(path))
    robot = _load(content)
    children: dict[str, list[Any]] = {}
    for joint in robot.joints:
        children.setdefault(joint.parent, []).append(joint)
    root = _root(robot)
    floats = [j for j in children.get(root, []) if j.type == "floating"]
    if len(floats) == 1 and len(children[root]) == 1:
        root, floating = floats[0].child, True
    bodies = _bodies(robot, root, children)
    if len(bodies) == 1:
        raise UrdfError("the URDF has no joint that moves, and a document needs one")
    links = tuple(_described(body) for body in bodies)
    remarks = tuple(_remarks(remarkable, bodies))
    return UrdfRobot(RobotDescription(robot.name or path.stem, floating, links), remarks)


def _load(content: BytesIO) -> Any:
    from yourdfpy import URDF

    logging.getLogger("yourdfpy.urdf").setLevel(logging.CRITICAL)
    try:
        urdf = URDF.load(
            content,
            build_scene_graph=False,
            load_meshes=False,
            build_collision_scene_graph=False,
            load_collision_meshes=False,
        )
    except Exception as error:
        raise UrdfError("not a readable URDF") from error
    return urdf.robot


def _root(robot: Any) -> str:
    carried = {joint.child for joint in robot.joints}
    return next(str(link.name) for link in robot.links if link.name not in carried)


def _bodies(robot: Any, root: str, children: dict[str, list[Any]]) -> list[_Body]:
    """Return the bodies depth first: links with everything that fixed joints hang on them."""
    links = {link.name: link for link in robot.links}
    bodies = [_Body(root, "", "", None, np.eye(4))]
    pending: list[tuple[str, int, Array]] = [(root, 0, np.eye(4))]
    while pending:
        name, index, body_T_link = pending.pop()
        _add_mass(bodies[index], links[name], body_T_link)
        for joint in reversed(children.get(name, [])):
            origin = np.eye(4) if joint.origin is None else np.asarray(joint.origin, float)
            body_T_joint = body_T_link @ origin
            if joint.type == "fixed":
                bodies[index].frames.append(DescribedFrame(joint.child, body_T_joint))
                pending.append((joint.child, index, body_T_joint))
            else:
                pending.append(_moving(joint, index, body_T_joint, bodies))
    return _depth_first(bodies)


def _moving(
    joint: Any, index: int, body_T_joint: Array, bodies: list[_Body]
) -> tuple[str, int, Array]:
    """Add the body that a joint moves; its link frame is turned so that z is the axis."""
    if joint.type not in _KINDS:
        raise UrdfError(
            f"the joint '{joint.name}' is {joint.type}, which the language does not support"
        )
    joint_T_link = np.eye(4)
    joint_T_link[:3, :3] = _z_to(joint)
    kind = _KINDS[joint.type]
    bodies.append(_Body(joint.child, joint.name, kind, index, body_T_joint @ joint_T_link))
    return str(joint.child), len(bodies) - 1, joint_T_link.T


def _depth_first(bodies: list[_Body]) -> list[_Body]:
    """Renumber the bodies so that each subtree stands together."""
    below: dict[int, list[int]] = {}
    for index, body in enumerate(bodies):
        if body.parent is not None:
            below.setdefault(body.parent, []).append(index)
    order: list[int] = []
    pending = [0]
    while pending:
        index = pending.pop()
        order.append(index)
        pending += below.get(index, [])
    place = {index: number for number, index in enumerate(order)}
    for body in bodies:
        body.parent = place[body.parent] if body.parent is not None else None
    return [bodies[index] for index in order]


def _z_to(joint: Any) -> Array:
    """Return a rotation that takes z to the joint's axis, shape (3, 3); none if it is z already.

    It is the smallest one on z's side; on the other, one after a half turn about x, since the
    smallest is not defined near -z.
    """
    axis = np.array([1.0, 0.0, 0.0]) if joint.axis is None else np.asarray(joint.axis, float)
    length = float(np.linalg.norm(axis))
    if not length > 0.0:
        raise UrdfError(f"the joint '{joint.name}' has an axis of no length")
    half_turn = np.diag([1.0, -1.0, -1.0] if axis[2] < 0.0 else [1.0, 1.0, 1.0])
    x, y, z = half_turn @ axis / length
    k = 1.0 / (1.0 + z)
    smallest = [[1.0 - k * x * x, -k * x * y, x], [-k * x * y, 1.0 - k * y * y, y], [-x, -y, z]]
    return np.asarray(half_turn @ np.array(smallest))


def _add_mass(body: _Body, link: Any, body_T_link: Array) -> None:
    inertial = link.inertial
    if inertial is None or inertial.mass is None:
        return
    origin = np.eye(4) if inertial.origin is None else np.asarray(inertial.origin, float)
    about_com = np.zeros((3, 3)) if inertial.inertia is None else np.asarray(inertial.inertia)
    T = body_T_link @ origin
    mass = float(inertial.mass)
    com, inertia = move_inertia(np.asarray(mass), np.zeros(3), about_com, T[:3, :3], T[:3, 3])
    body.masses.append(MassProperties(mass, com, inertia))


def _described(body: _Body) -> DescribedLink:
    return DescribedLink(
        body.name,
        _lumped(body.masses),
        tuple(body.frames),
        body.parent,
        body.joint,
        body.joint_kind,
        body.parent_T_joint,
    )


def _lumped(parts: list[MassProperties]) -> MassProperties | None:
    if not parts:
        return None
    mass = sum(part.mass for part in parts)
    moment = np.sum([part.mass * part.com for part in parts], axis=0)
    inertia = np.sum([part.inertia for part in parts], axis=0)
    return MassProperties(mass, moment / mass if mass else np.zeros(3), inertia)


def _remarks(found: Remarkable, bodies: list[_Body]) -> Iterator[str]:
    if found.limited:
        yield f"limits of {counted(len(found.limited), 'joint')} dropped: not supported"
    if found.n_drawn:
        yield f"visuals and collisions of {counted(found.n_drawn, 'link')} dropped"
    if found.damped:
        yield f"damping and friction of {counted(len(found.damped), 'joint')} dropped"
    for joint, other in found.mimics:
        yield f"the joint '{joint}' mimics '{other}': it is now independent"
    for body in bodies:
        if body.parent is not None and not body.masses:
            yield f"the link '{body.name}' has no inertia in the URDF"
        for frame in body.frames:
            yield f"the link '{frame.name}', fixed to '{body.name}', became a frame of it"
