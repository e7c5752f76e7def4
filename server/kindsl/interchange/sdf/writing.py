"""Numbered bodies to SDF: every link at its joint, every joint in its parent link."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from kindsl.dynamics.bodies import Bodies
from kindsl.interchange.format import ORDINARY, WritingChoices, WrittenRobot
from kindsl.interchange.sdf.frame_graph import WORLD
from kindsl.interchange.xml_writing import added, document_text, numbers
from kindsl.spatial.arrays import Array
from kindsl.spatial.inertia import point_inertia

# The first version whose poses may be quaternions, which keep every rotation exact.
_VERSION = "1.9"


def written_sdf(name: str, bodies: Bodies, choices: WritingChoices = ORDINARY) -> WrittenRobot:
    """Return the SDF of a mechanism; a fixed base has a fixed joint to the world.

    Args:
        name: The robot's name.
        bodies: Its bodies.
        choices: Limits of joints.

    Raises:
        ModuleNotFoundError: lxml is not installed.
    """
    from lxml import etree

    names = _names(bodies)
    body_names = [names["link", n] for n in (bodies.base_name, *bodies.link_names)]
    root = etree.Element("sdf", {"version": _VERSION})
    model = added(root, "model", name=name, canonical_link=body_names[0])
    base = added(model, "link", name=body_names[0])
    if bodies.is_floating:
        _add_inertial(base, bodies, 0)
    else:
        _add_joint(model, names["joint", WORLD], "fixed", WORLD, body_names[0])
    for link, parent in bodies.links():
        axis = _add_link(model, bodies, names, link, body_names[parent])
        _add_limits(axis, choices.limits.get(bodies.joint_names[link - 1], (None, None)))
    for frame in bodies.frames:
        attached = body_names[frame.body]
        element = added(model, "frame", name=names["frame", frame.name], attached_to=attached)
        _add_pose(element, frame.body_R_frame, frame.body_r_frame)
    renamed = (
        f"the {kind} '{old}' is now '{new}': names are unique in SDF"
        for (kind, old), new in names.items()
        if old not in (new, WORLD) or (old == WORLD and kind != "joint")
    )
    return WrittenRobot(document_text(root), (*renamed, *_refused_elsewhere(bodies)))


def _names(bodies: Bodies) -> dict[tuple[str, str], str]:
    """Return a name for each kind and name, unique among all; of the joint to the world too."""
    things = [("link", name) for name in (bodies.base_name, *bodies.link_names)]
    things += [("joint", name) for name in bodies.joint_names]
    things += [("frame", frame.name) for frame in bodies.frames]
    taken = {WORLD}
    names: dict[tuple[str, str], str] = {}
    for kind, name in (*things, ("joint", WORLD)):
        free = f"{WORLD}_fixed" if (kind, name) == ("joint", WORLD) else name.replace("::", "_")
        while free in taken:
            free += f"_{kind}"
        taken.add(free)
        names[kind, name] = free
    return names


def _add_link(
    model: Any, bodies: Bodies, names: dict[tuple[str, str], str], link: int, parent: str
) -> Any:
    """Add a link and its joint; return the joint's axis."""
    i = link - 1
    name = names["link", bodies.link_names[i]]
    joint_name = names["joint", bodies.joint_names[i]]
    element = added(model, "link", name=name)
    added(element, "pose", relative_to=joint_name)
    _add_inertial(element, bodies, link)
    joint = _add_joint(model, joint_name, bodies.joint_kinds[i], parent, name)
    _add_pose(joint, bodies.p_R_j[i], bodies.p_r_j[i], relative_to=parent)
    axis = added(joint, "axis")
    added(axis, "xyz").text = "0 0 1"
    return axis


def _add_limits(axis: Any, limits: tuple[float | None, float | None]) -> None:
    if limits == (None, None):
        return
    limit = added(axis, "limit")
    for tag, end in zip(("lower", "upper"), limits, strict=True):
        if end is not None:
            added(limit, tag).text = numbers([end])


def _add_joint(model: Any, name: str, kind: str, parent: str, child: str) -> Any:
    joint = added(model, "joint", name=name, type=kind)
    added(joint, "parent").text = parent
    added(joint, "child").text = child
    return joint


def _add_inertial(link: Any, bodies: Bodies, body: int) -> None:
    """Add mass and inertia about the centre of mass, along the link's axes."""
    inertial = added(link, "inertial")
    com = bodies.coms[body]
    if com.any():
        added(inertial, "pose").text = f"{numbers(com)} 0 0 0"
    added(inertial, "mass").text = numbers(bodies.masses[body])
    inertia = added(inertial, "inertia")
    I = _about_com(bodies, body)  # noqa: E741
    for tag, (row, column) in {
        "ixx": (0, 0), "ixy": (0, 1), "ixz": (0, 2), "iyy": (1, 1), "iyz": (1, 2), "izz": (2, 2)
    }.items():  # fmt: skip
        added(inertia, tag).text = numbers(I[row, column])


def _about_com(bodies: Bodies, body: int) -> Array:
    at_com = point_inertia(bodies.masses[body], bodies.coms[body])
    return np.asarray(bodies.inertias[body] - at_com)


def _add_pose(element: Any, R: Array, r: Array, **reference: str) -> None:
    if np.array_equal(R, np.eye(3)):
        added(element, "pose", **reference).text = f"{numbers(r)} 0 0 0"
        return
    pose = added(element, "pose", rotation_format="quat_xyzw", **reference)
    pose.text = f"{numbers(r)} {numbers(_quaternion(R))}"


def _quaternion(R: Array) -> Array:
    """Return x, y, z, w: the greatest eigenvector of Bar-Itzhack's matrix, exact for all turns.

    Source: Bar-Itzhack 2000, New method for extracting the quaternion from a rotation matrix.
    """
    K = np.empty((4, 4))
    K[:3, :3] = R + R.T - np.trace(R) * np.eye(3)
    K[:3, 3] = K[3, :3] = R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]
    K[3, 3] = np.trace(R)
    q = np.linalg.eigh(K)[1][:, 3]
    return np.asarray(q if q[3] >= 0.0 else -q)


def _refused_elsewhere(bodies: Bodies) -> Iterator[str]:
    names = (bodies.base_name, *bodies.link_names)
    for body in range(0 if bodies.is_floating else 1, len(names)):
        moments = np.linalg.eigvalsh(_about_com(bodies, body))
        if bodies.masses[body] == 0.0 and not moments.any():
            yield f"the link '{names[body]}' has no mass: other tools refuse it"
        elif not bodies.masses[body] > 0.0 or moments[0] <= 0.0:
            yield f"inertia of '{names[body]}' is physically impossible: other tools refuse it"
