"""A skeleton to URDF: the same mechanics, frames as links on fixed joints."""

from collections.abc import Iterator, Mapping
from math import pi
from xml.etree.ElementTree import Element

from kindsl.language.semantics.parameters import UNTOLD, JointProperties
from kindsl.language.text.phrases import counted
from kindsl.mechanics.rigid.body import MassDistribution, moments_about_com
from kindsl.mechanics.rigid.pose import IDENTITY, RigidPose, fixed_axis_angles
from kindsl.robots.interchange.format import (
    ORDINARY,
    WritingChoices,
    WrittenRobot,
    armature_dropped,
    fixed_base_dropped,
)
from kindsl.robots.interchange.xml_writing import added, document_text
from kindsl.robots.mechanism.linkage import Linkage

# URDF wants limits of every joint but an endless one, and the configuration may give none.
_LIMITS = {
    "prismatic": {"effort": 1000.0, "velocity": 10.0, "lower": -1.0, "upper": 1.0},
    "revolute": {"effort": 1000.0, "velocity": 10.0, "lower": -2.0 * pi, "upper": 2.0 * pi},
}


def written_urdf(name: str, skeleton: Linkage, choices: WritingChoices = ORDINARY) -> WrittenRobot:
    """Return the URDF of a mechanism; the root link is the base, floating or not.

    Args:
        name: The robot's name.
        skeleton: Its bodies.
        choices: Whether revolute joints without limits become `continuous`, which pinocchio gives
            two coordinates; and what is told of joints.
    """
    robot = Element("robot", {"name": name})
    for body_name, mass in zip(skeleton.body_names, skeleton.masses, strict=True):
        _add_inertial(added(robot, "link", name=body_name), mass)
    for frame in skeleton.frames:
        added(robot, "link", name=frame.name)
    for link, parent in skeleton.links():
        body = skeleton.bodies[link]
        own = choices.joints.get(body.joint, UNTOLD)
        kind = "continuous" if _is_endless(body.kind, own, choices) else body.kind
        joint = added(robot, "joint", name=body.joint, type=kind)
        _add_ends(joint, skeleton.body_names[parent], body.name, body.placement)
        added(joint, "axis", xyz=_numbers(0.0, 0.0, 1.0))
        _add_numbers(joint, "limit", _limits(kind, own))
        _add_numbers(joint, "dynamics", {"damping": own.damping, "friction": own.friction})
    for frame in skeleton.frames:
        joint = added(robot, "joint", name=f"{frame.name}_fixed", type="fixed")
        _add_ends(joint, skeleton.body_names[frame.body], frame.name, frame.pose)
    return WrittenRobot(document_text(robot), tuple(_remarks(skeleton, choices)))


def _remarks(skeleton: Linkage, choices: WritingChoices) -> Iterator[str]:
    kinds = zip(skeleton.joint_names, skeleton.joint_kinds, strict=True)
    told = choices.joints
    unlimited = [(n, kind) for n, kind in kinds if told.get(n, UNTOLD).limits == (None, None)]
    n_turning = sum(kind == "revolute" for _, kind in unlimited)
    if n_turning and not choices.endless_joints:
        joints = counted(n_turning, "revolute joint")
        way = "kindsl convert --continuous writes endless joints"
        yield f"{joints} got limits of a full turn each way; {way}"
    for name, kind in unlimited:
        if kind == "prismatic":
            yield f"the joint '{name}' got limits of -1 m and 1 m, which a URDF must give"
    yield from armature_dropped("URDF", skeleton.joint_names, choices.joints)
    yield from fixed_base_dropped(skeleton.base_name, choices)
    if skeleton.is_floating:
        yield f"the floating base '{skeleton.base_name}' became the root link, which some tools fix"


def _is_endless(kind: str, own: JointProperties, choices: WritingChoices) -> bool:
    return kind == "revolute" and choices.endless_joints and own.limits == (None, None)


def _limits(kind: str, own: JointProperties) -> dict[str, float | None]:
    """Return the attributes of a joint's limits; those that a URDF must have in any case."""
    told = {"effort": own.effort, "velocity": own.velocity}
    if kind == "continuous":
        return told if None not in told.values() else {}
    told |= {"lower": own.minimum, "upper": own.maximum}
    return {**_LIMITS[kind], **{name: value for name, value in told.items() if value is not None}}


def _add_numbers(joint: Element, tag: str, values: Mapping[str, float | None]) -> None:
    """Add an element with the attributes that have values, none if none has."""
    known = {name: _numbers(value) for name, value in values.items() if value is not None}
    if known:
        added(joint, tag, **known)


def _add_ends(joint: Element, parent: str, child: str, pose: RigidPose) -> None:
    added(joint, "parent", link=parent)
    added(joint, "child", link=child)
    _add_origin(joint, pose)


def _add_inertial(link: Element, body: MassDistribution) -> None:
    """Add URDF's inertial: about the centre of mass, along the link's axes."""
    if not body.mass and not any(body.moments):
        return
    inertial = added(link, "inertial")
    _add_origin(inertial, IDENTITY._replace(translation=body.com))
    added(inertial, "mass", value=_numbers(body.mass))
    Ix, Iy, Iz, Ixy, Ixz, Iyz = moments_about_com(body)
    tensor = {"ixx": Ix, "ixy": -Ixy, "ixz": -Ixz, "iyy": Iy, "iyz": -Iyz, "izz": Iz}
    added(inertial, "inertia", **{name: _numbers(value) for name, value in tensor.items()})


def _add_origin(element: Element, pose: RigidPose) -> None:
    angles = fixed_axis_angles(pose.rotation)
    added(element, "origin", xyz=_numbers(*pose.translation), rpy=_numbers(*angles))


def _numbers(*values: float) -> str:
    return " ".join(repr(value + 0.0) for value in values)
