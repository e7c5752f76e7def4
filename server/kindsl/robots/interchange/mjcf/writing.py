"""A robot to MJCF: bodies in bodies, frames as sites, full inertia.

MuJoCo's own writer keeps six digits, too few for the same mechanics; so elements are written here,
and MuJoCo reads them again before anybody else does.
"""

from collections.abc import Iterator, Sequence
from xml.etree.ElementTree import Element

from kindsl.language.semantics.parameters import UNTOLD, JointProperties
from kindsl.mechanics.rigid.body import (
    ROUNDING_OF_MOMENTS,
    MassDistribution,
    moments_about_com,
    principal_moments_about_com,
)
from kindsl.mechanics.rigid.pose import IDENTITY, RigidPose
from kindsl.robots.interchange.format import WritingChoices, WrittenRobot, fixed_base_dropped
from kindsl.robots.interchange.mjcf.compiling import checked_text
from kindsl.robots.interchange.xml_writing import added, document_text, numbers, quaternion
from kindsl.robots.mechanism.linkage import Linkage

WORLD = "world"
_TYPES = {"revolute": "hinge", "prismatic": "slide"}
# MuJoCo's mjMINVAL: what moves has at least this mass and these principal moments.
_LEAST = 1e-15
# What a body without mass has in MuJoCo, kg and kg m^2: enough to be moved, too little to count.
DUST = 1e-14
# Where a joint ends that has one limit only, rad or m: nowhere that it gets to.
_FAR = 1e6


def written_mjcf(name: str, skeleton: Linkage, choices: WritingChoices) -> WrittenRobot:
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

    root = Element("mujoco", {"model": name})
    added(root, "compiler", angle="radian", autolimits="true", balanceinertia="false")
    elements = [_base(added(root, "worldbody"), skeleton)]
    for link, parent in skeleton.links():
        elements.append(_link(elements[parent], skeleton, link, choices))
    bodies = list(zip(skeleton.body_names, skeleton.masses, elements, strict=True))
    bodies_that_move = bodies if skeleton.is_floating else bodies[1:]
    for _, mass, element in bodies_that_move:
        element.insert(0, Element("inertial", _inertial(mass)))
    for frame in skeleton.frames:
        added(elements[frame.body], "site", name=frame.name, **_pose(frame.pose))
    text = document_text(root)
    refused = [_impossible(n, mass) for n, mass, _ in bodies_that_move if _is_impossible(mass)]
    if not refused:
        checked_text(text)
    dropped = fixed_base_dropped(skeleton.base_name, choices)
    return WrittenRobot(text, (*_remarks(skeleton), *dropped, *_mass_remarks(skeleton), *refused))


def _base(world: Element, skeleton: Linkage) -> Element:
    if not skeleton.is_floating and skeleton.base_name == WORLD:
        return world
    base = added(world, "body", name=_name(skeleton, 0))
    if skeleton.is_floating:
        added(base, "freejoint")
    return base


def _name(skeleton: Linkage, body: int) -> str:
    """Return a body's name, another one where that is the name of MuJoCo's world."""
    names = skeleton.body_names
    if (name := names[body]) == WORLD:
        while name in names:
            name += "_"
    return name


def _link(parent: Element, skeleton: Linkage, link: int, choices: WritingChoices) -> Element:
    own = skeleton.bodies[link]
    body = added(parent, "body", name=_name(skeleton, link), **_pose(own.placement))
    told = _properties(choices.joints.get(own.joint, UNTOLD))
    added(body, "joint", name=own.joint, type=_TYPES[own.kind], axis="0 0 1", **told)
    return body


def _properties(own: JointProperties) -> dict[str, str]:
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


def _inertial(body: MassDistribution) -> dict[str, str]:
    """Return the attributes of a body's inertia, as much more of it as MuJoCo requires."""
    missing = 0.0 if _is_impossible(body) else _missing(body)
    more = missing + DUST if missing else 0.0
    xx, yy, zz, xy, xz, yz = moments_about_com(body)
    return {
        "pos": numbers(body.com),
        "mass": numbers([body.mass if body.mass < 0.0 else max(body.mass, DUST)]),
        "fullinertia": numbers((xx + more, yy + more, zz + more, -xy, -xz, -yz)),
    }


def _is_impossible(body: MassDistribution) -> bool:
    allowed = 2.0 * _LEAST + ROUNDING_OF_MOMENTS * abs(principal_moments_about_com(body)[2])
    return _missing(body) > allowed or body.mass < 0.0


def _missing(body: MassDistribution) -> float:
    """Return how much is missing of each principal moment, kg m^2, by what MuJoCo requires."""
    lowest, middle, highest = principal_moments_about_com(body)
    return max(_LEAST - lowest, highest - lowest - middle, 0.0)


def _pose(pose: RigidPose) -> dict[str, str]:
    x, y, z, w = quaternion(pose.rotation)
    turned = {} if pose.rotation == IDENTITY.rotation else {"quat": numbers((w, x, y, z))}
    return {**({"pos": numbers(pose.translation)} if any(pose.translation) else {}), **turned}


def _impossible(name: str, body: MassDistribution) -> str:
    if body.mass < 0.0:
        return f"mass of '{name}' is negative: MuJoCo refuses the file"
    what = f"inertia of '{name}' is physically impossible: MuJoCo refuses the file"
    return f"{what}; --repair-inertia writes the nearest possible one"


def _mass_remarks(skeleton: Linkage) -> Iterator[str]:
    for name, body in zip(skeleton.link_names, skeleton.masses[1:], strict=True):
        if not body.mass:
            yield f"the link '{name}' has no mass: written with {DUST:g} kg, which MuJoCo requires"


def _remarks(skeleton: Linkage) -> Iterator[str]:
    for body, name in enumerate(skeleton.body_names):
        if name == WORLD and (body or skeleton.is_floating):
            told = f"the {'link' if body else 'base'} '{WORLD}' is now '{_name(skeleton, body)}'"
            yield f"{told}: MuJoCo's world has that name"
