"""From links, joints and parameter values to the arrays that the dynamics work on."""

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from kindsl.dynamics.bodies import Bodies, Frame, JointKind
from kindsl.mechanism.errors import ModelError, UnboundParameterError
from kindsl.mechanism.numbering import require_base
from kindsl.semantics.declarations import MOMENTS, Inertia, Link, Pose, Vector
from kindsl.semantics.expressions import ConstantUse, Expression, symbols
from kindsl.semantics.kinematic_tree import Edge
from kindsl.semantics.model import Model
from kindsl.semantics.places import Located
from kindsl.spatial.arrays import Array
from kindsl.spatial.inertia import move_inertia
from kindsl.spatial.transforms import rotation_from_intrinsic_xyz

_KINDS: dict[str, JointKind] = {"revolute": "revolute", "prismatic": "prismatic"}


def bodies_of(model: Model, edges: Sequence[Edge], values: Mapping[str, float]) -> Bodies:
    """Return the numbered bodies.

    Args:
        model: The document's model.
        edges: The supporting edge of each link, in the order of the bodies 1 to n.
        values: Of parameters by name, and of constants by `<name>`.

    Raises:
        UnboundParameterError: A value needs a parameter that has none.
        ModelError: A value is missing or not defined, or a name stands for two things.
    """
    base = require_base(model)
    links = [edge.link for edge in edges if edge.link is not None]
    joints = [edge.joint for edge in edges if edge.joint is not None]
    index = {body: i for i, body in enumerate([base, *links])}
    poses = [_pose(f"joint '{j.name}'", j, j.pose, values) for j in joints]
    masses, coms, inertias = _mass_properties([base, *links], values)
    try:
        return Bodies(
            base_name=str(base.name),
            link_names=tuple(str(link.name) for link in links),
            joint_names=tuple(str(joint.name) for joint in joints),
            joint_kinds=tuple(_KINDS[joint.kind] for joint in joints),
            parents=tuple(index[edge.predecessor] for edge in edges),
            p_R_j=np.array([R for R, _ in poses]).reshape(-1, 3, 3),
            p_r_j=np.array([r for _, r in poses]).reshape(-1, 3),
            masses=masses,
            coms=coms,
            inertias=inertias,
            is_floating=base.is_floating,
            frames=tuple(_frames(index, values)),
        )
    except ValueError as error:
        raise error if isinstance(error, ModelError) else ModelError(str(error), base) from error


def _frames(index: Mapping[Link, int], values: Mapping[str, float]) -> Iterator[Frame]:
    """Yield the optional frames; one whose name is taken is called `link.frame`."""
    taken = {str(body.name) for body in index}
    for body, number in index.items():
        for frame in body.frames:
            R, r = _pose(f"frame '{frame.name}'", frame, frame.pose, values)
            name = str(frame.name) if frame.name not in taken else f"{body.name}.{frame.name}"
            if name not in taken:
                taken.add(name)
                yield Frame(name, number, R, r)


def _mass_properties(
    bodies: Sequence[Link], values: Mapping[str, float]
) -> tuple[Array, Array, Array]:
    rows = [_inertia(body, values) for body in bodies]
    masses = np.array([mass for mass, _, _ in rows])
    return masses, np.array([com for _, com, _ in rows]), np.array([tensor for *_, tensor in rows])


def _inertia(body: Link, values: Mapping[str, float]) -> tuple[float, Array, Array]:
    """Return mass, CoM and inertia tensor about the link frame; zeros where none is given.

    A fixed base's inertia does not matter, so it may hang on unbound parameters.
    """
    nothing = 0.0, np.zeros(3), np.zeros((3, 3))
    if body.inertia is None:
        return nothing
    try:
        return _given_inertia(body, body.inertia, values)
    except UnboundParameterError:
        if body.is_base and not body.is_floating:
            return nothing
        raise


def _given_inertia(
    body: Link, inertia: Inertia, values: Mapping[str, float]
) -> tuple[float, Array, Array]:
    owner = f"inertia of '{body.name}'"
    mass = _number(owner, "mass", inertia.mass, inertia, values)
    com = _vector(owner, "CoM", inertia.com, inertia, values)
    Ix, Iy, Iz, Ixy, Ixz, Iyz = (
        _number(owner, name, inertia.moments.get(name), inertia, values) for name in MOMENTS
    )
    tensor = np.array([[Ix, -Ixy, -Ixz], [-Ixy, Iy, -Iyz], [-Ixz, -Iyz, Iz]])
    if inertia.frame is None:
        return mass, com, tensor
    frame = next((f for f in body.frames if f.name == inertia.frame), None)
    if frame is None:
        raise ModelError(f"'{body.name}' has no frame '{inertia.frame}'", inertia.frame)
    R, r = _pose(f"frame '{frame.name}'", frame, frame.pose, values)
    return mass, *move_inertia(np.asarray(mass), com, tensor, R, r)


def _pose(owner: str, at: Located, pose: Pose, values: Mapping[str, float]) -> tuple[Array, Array]:
    r = _vector(owner, "translation", pose.translation, at, values)
    angles = _vector(owner, "rotation", pose.rotation, at, values)
    return rotation_from_intrinsic_xyz(angles), r


def _vector(
    owner: str,
    what: str,
    vector: Vector | None,
    at: Located,
    values: Mapping[str, float],
) -> Array:
    if vector is None or len(vector.components) != 3:
        raise ModelError(f"{owner}: '{what}' needs three components", vector or at)
    return np.array([_number(owner, what, c, at, values) for c in vector.components])


def _number(
    owner: str,
    what: str,
    value: Expression | None,
    at: Located,
    values: Mapping[str, float],
) -> float:
    if value is None:
        raise ModelError(f"{owner}: '{what}' is missing", at)
    number = value.value(values)
    if number is not None:
        return number
    unbound = [s.name for s in symbols(value) if not isinstance(s, ConstantUse)]
    missing = [name for name in unbound if name not in values]
    if missing:
        raise UnboundParameterError(tuple(str(name) for name in missing), missing[0])
    raise ModelError(f"{owner}: '{what}' has no value: {value.text}", value)
