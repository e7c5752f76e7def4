"""Numbered bodies to URDF: the same mechanics, frames as links on fixed joints."""

from collections.abc import Iterator
from math import pi
from typing import Any

import numpy as np

from kindsl.dynamics.bodies import Bodies
from kindsl.interchange.format import ORDINARY, WritingChoices
from kindsl.spatial.arrays import Array
from kindsl.spatial.inertia import point_inertia
from kindsl.text.words import counted

# URDF wants limits of every joint but an endless one, and the configuration may give none.
_LIMITS = {
    "prismatic": {"lower": -1.0, "upper": 1.0, "effort": 1000.0, "velocity": 10.0},
    "revolute": {"lower": -2.0 * pi, "upper": 2.0 * pi, "effort": 1000.0, "velocity": 10.0},
}


def urdf_text(name: str, bodies: Bodies, choices: WritingChoices = ORDINARY) -> str:
    """Return the URDF of a mechanism; the root link is the base, floating or not.

    Args:
        name: The robot's name.
        bodies: Its bodies.
        choices: Whether revolute joints without limits become `continuous`, which pinocchio gives
            two coordinates; and limits of joints.

    Raises:
        ModuleNotFoundError: yourdfpy is not installed.
    """
    from lxml import etree
    from yourdfpy import URDF, Joint, Link, Robot
    from yourdfpy.urdf import Limit

    body_names = (bodies.base_name, *bodies.link_names)
    robot = Robot(name=name)
    robot.links = [Link(name=n, inertial=_inertial(bodies, i)) for i, n in enumerate(body_names)]
    for link, parent in bodies.links():
        i = link - 1
        limits = _limits(bodies, i, choices)
        robot.joints.append(
            Joint(
                name=bodies.joint_names[i],
                type=bodies.joint_kinds[i] if limits else "continuous",
                parent=body_names[parent],
                child=body_names[link],
                origin=_transform(bodies.p_R_j[i], bodies.p_r_j[i]),
                axis=np.array([0.0, 0.0, 1.0]),
                limit=Limit(**limits) if limits else None,
            )
        )
    for frame in bodies.frames:
        robot.links.append(Link(name=frame.name))
        origin = _transform(frame.body_R_frame, frame.body_r_frame)
        fixed = f"{frame.name}_fixed"
        carrier = body_names[frame.body]
        robot.joints.append(Joint(fixed, "fixed", carrier, frame.name, origin))
    document = URDF(robot, build_scene_graph=False, load_meshes=False).write_xml()
    text: str = etree.tostring(
        document, xml_declaration=True, pretty_print=True, encoding="utf-8"
    ).decode()
    return text


def urdf_remarks(bodies: Bodies, choices: WritingChoices = ORDINARY) -> Iterator[str]:
    """Yield what the URDF says that the document did not."""
    kinds = zip(bodies.joint_names, bodies.joint_kinds, strict=True)
    unlimited = [(name, kind) for name, kind in kinds if name not in choices.limits]
    n_turning = sum(kind == "revolute" for _, kind in unlimited)
    if n_turning and not choices.endless_joints:
        joints = counted(n_turning, "revolute joint")
        yield f"{joints} got limits of a full turn each way; --continuous writes endless joints"
    for name, kind in unlimited:
        if kind == "prismatic":
            yield f"the joint '{name}' got limits of -1 m and 1 m, which a URDF must give"
    if bodies.is_floating:
        yield f"the floating base '{bodies.base_name}' became the root link, which tools may fix"


def _limits(bodies: Bodies, joint: int, choices: WritingChoices) -> dict[str, float]:
    """Return the attributes of a joint's limits; none of an endless one."""
    kind, given = bodies.joint_kinds[joint], choices.limits.get(bodies.joint_names[joint])
    if given is None:
        return {} if kind == "revolute" and choices.endless_joints else _LIMITS[kind]
    ends = {"lower": given.minimum, "upper": given.maximum}
    return _LIMITS[kind] | {end: value for end, value in ends.items() if value is not None}


def _inertial(bodies: Bodies, body: int) -> Any:
    """Return URDF's inertial: about the centre of mass, along the link's axes."""
    from yourdfpy.urdf import Inertial

    mass, com = bodies.masses[body], bodies.coms[body]
    if not mass and not bodies.inertias[body].any():
        return None
    about_com = bodies.inertias[body] - point_inertia(mass, com)
    return Inertial(_transform(np.eye(3), com), float(mass), about_com)


def _transform(R: Array, r: Array) -> Array:
    T = np.eye(4)
    T[:3, :3] = R
    T[:3, 3] = r
    return T
