"""SDF to a robot description: one model, its links in a tree."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

from kindsl.language.text.groups import grouped
from kindsl.language.text.phrases import listed
from kindsl.mechanics.rigid.body import MassDistribution, Symmetric
from kindsl.mechanics.rigid.pose import IDENTITY, Z_AXIS, RigidPose, Vector3
from kindsl.robots.interchange.format import (
    AS_WRITTEN,
    FormatError,
    ReadingChoices,
    ReadRobot,
    told_joints,
)
from kindsl.robots.interchange.rigid_links import BaseKind, RigidLink, about_origin, robot_of_links
from kindsl.robots.interchange.sdf.elements import (
    defect,
    is_true,
    name_of,
    number_of,
    numbers_in,
    parsed,
    pose_of,
    text_of,
)
from kindsl.robots.interchange.sdf.frame_graph import MODEL, WORLD, FrameGraph, reference_of
from kindsl.robots.interchange.sdf.including import include, not_found, searched_folders
from kindsl.robots.interchange.sdf.joint_properties import joint_properties
from kindsl.robots.interchange.sdf.losses import losses, world_losses
from kindsl.robots.interchange.sdf.nesting import flatten
from kindsl.robots.interchange.sdf.numbers import numbers_of_sdf
from kindsl.robots.interchange.xml_reading import JOINT_KINDS, TENSOR, XmlElement

_UNIT: Symmetric = (1.0, 1.0, 1.0, 0.0, 0.0, 0.0)


def read_sdf(path: Path, choices: ReadingChoices) -> ReadRobot:
    """Return the robot of an SDF file, with the models that it includes."""
    searched = searched_folders(path, choices.model_paths)
    return robot_of_sdf(path.read_bytes(), path.stem, choices, searched)


def robot_of_sdf(
    text: bytes | str,
    name: str,
    choices: ReadingChoices = AS_WRITTEN,
    searched: Sequence[Path] = (),
) -> ReadRobot:
    """Return the robot of an SDF's text.

    Args:
        text: As in the file.
        name: What several models are called together.
        choices: Whether the root floats though it is fixed to the world.
        searched: Folders of the models that it includes.

    Raises:
        FormatError: The text is unreadable or beyond the Kinematics-DSL.
    """
    root = parsed(text)
    include(root, searched)
    refused: list[str] = []
    model, others = _one_model(root, searched, name, refused)
    flatten(model)
    graph = FrameGraph(model, root.get("version") or "")
    joints = _joints_by_child(model, graph, refused)
    start, is_fixed = _root(model, graph, joints, refused)
    base: BaseKind = "fixed" if is_fixed and not choices.floating else "floating"
    links = _links(model, graph, joints, start, base)
    robot, moved = robot_of_links(name_of(model), base, links)
    told = (
        *others,
        *world_losses(root),
        *losses(model),
        *_default_masses(model, start, base),
        *moved,
    )
    own = ((name_of(joint), joint_properties(joint)) for joint in model.iterfind("joint"))
    numbers = partial(numbers_of_sdf, text)
    properties, why = told_joints(own), tuple(refused)
    return ReadRobot(robot, told, properties, is_fixed, find_numbers=numbers, refused=why)


def _one_model(
    root: Any, searched: Sequence[Path], name: str, refused: list[str]
) -> tuple[Any, tuple[str, ...]]:
    """Return the model, or one of all, and what is said of others that are static."""
    models = [*root.findall("model"), *root.findall("world/model")]
    moving = [model for model in models if not is_true(model, "static")] if models[1:] else models
    missing = root.find("world/include")
    if missing is not None and not moving:
        raise not_found(missing, searched)
    if not models:
        raise FormatError("the SDF has no model, exactly one is required")
    if len(moving) != 1:
        line, number = models[1].sourceline, f"{len(models)} models, exactly one is required"
        told = listed(f"'{m.get('name')}'" for m in models[:5])
        refused.append(f"line {line}: the SDF has {number}: {told}")
        whole = XmlElement.beside(root, "model", name=name)
        for index, model in enumerate(models):
            if model.get("name") in [other.get("name") for other in models[:index]]:
                model.set("name", f"{model.get('name')}_{index + 1}")
        whole.extend((*models, *root.iterfind("world/frame"), *root.iterfind("world/joint")))
        _check_model(whole, whole, searched)
        return whole, ()
    _check_model(root, moving[0], searched)
    static = (f"'{name_of(model)}'" for model in models if model is not moving[0])
    return moving[0], tuple(f"the static model {name} dropped" for name in static)


def _check_model(root: Any, model: Any, searched: Sequence[Path]) -> None:
    """Raise where what a model is made of is not all in it."""
    joint = root.find("world/joint")
    if joint is not None:
        raise defect(joint, "is a joint of the world, which is not supported")
    for inclusion in model.iter("include"):
        raise not_found(inclusion, searched)
    for origin in model.iter("origin"):
        raise defect(origin, "is the pose of SDF before 1.2, which is not supported")
    if next(model.iter("link"), None) is None:
        raise defect(model, "has no link")


def _joints_by_child(model: Any, graph: FrameGraph, refused: list[str]) -> dict[str, Any]:
    """Return the joint that carries each link: of several one that is supported."""
    joints: dict[str, Any] = {}
    for joint in sorted(model.iterfind("joint"), key=lambda j: j.get("type") not in JOINT_KINDS):
        kind = joint.get("type")
        child = graph.link_of(text_of(joint, "child"), joint)
        if child == WORLD:
            raise defect(joint, "has the world as its child")
        if kind not in JOINT_KINDS:
            what = f"is a {kind} joint, which the language does not support"
            refused.append(str(defect(joint, what)))
        elif child in joints:
            what = f"gives link '{child}' a second parent after joint '{name_of(joints[child])}'"
            refused.append(str(defect(joint, what)))
        joints.setdefault(child, joint)
    return joints


def _root(
    model: Any, graph: FrameGraph, joints: Mapping[str, Any], refused: list[str]
) -> tuple[str, bool]:
    """Return the root, and whether it is fixed: the world, or a link that hangs on nothing else."""
    on_world = [child for child, joint in joints.items() if _parent(joint, graph) == WORLD]
    links = {name_of(link): link for link in model.iterfind("link")}
    # Some call a link so, where SDFormat has no other world.
    free = [n for n in links if n not in joints and not (on_world and n == WORLD)]
    if len(free) + bool(on_world) != 1:
        roots = [*(["the world"] if on_world else []), *(f"'{name}'" for name in free)]
        if not roots:
            raise FormatError(
                "the joints of the SDF close a kinematic loop, which the language does not support"
            )
        number = f"{len(roots)} root links, exactly one root link is required"
        line = links[free[-1]].sourceline
        refused.append(f"line {line}: the SDF has {number}: {listed(roots[:5])}")
        return WORLD, True
    if not on_world:
        return free[0], is_true(model, "static")
    welded = len(on_world) == 1 and joints[on_world[0]].get("type") == "fixed"
    return (on_world[0] if welded else WORLD), True


def _parent(joint: Any, graph: FrameGraph) -> str:
    return graph.link_of(text_of(joint, "parent"), joint)


def _links(
    model: Any, graph: FrameGraph, joints: Mapping[str, Any], start: str, base: BaseKind
) -> list[RigidLink]:
    elements = {n: link for link in model.iterfind("link") if (n := name_of(link)) != WORLD}
    frames = _frames(model, graph, start if base == "fixed" else WORLD)
    below = grouped((_parent(joint, graph), child) for child, joint in joints.items())
    world_T_start = IDENTITY if start == WORLD else graph.world_T(start, model)
    links = [RigidLink(start, parent_T_joint=world_T_start)]
    for name, element in elements.items() if start == WORLD else ():
        if name not in joints:
            placed = graph.world_T(name, element)
            links.append(RigidLink(name, 0, "", "fixed", parent_T_joint=placed))
    for index, link in enumerate(links):
        below_it = (child for child in below.get(link.name, ()) if child != start)
        links += [carried(joints[child], index, link.name, child, graph) for child in below_it]
    if len(links) != len(elements) + (start == WORLD):
        reached = {link.name for link in links}
        lost = next(name for name in elements if name not in reached)
        raise defect(elements[lost], "is in a kinematic loop, which the language does not support")
    masses = {name: mass_of(element) for name, element in elements.items()}
    return [
        replace(link, body=masses.get(link.name), frames=tuple(frames.get(link.name, ())))
        for link in links
    ]


def carried(joint: Any, index: int, parent: str, child: str, graph: FrameGraph) -> RigidLink:
    """Return a link without its mass; a joint of a kind that is not supported counts as fixed.

    Args:
        joint: The joint that carries it.
        index: The parent's among the links.
        parent: Name of the link, or the world, that the joint is attached to.
        child: Its own name.
        graph: The model's frames.
    """
    model_T_joint = graph.model_T(name_of(joint), joint)
    parent_T_joint = graph.model_T(parent, joint).inverse().then(model_T_joint)
    joint_T_child = model_T_joint.inverse().then(graph.model_T(child, joint))
    placing = graph.placing(joint)
    model_T_written = graph.model_T(name_of(placing), joint)
    model_T_origin = graph.model_T(reference_of(placing), joint)
    kind = JOINT_KINDS.get(joint.get("type"), "fixed")
    axis = Z_AXIS
    if kind != "fixed":
        axis = model_T_joint.inverse().turn(_axis_in_model(joint, graph))
    return RigidLink(
        child,
        index,
        name_of(joint),
        kind,
        axis,
        parent_T_joint,
        joint_T_child,
        graph.model_T(parent, joint).inverse().then(model_T_origin),
        model_T_written.inverse().then(model_T_joint),
    )


def _axis_in_model(joint: Any, graph: FrameGraph) -> Vector3:
    axis = joint.find("axis")
    xyz = None if axis is None else axis.find("xyz")
    x, y, z = Z_AXIS if xyz is None else numbers_in(xyz, 3)
    if not (x or y or z):
        raise defect(xyz, f"of joint '{name_of(joint)}' has no length", "KD005")
    frame = name_of(joint) if xyz is None else xyz.get("expressed_in")
    if not frame:
        is_in_model = graph.has_axes_in_model or is_true(axis, "use_parent_model_frame")
        frame = MODEL if is_in_model else name_of(joint)
    return graph.model_T(frame, joint).turn((x, y, z))


def _frames(model: Any, graph: FrameGraph, on_world: str) -> dict[str, list[tuple[str, RigidPose]]]:
    """Return the frames by the link that they are attached to, the world's by another name."""
    found: dict[str, list[tuple[str, RigidPose]]] = {}
    for frame in model.iterfind("frame"):
        name = name_of(frame)
        link = graph.link_of(name, frame)
        link = on_world if link == WORLD else link
        link_T_frame = graph.model_T(link, frame).inverse().then(graph.model_T(name, frame))
        found.setdefault(link, []).append((name, link_T_frame))
    return found


def mass_of(link: Any) -> MassDistribution:
    """Return a link's mass; SDFormat's default is 1 kg, and 1 kg m^2 about each axis."""
    inertial = link.find("inertial")
    if inertial is None:
        return about_origin(1.0, _UNIT, IDENTITY)
    if (inertial.get("auto") or "").lower() in ("1", "true"):
        raise defect(link, "takes its inertia from its shape (auto), which is not supported")
    pose = inertial.find("pose")
    if pose is not None and pose.get("relative_to"):
        what = "of an inertia is relative to another frame, which SDFormat refuses"
        raise defect(pose, what, "KD001")
    inertia = inertial.find("inertia")
    named = zip(TENSOR, _UNIT, strict=True)
    tensor = [x if inertia is None else number_of(inertia, tag, x) for tag, x in named]
    return about_origin(number_of(inertial, "mass", 1.0), tensor, pose_of(inertial))


def _default_masses(model: Any, start: str, base: BaseKind) -> Iterator[str]:
    for link in model.iterfind("link"):
        name = name_of(link)
        if link.find("inertial") is None and (name != start or base == "floating"):
            yield f"the link '{name}' has no inertia: SDFormat's default is 1 kg"
