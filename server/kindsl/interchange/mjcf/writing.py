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
from kindsl.spatial.transforms import homogeneous

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

    folded = _folded(bodies)
    _check_bodies(bodies, folded)
    root = etree.Element("mujoco", {"model": name})
    added(root, "compiler", angle="radian", autolimits="true", balanceinertia="false")
    elements = [_base(added(root, "worldbody"), bodies)]
    for link, parent in bodies.links():
        chain = _chain(bodies, parent, folded)
        carrier = bodies.parents[chain[0] - 1] if chain else parent
        is_body = link not in folded
        elements.append(_link(elements[carrier], bodies, link, chain) if is_body else None)
    for frame in bodies.frames:
        pose = _pose(frame.body_R_frame, frame.body_r_frame)
        added(elements[frame.body], "site", name=frame.name, **pose)
    text = document_text(root)
    checked_text(text)
    return WrittenRobot(text, (*_remarks(bodies), *_folding_remarks(bodies, folded)))


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


def _folded(bodies: Bodies) -> frozenset[int]:
    """Return links without mass that stand between two others, which MuJoCo cannot move alone.

    The body of the link behind such a one can have the joints of both.
    """
    carriers = {frame.body for frame in bodies.frames}
    return frozenset(
        link
        for link, _ in bodies.links()
        if bodies.parents.count(link) == 1
        and link not in carriers
        and not bodies.masses[link]
        and not bodies.inertias[link].any()
    )


def _chain(bodies: Bodies, parent: int, folded: frozenset[int]) -> list[int]:
    """Return the folded links above a link, whose parent is given, the outermost first."""
    chain: list[int] = []
    while parent in folded:
        chain.insert(0, parent)
        parent = bodies.parents[parent - 1]
    return chain


def _link(parent: Any, bodies: Bodies, link: int, chain: list[int]) -> Any:
    """Add a link's body with its own joint, and before it those of the folded links above."""
    placed = np.eye(4)
    parent_T = {}
    for each in (*chain, link):
        placed = placed @ homogeneous(bodies.p_R_j[each - 1], bodies.p_r_j[each - 1])
        parent_T[each] = placed
    pose = _pose(placed[:3, :3], placed[:3, 3])
    body = added(parent, "body", name=_link_name(bodies, link - 1), **pose)
    _add_inertial(body, bodies, link)
    for each in (*chain, link):
        body_T_joint = np.linalg.inv(placed) @ parent_T[each]
        _add_joint(body, bodies, each - 1, body_T_joint if each != link else np.eye(4))
    return body


def _add_joint(body: Any, bodies: Bodies, i: int, body_T_joint: Array) -> None:
    kind = _TYPES[bodies.joint_kinds[i]]
    axis, place = numbers(body_T_joint[:3, 2]), body_T_joint[:3, 3]
    at = {"pos": numbers(place)} if place.any() else {}
    added(body, "joint", name=bodies.joint_names[i], type=kind, axis=axis, **at)


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


def _check_bodies(bodies: Bodies, folded: frozenset[int]) -> None:
    names = (bodies.base_name, *bodies.link_names)
    moving = range(0 if bodies.is_floating else 1, len(names))
    for body in (body for body in moving if body not in folded):
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


def _folding_remarks(bodies: Bodies, folded: frozenset[int]) -> Iterator[str]:
    for link, parent in bodies.links():
        for above in _chain(bodies, parent, folded) if link not in folded else ():
            names = bodies.link_names[above - 1], bodies.link_names[link - 1]
            yield f"the link '{names[0]}' has no mass: its joint became one of body '{names[1]}'"


def _remarks(bodies: Bodies) -> Iterator[str]:
    names = (bodies.base_name, *bodies.link_names)
    if bodies.is_floating and bodies.base_name == WORLD:
        yield f"the base '{WORLD}' is now '{_base_name(bodies)}': MuJoCo's world has that name"
    if WORLD in names[1:]:
        yield f"the link '{WORLD}' is now '{WORLD}_': MuJoCo's world has that name"
