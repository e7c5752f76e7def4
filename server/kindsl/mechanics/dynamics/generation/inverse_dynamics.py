"""Inverse dynamics, bias and gravity torque, for tracing.

The equations are the book's with accelerations of points instead of spatial
ones: a body's point r accelerates by `a + W r`, which takes about a third fewer operations. Base
accelerations are relative to gravity throughout.
"""

from collections.abc import Sequence
from typing import NamedTuple

from kindsl.mechanics.dynamics.generation.composite_bodies import (
    composites,
    joint_reaction,
    rigid_body_inertia,
)
from kindsl.mechanics.dynamics.generation.factorization import solve_symmetric
from kindsl.mechanics.dynamics.generation.mass_moments import acceleration_field
from kindsl.mechanics.dynamics.generation.terms import Scalar
from kindsl.mechanics.dynamics.generation.tree import JointMotion, Tree, joint_motions
from kindsl.mechanics.dynamics.generation.vectors import (
    ZERO,
    Vector,
    add,
    cross,
    dot,
    subtract,
    transform,
)


def newton_euler(
    tree: Tree,
    q: Vector,
    qd: Vector,
    qdd: Vector,
    base_w: Vector,
    base_a: Vector,
    base_wd: Vector = ZERO,
    external: Sequence[Vector] = (),
) -> tuple[Vector, Vector]:
    """Return the joint forces and the base's wrench, moment first.

    Args:
        tree: The mechanism.
        q: Joint positions.
        qd: Joint velocities.
        qdd: Joint accelerations.
        base_w: Angular velocity of the base.
        base_a: Acceleration of the base's origin, relative to gravity.
        base_wd: Angular acceleration of the base.
        external: The wrench that acts on each body, in its coordinates at its origin, moment
            first; none if empty.
    """
    joints = joint_motions(tree, q)
    motions = body_motions(tree, joints, qd, qdd, base_w, base_a, base_wd)
    forces, moments = carried_wrenches(tree, joints, *loaded(motions, external))
    tau = [
        moments[i][2] if joints[i].kind == "revolute" else forces[i][2] for i in tree.links()
    ]  # fmt: skip
    if tree.drives is not None:
        tau = add(tau, tree.drives.force(qd, qdd))
    return tau, [*moments[0], *forces[0]]


class BodyMotions(NamedTuple):
    """The motions of bodies, base first, each in its own coordinates.

    Attributes:
        w: Angular velocities.
        wd: Angular accelerations.
        a: Accelerations of the bodies' origins, relative to gravity.
        forces: Forces that the bodies' own motions take.
        moments: The same about the bodies' origins.
    """

    w: list[Vector]
    wd: list[Vector]
    a: list[Vector]
    forces: list[Vector]
    moments: list[Vector]


def body_motions(
    tree: Tree,
    joints: Sequence[JointMotion],
    qd: Vector,
    qdd: Vector,
    base_w: Vector,
    base_a: Vector,
    base_wd: Vector,
) -> BodyMotions:
    """Return accelerations, from the base outward, and the wrenches that they take."""
    w, wd, a = [base_w], [base_wd], [base_a]
    W = [acceleration_field(base_w, base_wd)]
    for i in tree.links():
        parent, joint, rate, acceleration = tree.parents[i], joints[i], qd[i - 1], qdd[i - 1]
        w_i, wd_i = joint.to_link(w[parent]), joint.to_link(wd[parent])
        a_i = joint.to_link(add(a[parent], transform(W[parent], joint.offset)))
        if joint.kind == "revolute":
            wd_i = [wd_i[0] + w_i[1] * rate, wd_i[1] - w_i[0] * rate, wd_i[2] + acceleration]
            w_i = [w_i[0], w_i[1], w_i[2] + rate]
        else:
            coriolis = 2.0 * rate
            a_i = [a_i[0] + w_i[1] * coriolis, a_i[1] - w_i[0] * coriolis, a_i[2] + acceleration]
        w.append(w_i)
        wd.append(wd_i)
        a.append(a_i)
        W.append(acceleration_field(w_i, wd_i))
    own = list(zip(tree.masses, a, W, strict=True))
    forces = [body.force(a_i, W_i) for body, a_i, W_i in own]
    moments = [body.moment(a_i, W_i) for body, a_i, W_i in own]
    return BodyMotions(w, wd, a, forces, moments)


def loaded(motions: BodyMotions, external: Sequence[Vector]) -> tuple[list[Vector], list[Vector]]:
    """Return the forces and moments of bodies less what acts on them from outside, if anything."""
    if not external:
        return motions.forces, motions.moments
    wrenches = list(zip(external, motions.forces, motions.moments, strict=True))
    forces = [subtract(force, wrench[3:]) for wrench, force, _ in wrenches]
    return forces, [subtract(moment, wrench[:3]) for wrench, _, moment in wrenches]


def carried_wrenches(
    tree: Tree, joints: Sequence[JointMotion], forces: list[Vector], moments: list[Vector]
) -> tuple[list[Vector], list[Vector]]:
    """Return forces and moments of bodies with all that they carry, from the leaves inward."""
    forces, moments = [*forces], [*moments]
    for i in tree.links_leaves_first():
        parent, joint = tree.parents[i], joints[i]
        force = joint.to_parent(forces[i])
        moment = add(joint.to_parent(moments[i]), cross(joint.offset, force))
        forces[parent] = add(forces[parent], force)
        moments[parent] = add(moments[parent], moment)
    return forces, moments


def inverse_dynamics(
    tree: Tree,
    q: Vector,
    qd: Vector,
    qdd: Vector,
    gravity: Vector,
    external: Sequence[Vector] = (),
) -> list[Scalar]:
    """Return the joint forces of a mechanism with a fixed base."""
    up = subtract(ZERO, gravity)
    tau, _ = newton_euler(tree, q, qd, qdd, ZERO, up, external=external)
    return tau


def actuated_base_inverse_dynamics(
    tree: Tree,
    q: Vector,
    qd: Vector,
    qdd: Vector,
    base_velocity: Vector,
    base_acceleration: Vector,
    gravity: Vector,
    external: Sequence[Vector] = (),
) -> list[Scalar]:
    """Return the base's wrench, if it floats, and the joint forces of a given motion.

    The base's acceleration is a spatial one, like its velocity in base coordinates.
    """
    w, v = base_velocity[:3], base_velocity[3:]
    a = subtract(add(base_acceleration[3:], cross(w, v)), gravity)
    tau, wrench = newton_euler(tree, q, qd, qdd, w, a, base_acceleration[:3], external)
    return [*wrench, *tau] if tree.is_floating else tau


def floating_base_inverse_dynamics(
    tree: Tree,
    q: Vector,
    qd: Vector,
    qdd: Vector,
    base_velocity: Vector,
    gravity: Vector,
    external: Sequence[Vector] = (),
) -> list[Scalar]:
    """Return the joint forces and the spatial acceleration of a base without any wrench."""
    w, v = base_velocity[:3], base_velocity[3:]
    tau, wrench = newton_euler(tree, q, qd, qdd, w, ZERO, external=external)
    joints, composite = joint_motions(tree, q), composites(tree, q)
    base_acceleration = solve_symmetric(
        rigid_body_inertia(composite[0]), subtract([0.0] * 6, wrench)
    )
    # What the joints add when the base accelerates and carries everything as if rigid.
    wd, a = [base_acceleration[:3]], [base_acceleration[3:]]
    for i in tree.links():
        parent, joint = tree.parents[i], joints[i]
        a.append(joint.to_link(add(a[parent], cross(wd[parent], joint.offset))))
        wd.append(joint.to_link(wd[parent]))
        moment, force = joint_reaction(joint.kind, composite[i])
        tau[i - 1] = tau[i - 1] + (dot(moment, wd[i]) + dot(force, a[i]))
    return [*tau, *spatial_acceleration(base_acceleration, w, v, gravity)]


def bias_torque(
    tree: Tree, q: Vector, qd: Vector, base_velocity: Vector, gravity: Vector
) -> list[Scalar]:
    """Return the forces at zero joint and spatial base acceleration, base rows first."""
    rest: Vector = [0.0] * len(q)
    return actuated_base_inverse_dynamics(tree, q, qd, rest, base_velocity, [0.0] * 6, gravity)


def spatial_acceleration(
    acceleration: Vector, w: Vector, v: Vector, gravity: Vector
) -> list[Scalar]:
    """Return a spatial acceleration from that of the base's origin relative to gravity."""
    linear = add(subtract(acceleration[3:], cross(w, v)), gravity)
    return [*acceleration[:3], *linear]
