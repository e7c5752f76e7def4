"""A skeleton to SDF: every link at its joint, every joint in its parent link."""

from collections.abc import Iterator
from xml.etree.ElementTree import Element

from kindsl.language.semantics.parameters import UNTOLD
from kindsl.mechanics.rigid.body import (
    ROUNDING_OF_MOMENTS,
    MassDistribution,
    eigensystem,
    moments_about_com,
    principal_moments,
    second_moments_about_com,
)
from kindsl.mechanics.rigid.pose import IDENTITY, RigidPose
from kindsl.robots.interchange.format import (
    WritingChoices,
    WrittenRobot,
    armature_dropped,
    fixed_base_dropped,
)
from kindsl.robots.interchange.sdf.frame_graph import WORLD
from kindsl.robots.interchange.sdf.joint_properties import add_properties
from kindsl.robots.interchange.xml_writing import added, document_text, numbers, quaternion
from kindsl.robots.mechanism.linkage import Linkage

# The first version whose poses may be quaternions, which keep every rotation exact.
_VERSION = "1.9"
_WELD = ("weld", "world_fixed")  # the joint that fixes the base


def written_sdf(name: str, skeleton: Linkage, choices: WritingChoices) -> WrittenRobot:
    """Return the SDF of a mechanism; a fixed base has a fixed joint to the world.

    Args:
        name: The robot's name.
        skeleton: Its bodies.
        choices: Joint properties to write.
    """
    names = _names(skeleton)
    body_names = [names["link", n] for n in skeleton.body_names]
    root = Element("sdf", {"version": _VERSION})
    model = added(root, "model", name=name, canonical_link=body_names[0])
    base = added(model, "link", name=body_names[0])
    if skeleton.is_floating:
        _add_inertial(base, skeleton.masses[0])
    else:
        _add_joint(model, names[_WELD], "fixed", WORLD, body_names[0])
    for link, parent in skeleton.links():
        axis = _add_link(model, skeleton, names, link, body_names[parent])
        add_properties(axis, choices.joints.get(skeleton.joint_names[link - 1], UNTOLD))
    for frame in skeleton.frames:
        attached = body_names[frame.body]
        element = added(model, "frame", name=names["frame", frame.name], attached_to=attached)
        _add_pose(element, frame.pose)
    renamed = (
        f"the {kind} '{old}' is now '{new}': names are unique in SDF"
        for (kind, old), new in names.items()
        if old != new and (kind, old) != _WELD
    )
    dropped = (
        *armature_dropped("SDF", skeleton.joint_names, choices.joints),
        *fixed_base_dropped(skeleton.base_name, choices),
    )
    return WrittenRobot(document_text(root), (*renamed, *dropped, *_refused_elsewhere(skeleton)))


def _names(skeleton: Linkage) -> dict[tuple[str, str], str]:
    """Return a name for each kind and name, unique among all; of the joint to the world too."""
    things = [("link", name) for name in skeleton.body_names]
    things += [("joint", name) for name in skeleton.joint_names]
    things += [("frame", frame.name) for frame in skeleton.frames]
    taken = {WORLD}
    names: dict[tuple[str, str], str] = {}
    for kind, name in (*things, _WELD):
        free = name.replace("::", "_")
        while free in taken:
            free += f"_{kind}"
        taken.add(free)
        names[kind, name] = free
    return names


def _add_link(
    model: Element, skeleton: Linkage, names: dict[tuple[str, str], str], link: int, parent: str
) -> Element:
    """Add a link and its joint; return the joint's axis."""
    body = skeleton.bodies[link]
    name, joint_name = names["link", body.name], names["joint", body.joint]
    element = added(model, "link", name=name)
    added(element, "pose", relative_to=joint_name)
    _add_inertial(element, skeleton.masses[link])
    joint = _add_joint(model, joint_name, body.kind, parent, name)
    _add_pose(joint, body.placement, relative_to=parent)
    axis = added(joint, "axis")
    added(axis, "xyz").text = "0 0 1"
    return axis


def _add_joint(model: Element, name: str, kind: str, parent: str, child: str) -> Element:
    joint = added(model, "joint", name=name, type=kind)
    added(joint, "parent").text = parent
    added(joint, "child").text = child
    return joint


def _add_inertial(link: Element, body: MassDistribution) -> None:
    """Add mass and inertia about the centre of mass, along the link's axes."""
    inertial = added(link, "inertial")
    if any(body.com):
        added(inertial, "pose").text = f"{numbers(body.com)} 0 0 0"
    added(inertial, "mass").text = numbers([body.mass])
    inertia = added(inertial, "inertia")
    Ix, Iy, Iz, Ixy, Ixz, Iyz = moments_about_com(body)
    tensor = {"ixx": Ix, "ixy": -Ixy, "ixz": -Ixz, "iyy": Iy, "iyz": -Iyz, "izz": Iz}
    for tag, value in tensor.items():
        added(inertia, tag).text = numbers([value])


def _add_pose(element: Element, pose: RigidPose, **reference: str) -> None:
    position = numbers(pose.translation)
    if pose.rotation == IDENTITY.rotation:
        added(element, "pose", **reference).text = f"{position} 0 0 0"
        return
    turned = added(element, "pose", rotation_format="quat_xyzw", **reference)
    turned.text = f"{position} {numbers(quaternion(pose.rotation))}"


def _refused_elsewhere(skeleton: Linkage) -> Iterator[str]:
    for index, (name, body) in enumerate(zip(skeleton.body_names, skeleton.masses, strict=True)):
        if index == 0 and not skeleton.is_floating:
            continue
        pairs = eigensystem(second_moments_about_com(body))
        moments = principal_moments(pairs)
        is_broken = pairs[0].value < -ROUNDING_OF_MOMENTS * moments[2]
        if body.mass == 0.0 and not any(moments):
            yield f"the link '{name}' has no mass: other tools refuse it"
        elif body.mass <= 0.0 or moments[0] <= 0.0 or is_broken:
            yield f"inertia of '{name}' is physically impossible: other tools refuse it"
