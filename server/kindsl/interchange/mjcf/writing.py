"""Numbered bodies to MJCF: bodies in bodies, frames as sites, full inertia.

MuJoCo's own writer keeps six digits, too few for the same mechanics; so elements are written here,
and MuJoCo reads them again before anybody else does.
"""

from collections.abc import Iterator
from typing import Any

import numpy as np

from kindsl.dynamics.bodies import Bodies
from kindsl.interchange.format import FormatError, WrittenRobot
from kindsl.interchange.mjcf.compiling import checked_text
from kindsl.interchange.xml_writing import added, document_text, numbers
from kindsl.spatial.arrays import Array
from kindsl.spatial.inertia import point_inertia

WORLD = "world"
_TYPES = {"revolute": "hinge", "prismatic": "slide"}
# MuJoCo's mjMINVAL: what moves has at least this mass and these principal moments.
_LEAST = 1e-15


def written_mjcf(name: str, bodies: Bodies) -> WrittenRobot:
    """Return the MJCF of a mechanism.

    A fixed base is a body of the world without joint, or the world itself if that is its name; a
    floating one has a free joint.

    Args:
        name: The robot's name.
        bodies: Its bodies.

    Raises:
        FormatError: A body cannot move in MuJoCo.
        ModuleNotFoundError: mujoco or lxml is not installed.
    """
    import mujoco  # noqa: F401
    from lxml import etree

    _check_bodies(bodies)
    root = etree.Element("mujoco", {"model": name})
    added(root, "compiler", angle="radian", autolimits="true", balanceinertia="false")
    elements = [_base(added(root, "worldbody"), bodies)]
    for link, parent in bodies.links():
        elements.append(_link(elements[parent], bodies, link))
    for frame in bodies.frames:
        pose = _pose(frame.body_R_frame, frame.body_r_frame)
        added(elements[frame.body], "site", name=frame.name, **pose)
    text = document_text(root)
    checked_text(text)
    return WrittenRobot(text, tuple(_remarks(bodies)))


def _base(world: Any, bodies: Bodies) -> Any:
    if not bodies.is_floating and bodies.base_name == WORLD:
        return world
    base = added(world, "body", name=_base_name(bodies))
    if bodies.is_floating:
        _add_inertial(base, bodies, 0)
        added(base, "freejoint")
    return base


def _base_name(bodies: Bodies) -> str:
    """Return the base's name, which in MuJoCo is not the world's."""
    name = bodies.base_name
    while name == WORLD or (name != bodies.base_name and name in bodies.link_names):
        name += "_"
    return name


def _link(parent: Any, bodies: Bodies, link: int) -> Any:
    i = link - 1
    pose = _pose(bodies.p_R_j[i], bodies.p_r_j[i])
    body = added(parent, "body", name=_link_name(bodies, i), **pose)
    _add_inertial(body, bodies, link)
    kind = _TYPES[bodies.joint_kinds[i]]
    added(body, "joint", name=bodies.joint_names[i], type=kind, axis="0 0 1")
    return body


def _link_name(bodies: Bodies, i: int) -> str:
    name = bodies.link_names[i]
    return f"{name}_" if name == WORLD else name


def _add_inertial(element: Any, bodies: Bodies, body: int) -> None:
    I = _about_com(bodies, body)  # noqa: E741
    moments = [I[0, 0], I[1, 1], I[2, 2], I[0, 1], I[0, 2], I[1, 2]]
    mass = numbers(bodies.masses[body])
    com = numbers(bodies.coms[body])
    added(element, "inertial", pos=com, mass=mass, fullinertia=numbers(moments))


def _about_com(bodies: Bodies, body: int) -> Array:
    at_com = point_inertia(bodies.masses[body], bodies.coms[body])
    return np.asarray(bodies.inertias[body] - at_com)


def _pose(R: Array, r: Array) -> dict[str, str]:
    import mujoco

    quaternion = np.zeros(4)
    mujoco.mju_mat2Quat(quaternion, np.ravel(R))
    turned = not np.array_equal(R, np.eye(3))
    pose = {"pos": numbers(r)} if r.any() else {}
    return pose | ({"quat": numbers(quaternion)} if turned else {})


def _check_bodies(bodies: Bodies) -> None:
    names = (bodies.base_name, *bodies.link_names)
    for body in range(0 if bodies.is_floating else 1, len(names)):
        if bodies.masses[body] < _LEAST:
            raise FormatError(
                f"link '{names[body]}' has mass {bodies.masses[body]:.6g}, "
                "and MuJoCo moves no body without mass"
            )
        moments = np.linalg.eigvalsh(_about_com(bodies, body))
        if moments[0] < _LEAST or moments[0] + moments[1] < moments[2] * (1.0 - 1e-9):
            told = ", ".join(f"{moment:.6g}" for moment in moments)
            raise FormatError(
                f"inertia of '{names[body]}' is physically impossible, principal moments {told}, "
                "and MuJoCo refuses it"
            )


def _remarks(bodies: Bodies) -> Iterator[str]:
    names = (bodies.base_name, *bodies.link_names)
    if bodies.is_floating and bodies.base_name == WORLD:
        yield f"the base '{WORLD}' is now '{_base_name(bodies)}': MuJoCo's world has that name"
    if WORLD in names[1:]:
        yield f"the link '{WORLD}' is now '{WORLD}_': MuJoCo's world has that name"
