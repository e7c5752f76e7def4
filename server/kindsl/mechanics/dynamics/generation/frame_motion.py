"""Velocities and accelerations of frames, for tracing."""

from collections.abc import Sequence

from kindsl.mechanics.dynamics.generation.function import Inputs
from kindsl.mechanics.dynamics.generation.inverse_dynamics import body_motions
from kindsl.mechanics.dynamics.generation.mass_moments import acceleration_field
from kindsl.mechanics.dynamics.generation.robot import PlacedFrame
from kindsl.mechanics.dynamics.generation.tree import Tree, joint_motions
from kindsl.mechanics.dynamics.generation.vectors import (
    ZERO,
    Vector,
    add,
    cross,
    transform,
    transpose,
)


def body_velocities(tree: Tree, x: Inputs) -> list[tuple[Vector, Vector]]:
    """Return angular velocity and that of its origin of each body in its own, base first."""
    joints, w, v = joint_motions(tree, x.q), [x.v0[:3]], [x.v0[3:]]
    for i in tree.links():
        parent, joint, along = tree.parents[i], joints[i], [0.0, 0.0, x.qd[i - 1]]
        is_revolute = joint.kind == "revolute"
        v_i = joint.to_link(add(v[parent], cross(w[parent], joint.offset)))
        w.append(add(joint.to_link(w[parent]), along if is_revolute else ZERO))
        v.append(add(v_i, ZERO if is_revolute else along))
    return list(zip(w, v, strict=True))


def frame_velocity(velocities: Sequence[tuple[Vector, Vector]], frame: PlacedFrame) -> Vector:
    """Return a frame's velocity in its own coordinates, at its origin, angular part first."""
    (w, v), E = velocities[frame.body], transpose(frame.R)
    v = add(v, cross(w, frame.r))
    return [*transform(E, w), *transform(E, v)]


def frame_accelerations(tree: Tree, x: Inputs, frames: tuple[PlacedFrame, ...]) -> list[Vector]:
    """Return frames' accelerations in their own coordinates, of their origins as points."""
    a = add(x.a0[3:], cross(x.v0[:3], x.v0[3:]))
    motions = body_motions(tree, joint_motions(tree, x.q), x, a)
    found = []
    for frame in frames:
        E, wd = transpose(frame.R), motions.wd[frame.body]
        W = acceleration_field(motions.w[frame.body], wd)
        linear = add(motions.a[frame.body], transform(W, frame.r))
        found.append([*transform(E, wd), *transform(E, linear)])
    return found
