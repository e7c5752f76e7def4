"""URDF to a robot description, through yourdfpy."""

import logging
from collections.abc import Iterator
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np

from kindsl.interchange.format import ReadRobot, limits_dropped
from kindsl.interchange.rigid_links import (
    IDENTITY,
    LinkJoint,
    RigidLink,
    about_origin,
    described,
    fixed_remarks,
)
from kindsl.interchange.robot_description import MassProperties
from kindsl.interchange.urdf.checking import Remarkable, UrdfError, checked
from kindsl.spatial.arrays import Array
from kindsl.text.words import counted

__all__ = ["UrdfError", "read_urdf", "robot_of_urdf"]

_KINDS: dict[str, LinkJoint] = {
    "revolute": "revolute",
    "continuous": "revolute",
    "prismatic": "prismatic",
    "fixed": "fixed",
}
_Z = np.array([0.0, 0.0, 1.0])


def read_urdf(path: Path, *, floating: bool = False) -> ReadRobot:
    """Return the robot of a URDF file.

    Args:
        path: The file. Meshes are not read.
        floating: Whether the root link floats.

    Raises:
        UrdfError: The file is unreadable or beyond the Kinematics-DSL.
        ModuleNotFoundError: yourdfpy is not installed.
    """
    return robot_of_urdf(path.read_bytes(), path.stem, floating=floating)


def robot_of_urdf(text: bytes, name: str, *, floating: bool = False) -> ReadRobot:
    """Return the robot of a URDF's text; see `read_urdf`.

    Args:
        text: As in the file.
        name: What to call a robot without a name.
        floating: Whether the root link floats.
    """
    content, remarkable = checked(text)
    robot = _load(content)
    children: dict[str, list[Any]] = {}
    for joint in robot.joints:
        children.setdefault(joint.parent, []).append(joint)
    root = _root(robot)
    floats = [j for j in children.get(root, []) if j.type == "floating"]
    if len(floats) == 1 and len(children[root]) == 1:
        root, floating = floats[0].child, True
    links = _links(robot, root, children)
    if not any(link.joint_kind in ("revolute", "prismatic") for link in links):
        raise UrdfError("the URDF has no joint that moves, and a document needs one")
    base = described(robot.name or name, "floating" if floating else "fixed", links)
    return ReadRobot(base, (*_remarks(remarkable), *fixed_remarks(links, "link")))


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


def _links(robot: Any, root: str, children: dict[str, list[Any]]) -> list[RigidLink]:
    """Return the links, parents first."""
    masses = {link.name: _mass_properties(link) for link in robot.links}
    links = [RigidLink(root, mass_properties=masses[root])]
    for index, link in enumerate(links):
        links += [_carried(joint, index, masses) for joint in children.get(link.name, [])]
    return links


def _carried(joint: Any, parent: int, masses: dict[str, MassProperties | None]) -> RigidLink:
    if joint.type not in _KINDS:
        raise UrdfError(
            f"the joint '{joint.name}' is {joint.type}, which the language does not support"
        )
    kind = _KINDS[joint.type]
    return RigidLink(
        str(joint.child),
        parent,
        str(joint.name),
        kind,
        _Z if kind == "fixed" else _axis(joint),
        _transform(joint.origin),
        mass_properties=masses[joint.child],
    )


def _axis(joint: Any) -> Array:
    axis = np.array([1.0, 0.0, 0.0]) if joint.axis is None else np.asarray(joint.axis, float)
    if not float(np.linalg.norm(axis)) > 0.0:
        raise UrdfError(f"the joint '{joint.name}' has an axis of no length")
    return axis


def _mass_properties(link: Any) -> MassProperties | None:
    inertial = link.inertial
    if inertial is None or inertial.mass is None:
        return None
    about_com = np.zeros((3, 3)) if inertial.inertia is None else np.asarray(inertial.inertia)
    return about_origin(float(inertial.mass), about_com, _transform(inertial.origin))


def _transform(origin: Any) -> Array:
    return IDENTITY if origin is None else np.asarray(origin, float)


def _remarks(found: Remarkable) -> Iterator[str]:
    if found.limited:
        yield limits_dropped(len(found.limited))
    if found.n_drawn:
        yield f"visuals and collisions of {counted(found.n_drawn, 'link')} dropped"
    if found.damped:
        yield f"damping and friction of {counted(len(found.damped), 'joint')} dropped"
    for joint, other in found.mimics:
        yield f"the joint '{joint}' mimics '{other}': it is now independent"
