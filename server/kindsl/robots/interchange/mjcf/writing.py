"""Numbered bodies to MJCF: bodies in bodies, frames as sites, full inertia.

MuJoCo's own writer keeps six digits, too few for the same mechanics; so elements are written here,
and MuJoCo reads them again before anybody else does.
"""

from collections.abc import Iterator, Sequence
from xml.etree.ElementTree import Element

import numpy as np

from kindsl.language.semantics.parameters import UNTOLD, JointProperties
from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.rigid.body import ROUNDING_OF_MOMENTS
from kindsl.mechanics.spatial.arrays import Array
from kindsl.mechanics.spatial.inertia import point_inertia
from kindsl.robots.interchange.format import (
    ORDINARY,
    WritingChoices,
    WrittenRobot,
    fixed_base_dropped,
)
from kindsl.robots.interchange.mjcf.compiling import checked_text
from kindsl.robots.interchange.xml_writing import added, document_text, numbers
from kindsl.robots.mechanism.bodies import bodies_of
from kindsl.robots.mechanism.linkage import Linkage

WORLD = "world"
_TYPES = {"revolute": "hinge", "prismatic": "slide"}
# MuJoCo's mjMINVAL: what moves has at least this mass and these principal moments.
_LEAST = 1e-15
# What a body without mass has in MuJoCo, kg and kg m^2: enough to be moved, too little to count.
DUST = 1e-14
# Where a joint ends that has one limit only, rad or m: nowhere that it gets to.
_FAR = 1e6


def written_mjcf(name: str, skeleton: Linkage, choices: WritingChoices = ORDINARY) -> WrittenRobot:
    """Return the MJCF of a mechanism.

    A fixed base is a body of the world without joint, or the world itself if that is its name; a
    floating one has a free joint.

    Args:
        name: The robot's name.
        skeleton: Its bodies.
        choices: Joint properties to write.

    Raises:
        FormatError: MuJoCo refuses it, though all bodies are possible.
        ModuleNotFoundError: mujoco is not installed.
    """
    import mujoco  # noqa: F401

    bodies = bodies_of(skeleton)
    root = Element("mujoco", {"model": name})
    added(root, "compiler", angle="radian", autolimits="true", balanceinertia="false")
    elements = [_base(added(root, "worldbody"), bodies)]
    for link, parent in bodies.links():
        elements.append(_link(elements[parent], bodies, link, choices))
    bodies_that_move = range(0 if bodies.is_floating else 1, bodies.n_links + 1)
    for body in bodies_that_move:
        elements[body].insert(0, Element("inertial", _inertial(bodies, body)))
    for frame in bodies.frames:
        pose = _pose(frame.body_R_frame, frame.body_r_frame)
        added(elements[frame.body], "site", name=frame.name, **pose)
    text = document_text(root)
    impossible = [body for body in bodies_that_move if _is_impossible(bodies, body)]
    refused = [_impossible(bodies, body) for body in impossible]
    if not refused:
        checked_text(text)
    dropped = fixed_base_dropped(bodies.base_name, choices)
    return WrittenRobot(text, (*_remarks(bodies), *dropped, *_mass_remarks(bodies), *refused))


def _base(world: Element, bodies: Bodies) -> Element:
    if not bodies.is_floating and bodies.base_name == WORLD:
        return world
    base = added(world, "body", name=_name(bodies, 0))
    if bodies.is_floating:
        added(base, "freejoint")
    return base


def _name(bodies: Bodies, body: int) -> str:
    """Return a body's name, another one where that is the name of MuJoCo's world."""
    names = bodies.base_name, *bodies.link_names
    return names[body] if names[body] != WORLD else _free_name(names)


def _free_name(names: Sequence[str]) -> str:
    name = f"{WORLD}_"
    while name in names:
        name += "_"
    return name


def _link(parent: Element, bodies: Bodies, link: int, choices: WritingChoices) -> Element:
    i = link - 1
    pose = _pose(bodies.p_R_j[i], bodies.p_r_j[i])
    body = added(parent, "body", name=_name(bodies, link), **pose)
    kind = _TYPES[bodies.joint_kinds[i]]
    name = bodies.joint_names[i]
    added(
        body, "joint", name=name, type=kind, axis="0 0 1", **_told(choices.joints.get(name, UNTOLD))
    )
    return body


def _told(own: JointProperties) -> dict[str, str]:
    """Return the attributes of what is told of a joint; of limits, MuJoCo has two or none."""
    given: dict[str, Sequence[float]] = {}
    if own.limits != (None, None):
        given["range"] = [
            -_FAR if own.minimum is None else own.minimum,
            _FAR if own.maximum is None else own.maximum,
        ]
    if own.effort is not None:
        given["actuatorfrcrange"] = (-own.effort, own.effort)
    amounts = {"armature": own.armature, "damping": own.damping, "frictionloss": own.friction}
    given |= {name: (value,) for name, value in amounts.items() if value is not None}
    return {name: numbers(values) for name, values in given.items()}


def _inertial(bodies: Bodies, body: int) -> dict[str, str]:
    """Return the attributes of a body's inertia, as much more of it as MuJoCo requires."""
    I = _about_com(bodies, body)  # noqa: E741
    missing = 0.0 if _is_impossible(bodies, body) else _missing(I)
    I = I + (missing + DUST if missing else 0.0) * np.eye(3)  # noqa: E741
    moments = [I[0, 0], I[1, 1], I[2, 2], I[0, 1], I[0, 2], I[1, 2]]
    mass = float(bodies.masses[body])
    return {
        "pos": numbers(bodies.coms[body]),
        "mass": numbers([mass if mass < 0.0 else max(mass, DUST)]),
        "fullinertia": numbers(moments),
    }


def _is_impossible(bodies: Bodies, body: int) -> bool:
    """Return whether a body that moves has an inertia that MuJoCo refuses."""
    I = _about_com(bodies, body)  # noqa: E741
    allowed = 2.0 * _LEAST + ROUNDING_OF_MOMENTS * abs(np.linalg.eigvalsh(I)[2])
    return bool(_missing(I) > allowed or bodies.masses[body] < 0.0)


def _missing(I: Array) -> float:  # noqa: E741
    """Return how much is missing of each principal moment, kg m^2, by what MuJoCo requires."""
    lowest, middle, highest = np.linalg.eigvalsh(I)
    return float(max(_LEAST - lowest, highest - lowest - middle, 0.0))


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


def _impossible(bodies: Bodies, body: int) -> str:
    name = (bodies.base_name, *bodies.link_names)[body]
    if bodies.masses[body] < 0.0:
        return f"mass of '{name}' is negative: MuJoCo refuses the file"
    what = f"inertia of '{name}' is physically impossible: MuJoCo refuses the file"
    return f"{what}; --repair-inertia writes the nearest possible one"


def _mass_remarks(bodies: Bodies) -> Iterator[str]:
    for name, mass in zip(bodies.link_names, bodies.masses[1:], strict=True):
        if not mass:
            yield f"the link '{name}' has no mass: written with {DUST:g} kg, which MuJoCo requires"


def _remarks(bodies: Bodies) -> Iterator[str]:
    for body, name in enumerate((bodies.base_name, *bodies.link_names)):
        if name == WORLD and (body or bodies.is_floating):
            told = f"the {'link' if body else 'base'} '{WORLD}' is now '{_name(bodies, body)}'"
            yield f"{told}: MuJoCo's world has that name"
