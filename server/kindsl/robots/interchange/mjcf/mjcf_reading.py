"""MJCF to a robot description, out of what MuJoCo compiles; and the places of its numbers."""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from math import cos, sin
from pathlib import Path
from typing import Any

import numpy as np

from kindsl.language.semantics.parameters import JointProperties
from kindsl.language.text.phrases import listed
from kindsl.mechanics.rigid.body import MassDistribution
from kindsl.mechanics.rigid.pose import IDENTITY, RigidPose, Vector3, rotation_from_quaternion
from kindsl.robots.comparison.quantities import AXIS, INERTIA, POSE, TURNS
from kindsl.robots.interchange.format import FormatError, ReadingChoices, ReadRobot, told_joints
from kindsl.robots.interchange.mjcf.compiling import compiled, spec_of_file
from kindsl.robots.interchange.mjcf.losses import (
    ball_joints,
    joint_losses,
    losses,
    physics_losses,
    strip,
    unsupported,
)
from kindsl.robots.interchange.rigid_links import BaseKind, RigidLink, about_origin, robot_of_links
from kindsl.robots.interchange.written_numbers import FileNumbers, XmlNumbers

_WORLD = 0
_FREE, _SLIDE = 0, 2
# What has no mass in a document has next to none in MuJoCo, which moves no body without.
_DUST = 3e-14
_ORIENTATIONS = ("quat", "euler", "axisangle", "xyaxes", "zaxis")


def read_mjcf(path: Path, choices: ReadingChoices) -> ReadRobot:
    """Return the robot of an MJCF file.

    Args:
        path: The file, which may include others. Meshes are read where masses come from them.
        choices: Whether the root floats, free joint or not.

    Raises:
        FormatError: The file is unreadable or beyond the Kinematics-DSL.
        OSError: The file cannot be read.
        ModuleNotFoundError: mujoco is not installed.
    """
    try:
        read = _read(spec_of_file(path), path.stem, choices.floating)
        return read._replace(find_numbers=lambda: numbers_of_mjcf(path.read_bytes()))
    except UnicodeDecodeError as error:
        raise FormatError("not a readable MJCF: a name in it is not UTF-8") from error


def _read(spec: Any, name: str, floating: bool) -> ReadRobot:
    lost, refused = tuple(losses(spec)), [*unsupported(spec)]
    missing = strip(spec)
    refused += _missing_meshes(missing)
    model = compiled(spec)
    refused += ball_joints(model)
    roots, outside = _roots(model, refused)
    base: BaseKind = "floating" if floating or _is_free(model, roots[0]) else "fixed"
    links = _links(model, roots, base)
    robot, moved = robot_of_links(spec.modelname or name, base, links, "body")
    told = (*physics_losses(model), *joint_losses(model), *outside, *_joint_remarks(model), *moved)
    joints = [joint for joint in range(model.njnt) if model.jnt_type[joint] >= _SLIDE]
    own = told_joints((_joint_name(model, joint), _properties(model, joint)) for joint in joints)
    why, unknown = tuple(refused), frozenset(missing)
    notes = (*lost, *told)
    return ReadRobot(robot, notes, own, tells_base=True, refused=why, unknown=unknown)


def _missing_meshes(missing: Mapping[str, str]) -> Iterator[str]:
    """Yield why a robot can be shown alone whose meshes are not there."""
    for body, file in [*missing.items()][:1]:
        more = f", as {len(missing) - 1} more are" if len(missing) > 1 else ""
        yield f"the body '{body}' has its inertia by the mesh '{file}', which is missing{more}"


def _properties(model: Any, joint: int) -> JointProperties:
    """Return what is told of a joint; its values are ours, and so are its limits."""
    dof, effort = int(model.jnt_dofadr[joint]), float(model.jnt_actfrcrange[joint][1])
    lowest, highest = map(float, model.jnt_range[joint])
    is_limited = bool(model.jnt_limited[joint])
    return JointProperties(
        lowest if is_limited else None,
        highest if is_limited else None,
        effort if model.jnt_actfrclimited[joint] else None,
        armature=float(model.dof_armature[dof]) or None,
        damping=float(model.dof_damping[dof]) or None,
        friction=float(model.dof_frictionloss[dof]) or None,
    )


def _roots(model: Any, refused: list[str]) -> tuple[list[int], list[str]]:
    """Return the bodies that stand at the root, and what is said of those left out.

    The world is the root unless one body alone is in it that is free or has no joint.
    """
    tops = [b for b in range(1, model.nbody) if model.body_parentid[b] == _WORLD]
    free = [b for b in tops if _is_free(model, b)]
    if not free:
        is_base = len(tops) == 1 and model.body_jntnum[tops[0]] == 0
        return (tops if is_base else [_WORLD]), []
    others = [b for b in tops if b not in free and _moves(model, b)]
    if len(free) + len(others) > 1:
        told = listed(f"'{_name(model, b)}'" for b in (*free, *others)[:5])
        number = f"{len(free) + len(others)} moving root bodies, exactly one is required"
        refused.append(f"the MJCF has {number}: {told}")
        return [_WORLD], []
    dropped = [f"'{_name(model, b)}'" for b in tops if b not in free]
    what = "body" if len(dropped) == 1 else "bodies"
    return free, [f"the {what} {listed(dropped)}, fixed to the world, dropped"] if dropped else []


def _is_free(model: Any, body: int) -> bool:
    return body != _WORLD and any(model.jnt_type[j] == _FREE for j in _joints(model, body))


def _moves(model: Any, body: int) -> bool:
    """Return whether something moves in a body's subtree."""
    below = {body}
    for b in range(body, model.nbody):
        if model.body_parentid[b] in below:
            below.add(b)
    return any(model.body_jntnum[b] for b in below)


def _joints(model: Any, body: int) -> range:
    first = model.body_jntadr[body]
    return range(first, first + model.body_jntnum[body])


def _links(model: Any, roots: list[int], base: BaseKind) -> list[RigidLink]:
    """Return the links, parents first; a body with several joints is several links."""
    root = roots[0]
    world_T_root = _transform(model.body_pos[root], model.body_quat[root])
    frames = _sites(model, root)
    if root != _WORLD and base == "fixed":
        frames += tuple(_world_sites(model, world_T_root.inverse()))
    first = RigidLink(_name(model, root), parent_T_joint=world_T_root)
    links = [replace(first, body=_body(model, root), frames=frames)]
    place = {root: 0}
    for body in range(root + 1, model.nbody):
        parent = int(model.body_parentid[body])
        if parent in place:
            links += _links_of_body(model, body, place[parent], len(links))
            place[body] = len(links) - 1
    return links


def _links_of_body(model: Any, body: int, parent: int, n_links: int) -> Iterator[RigidLink]:
    name, joints = _name(model, body), list(_joints(model, body))
    T = _transform(model.body_pos[body], model.body_quat[body])
    if not joints:
        carried, sites = _body(model, body), _sites(model, body)
        yield RigidLink(name, parent, f"{name}_fixed", "fixed", parent_T_joint=T,
                        body=carried, frames=sites)  # fmt: skip
        return
    for number, joint in enumerate(joints):
        link = _jointed(model, joint, T, has_own_body=number == 0)
        if joint == joints[-1]:
            link = replace(link, name=name, body=_body(model, body), frames=_sites(model, body))
        else:
            link = replace(link, name=f"{name}_{link.joint}")
        yield replace(link, parent=parent if number == 0 else n_links + number - 1)
        T = IDENTITY


def _jointed(model: Any, joint: int, parent_T_body: RigidPose, *, has_own_body: bool) -> RigidLink:
    """Return a link without name and mass; MuJoCo's joint values become ours.

    MuJoCo turns a body about an anchor in its frame, and by the joint value less `ref`. The pose
    that is written is the body's, and where it has another joint already, the anchor.
    """
    axis, kind = model.jnt_axis[joint], model.jnt_type[joint]
    slides = kind == _SLIDE
    if kind < _SLIDE:
        return RigidLink("", None, "", "fixed", parent_T_joint=parent_T_body)
    body_T_anchor = IDENTITY if slides else _translation(model.jnt_pos[joint])
    ref = float(model.qpos0[model.jnt_qposadr[joint]])
    back = _translation(-ref * axis) if slides else _turn(axis, -ref)
    return RigidLink(
        "",
        None,
        _joint_name(model, joint),
        "prismatic" if slides else "revolute",
        _triple(axis),
        parent_T_body.then(body_T_anchor).then(back),
        body_T_anchor.inverse(),
        written_T_joint=body_T_anchor.then(back) if has_own_body else back,
    )


def _body(model: Any, body: int) -> MassDistribution | None:
    mass, moments = float(model.body_mass[body]), model.body_inertia[body]
    if body == _WORLD or (mass <= _DUST and np.all(moments <= _DUST)):
        return None
    body_T_inertial = _transform(model.body_ipos[body], model.body_iquat[body])
    return about_origin(mass, (*_triple(moments), 0.0, 0.0, 0.0), body_T_inertial)


def _sites(model: Any, body: int) -> tuple[tuple[str, RigidPose], ...]:
    sites = [s for s in range(model.nsite) if model.site_bodyid[s] == body]
    poses = (_transform(model.site_pos[s], model.site_quat[s]) for s in sites)
    names = (model.site(s).name or f"site_{s}" for s in sites)
    return tuple(zip(names, poses, strict=True))


def _world_sites(model: Any, root_T_world: RigidPose) -> Iterator[tuple[str, RigidPose]]:
    for name, pose in _sites(model, _WORLD):
        yield name, root_T_world.then(pose)


def _joint_remarks(model: Any) -> Iterator[str]:
    for body in range(1, model.nbody):
        number = int(model.body_jntnum[body])
        if number > 1:
            yield (
                f"the body '{_name(model, body)}' has {number} joints: "
                "links without mass stand between them"
            )


def _name(model: Any, body: int) -> str:
    return str(model.body(body).name) or f"body_{body}"


def _joint_name(model: Any, joint: int) -> str:
    return str(model.joint(joint).name) or f"joint_{joint}"


def _transform(position: Any, quaternion: Any) -> RigidPose:
    w, x, y, z = map(float, quaternion)
    return RigidPose(rotation_from_quaternion(x, y, z, w) or IDENTITY.rotation, _triple(position))


def _translation(position: Any) -> RigidPose:
    return IDENTITY._replace(translation=_triple(position))


def _turn(axis: Any, angle: float) -> RigidPose:
    return _transform(np.zeros(3), (cos(0.5 * angle), *(sin(0.5 * angle) * axis)))


def _triple(values: Any) -> Vector3:
    x, y, z = map(float, values)
    return x, y, z


def numbers_of_mjcf(content: bytes | str) -> FileNumbers:
    """Return the numbers of inertias along their bodies' axes, and of what carries the bodies."""
    xml = XmlNumbers(content)
    for body in xml.root.iter("body"):
        name, inertial = body.get("name") or "", body.find("inertial")
        xml.keep("link", name, ("mass",), xml.of_attribute(inertial, "mass"))
        xml.keep("link", name, INERTIA[1:4], xml.of_attribute(inertial, "pos"))
        xml.keep("link", name, INERTIA[4:7], xml.of_attribute(inertial, "diaginertia"))
        xml.keep("link", name, INERTIA[4:], xml.of_attribute(inertial, "fullinertia"))
        for placed in (body, *body.iterfind("site")):
            own = placed.get("name") or ""
            xml.keep_place("frame", own, POSE[:3], xml.of_attribute(placed, "pos"))
            _keep_turns(xml, "frame", own, placed)
        joints = [j for j in body.iterfind("joint") if j.get("type") != "free"]
        for joint, placed in zip(joints, [body, *joints[1:]], strict=False):
            # The body says where its first joint is, and the joint's own attributes what is left.
            name, own = joint.get("name") or "", xml.of_attribute(joint, "pos")
            xml.keep_place("joint", name, POSE[:3], own)
            xml.keep_place("joint", name, (*TURNS, AXIS), xml.of_attribute(joint, "axis"))
            xml.keep("joint", name, POSE[:3], xml.of_attribute(placed, "pos"))
            _keep_turns(xml, "joint", name, placed)
    return xml.found


def _keep_turns(xml: XmlNumbers, kind: str, name: str, placed: Any) -> None:
    for attribute in _ORIENTATIONS:
        xml.keep_place(kind, name, TURNS, xml.of_attribute(placed, attribute))
