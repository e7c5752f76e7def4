"""Bodies of a document that is not whole: what is missing is zero, what is lost is left out."""

import math
from collections.abc import Iterator, Mapping, Sequence
from itertools import chain

import numpy as np

from kindsl.dynamics.bodies import Bodies, Frame, JointKind
from kindsl.mechanism.numbering import numbered_by_tree
from kindsl.semantics.declarations import MOMENTS, Link, Pose, Vector
from kindsl.semantics.expressions import Expression
from kindsl.semantics.model import Model
from kindsl.spatial.arrays import Array
from kindsl.spatial.inertia import move_inertia
from kindsl.spatial.transforms import rotation_from_intrinsic_xyz

_KINDS: dict[str, JointKind] = {"revolute": "revolute", "prismatic": "prismatic"}

MassProperties = tuple[float, Array, Array]


def bodies_as_far_as_known(model: Model, values: Mapping[str, float]) -> Bodies | None:
    """Return the bodies that the base carries, None if there is not even one.

    Args:
        model: A document's model, however broken.
        values: Of parameters by name, and of constants by `<name>`.
    """
    if model.base is None:
        return None
    edges = [
        (edge.predecessor, edge.link, edge.joint)
        for edge in numbered_by_tree(model)
        if edge.link is not None and edge.joint is not None
    ]
    links = [model.base, *(link for _, link, _ in edges)]
    poses = [_pose(joint.pose, values) for _, _, joint in edges]
    mass_properties = [_mass_properties(link, values) for link in links]
    try:
        return Bodies(
            base_name=str(model.base.name),
            link_names=tuple(str(link.name) for _, link, _ in edges),
            joint_names=tuple(str(joint.name) for _, _, joint in edges),
            joint_kinds=tuple(_KINDS[joint.kind] for _, _, joint in edges),
            parents=tuple(links.index(predecessor) for predecessor, _, _ in edges),
            p_R_j=np.array([R for R, _ in poses]).reshape(-1, 3, 3),
            p_r_j=np.array([r for _, r in poses]).reshape(-1, 3),
            masses=np.array([mass for mass, _, _ in mass_properties]),
            coms=np.array([com for _, com, _ in mass_properties]),
            inertias=np.array([inertia for _, _, inertia in mass_properties]),
            is_floating=model.base.is_floating,
            frames=tuple(_frames(links, values)),
        )
    except ValueError:
        # No link at all, or names that are used twice: there is no tree to draw.
        return None


def _frames(links: Sequence[Link], values: Mapping[str, float]) -> Iterator[Frame]:
    taken = {str(link.name) for link in links}
    for body, frame in chain.from_iterable(
        ((i, frame) for frame in link.frames) for i, link in enumerate(links)
    ):
        if str(frame.name) not in taken:
            taken.add(str(frame.name))
            yield Frame(str(frame.name), body, *_pose(frame.pose, values))


def _pose(pose: Pose, values: Mapping[str, float]) -> tuple[Array, Array]:
    r = _vector(pose.translation, values)
    return rotation_from_intrinsic_xyz(_vector(pose.rotation, values)), r


def _mass_properties(link: Link, values: Mapping[str, float]) -> MassProperties:
    """Return mass, CoM and inertia tensor about the link frame; zeros where they are not whole."""
    nothing = 0.0, np.zeros(3), np.zeros((3, 3))
    inertia = link.inertia
    if inertia is None or inertia.mass is None or inertia.com is None:
        return nothing
    numbers = [_value(inertia.moments.get(name), values) for name in MOMENTS]
    mass = _value(inertia.mass, values)
    if mass is None or any(number is None for number in numbers):
        return nothing
    Ix, Iy, Iz, Ixy, Ixz, Iyz = (number or 0.0 for number in numbers)
    tensor = np.array([[Ix, -Ixy, -Ixz], [-Ixy, Iy, -Iyz], [-Ixz, -Iyz, Iz]])
    com = _vector(inertia.com, values)
    if inertia.frame is None:
        return mass, com, tensor
    frame = next((frame for frame in link.frames if frame.name == inertia.frame), None)
    if frame is None:
        return nothing
    return mass, *move_inertia(np.asarray(mass), com, tensor, *_pose(frame.pose, values))


def _vector(vector: Vector | None, values: Mapping[str, float]) -> Array:
    components = vector.components[:3] if vector is not None else ()
    numbers = [_value(component, values) or 0.0 for component in components]
    return np.array([*numbers, *[0.0] * (3 - len(numbers))])


def _value(expression: Expression | None, values: Mapping[str, float]) -> float | None:
    number = None if expression is None else expression.value(values)
    return number if number is not None and math.isfinite(number) else None
