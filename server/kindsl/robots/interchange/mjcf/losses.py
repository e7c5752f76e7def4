"""Parts of an MJCF beyond poses and masses: refused if they change the tree, else noted."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from kindsl.language.text.phrases import counted
from kindsl.mechanics.dynamics.quantities import STANDARD_GRAVITY
from kindsl.robots.interchange.format import gravity_dropped
from kindsl.robots.interchange.mjcf.writing import DUST

# What is counted and taken away before the model is compiled, in an order that leaves no reference.
_DROPPED = (
    ("keys", "keyframe"),
    ("sensors", "sensor"),
    ("actuators", "actuator"),
    ("tendons", "tendon"),
    ("pairs", "contact pair"),
    ("excludes", "contact exclusion"),
    ("skins", "skin"),
    ("cameras", "camera"),
    ("lights", "light"),
    ("tuples", "tuple"),
)
_JOINT_FORCES = (
    ("springs", ("jnt_stiffness", "jnt_stiffnesspoly")),
    ("damping other than in proportion to speed", ("dof_dampingpoly",)),
)
_FREE_FORCES = (
    ("damping", ("dof_damping",)),
    ("dry friction", ("dof_frictionloss",)),
    ("armature", ("dof_armature",)),
)
_FREE = 0
_BALL = 1
_LOOPS = ("connect", "weld")


def losses(spec: Any) -> Iterator[str]:
    """Yield a note on each dropped part."""
    for name, noun in _DROPPED:
        if n := len(getattr(spec, name)):
            yield f"{counted(n, noun)} dropped: not supported"
    n_drawn = sum(len(body.geoms) > 0 for body in spec.bodies)
    if n_drawn:
        yield f"geometry and meshes of {_bodies(n_drawn)} dropped"
    for equality in _of_the_robot(spec):
        if _kind(equality) not in _LOOPS:
            yield f"{_named(equality)} dropped: the joints are now independent"
    for body in _targets(spec):
        yield f"the mocap body '{body.name}' dropped: it is a target, no part of the robot"


def strip(spec: Any) -> dict[str, str]:
    """Take away what neither moves nor weighs, so that its files need not be there.

    Returns:
        Meshes that are not there and that moving bodies would weigh by, by the bodies' names; they
        are taken away as well.
    """
    import mujoco

    for name, _ in _DROPPED:
        for element in list(getattr(spec, name)):
            spec.delete(element)
    for element in (*spec.equalities, *spec.flexes):
        spec.delete(element)
    for body in _targets(spec):
        spec.delete(body)
    missing = _without_missing_meshes(spec)
    always = mujoco.mjtInertiaFromGeom.mjINERTIAFROMGEOM_TRUE
    for body in spec.bodies:
        if body == spec.worldbody or (
            body.explicitinertial and body.compiler.inertiafromgeom != always
        ):
            for geom in list(body.geoms):
                spec.delete(geom)
    _strip_assets(spec)
    spec.compiler.fusestatic = False
    return missing


def _without_missing_meshes(spec: Any) -> dict[str, str]:
    """Take away shapes whose mesh is not there; what would weigh by it weighs next to nothing."""
    folder = Path(spec.modelfiledir, spec.meshdir)
    files = {mesh.name or Path(mesh.file).stem: mesh.file for mesh in spec.meshes}
    missing = {n: file for n, file in files.items() if file and not (folder / file).is_file()}
    bodies: dict[str, str] = {}
    for body, moves in _with_motion(spec.worldbody) if missing else ():
        gone = [geom for geom in body.geoms if geom.meshname in missing]
        files_of_mass = [missing[geom.meshname] for geom in gone if geom.mass != 0.0]
        if moves and files_of_mass and not body.explicitinertial:
            bodies[body.name] = Path(files_of_mass[0]).name
            body.explicitinertial, body.mass, body.inertia = True, DUST, [DUST] * 3
        for geom in gone:
            spec.delete(geom)
    return bodies


def _with_motion(body: Any, moves: bool = False) -> Iterator[tuple[Any, bool]]:
    """Yield a body and all below it, with whether a joint moves each."""
    moves = moves or len(body.joints) > 0
    yield body, moves
    for each in body.bodies:
        yield from _with_motion(each, moves)


def joint_losses(model: Any) -> Iterator[str]:
    """Yield a note on each dropped property of joints."""
    for what, names in _JOINT_FORCES:
        if n := len({joint for name in names for joint in _joints_with(model, name)}):
            yield f"{what} of {counted(n, 'joint')} dropped: not supported"
    for what, names in _FREE_FORCES:
        joints = {joint for name in names for joint in _joints_with(model, name)}
        if any(model.jnt_type[joint] == _FREE for joint in joints):
            yield f"{what} of the floating base dropped: not supported"


def _joints_with(model: Any, name: str) -> set[int]:
    """Return the joints with a number other than zero; MuJoCo's versions have not all of them."""
    rows = [int(row) for row, value in enumerate(getattr(model, name, ())) if np.any(value)]
    return {int(model.dof_jntid[row]) for row in rows} if name.startswith("dof") else set(rows)


def physics_losses(model: Any) -> Iterator[str]:
    """Yield a note on each dropped force on all bodies."""
    import mujoco

    is_off = bool(model.opt.disableflags & mujoco.mjtDisableBit.mjDSBL_GRAVITY)
    gravity = (0.0, 0.0, 0.0) if is_off else tuple(map(float, model.opt.gravity))
    if gravity != STANDARD_GRAVITY:
        yield gravity_dropped(gravity)
    if n := sum(value != 0.0 for value in model.body_gravcomp):
        yield f"gravity compensation of {_bodies(n)} dropped: not supported"
    if model.opt.density or model.opt.viscosity:
        yield "forces of the fluid around the bodies dropped: not supported"


def ball_joints(model: Any) -> Iterator[str]:
    """Yield that joints are ball joints."""
    for joint in range(model.njnt):
        if model.jnt_type[joint] == _BALL:
            name, body = model.joint(joint).name, model.body(model.jnt_bodyid[joint]).name
            told = f"the joint '{name}'" if name else f"a joint of the body '{body}'"
            yield f"{told} is a ball joint, which the language does not support"


def _strip_assets(spec: Any) -> None:
    used = {geom.meshname for geom in spec.geoms} | {geom.hfieldname for geom in spec.geoms}
    for geom in spec.geoms:
        geom.material = ""
    for site in spec.sites:
        site.material = ""
    for name in ("materials", "textures"):
        for element in list(getattr(spec, name)):
            spec.delete(element)
    for name in ("meshes", "hfields"):
        for element in list(getattr(spec, name)):
            if element.name not in used:
                spec.delete(element)


def unsupported(spec: Any) -> Iterator[str]:
    """Yield which bodies deform, and which equalities close loops: a robot is shown without."""
    for flex in spec.flexes:
        yield f"the body '{flex.name}' deforms (flex), which the language does not support"
    for equality in _of_the_robot(spec):
        if _kind(equality) in _LOOPS:
            yield f"{_named(equality)} closes a kinematic loop, which the language does not support"


def _targets(spec: Any) -> list[Any]:
    """Return the bodies that a program places for others to follow, and that carry no joint."""
    return [body for body in spec.bodies if body.mocap and _is_rigid(body)]


def _is_rigid(body: Any) -> bool:
    return not len(body.joints) and all(map(_is_rigid, body.bodies))


def _of_the_robot(spec: Any) -> list[Any]:
    """Return the equalities that hold no body to a target."""
    targets = {body.name for body in _targets(spec) if body.name}
    return [e for e in spec.equalities if targets.isdisjoint((e.name1, e.name2))]


def _named(equality: Any) -> str:
    named = f" '{equality.name}'" if equality.name else ""
    ends = " and ".join(f"'{name}'" for name in (equality.name1, equality.name2) if name)
    return f"the equality{named} ({_kind(equality)} of {ends})"


def _kind(equality: Any) -> str:
    return str(equality.type).rpartition("mjEQ_")[2].lower()


def _bodies(number: int) -> str:
    return "1 body" if number == 1 else f"{number} bodies"
