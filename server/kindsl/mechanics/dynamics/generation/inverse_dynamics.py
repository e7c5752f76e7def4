"""Inverse dynamics, bias and gravity torque, for tracing.

The equations are the book's with accelerations of points instead of spatial
ones: a body's point r accelerates by `a + W r`, which takes about a third fewer operations. Base
accelerations are relative to gravity throughout.
"""

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

from kindsl.mechanics.dynamics.generation.composite_bodies import (
    composites,
    joint_reaction,
    rigid_body_inertia,
)
from kindsl.mechanics.dynamics.generation.factorization import solve_symmetric
from kindsl.mechanics.dynamics.generation.function import Inputs
from kindsl.mechanics.dynamics.generation.mass_moments import acceleration_field
from kindsl.mechanics.dynamics.generation.terms import Scalar
from kindsl.mechanics.dynamics.generation.tree import JointMotion, Tree, Wrench, joint_motions
from kindsl.mechanics.dynamics.generation.vectors import (
    ZERO,
    Vector,
    add,
    cross,
    dot,
    subtract,
    transform,
)


def newton_euler(tree: Tree, x: Inputs, base_a: Vector) -> tuple[Vector, Vector]:
    """Return the joint forces and the base's wrench, moment first.

    Args:
        tree: The mechanism.
        x: The motion, and what acts on bodies from outside.
        base_a: Acceleration of the base's origin as a point, relative to gravity.
    """
    joints = joint_motions(tree, x.q)
    motions = body_motions(tree, joints, x, base_a)
    carried = carried_wrenches(tree, joints, loaded(motions, x.external))
    tau = [joints[i].along(carried[i]) for i in tree.links()]
    if tree.drives is not None:
        tau = add(tau, tree.drives.force(x.qd, x.qdd))
    return tau, [*carried[0].moment, *carried[0].force]


class BodyMotions(NamedTuple):
    """The motions of bodies, base first, each in its own coordinates.

    Attributes:
        w: Angular velocities.
        wd: Angular accelerations.
        a: Accelerations of the bodies' origins, relative to gravity.
        wrenches: What the bodies' own motions take.
    """

    w: list[Vector]
    wd: list[Vector]
    a: list[Vector]
    wrenches: list[Wrench]


def body_motions(
    tree: Tree, joints: Sequence[JointMotion], x: Inputs, base_a: Vector
) -> BodyMotions:
    """Return accelerations, from the base outward, and the wrenches that they take."""
    w, wd, a = [x.v0[:3]], [x.a0[:3]], [base_a]
    W = [acceleration_field(w[0], wd[0])]
    for i in tree.links():
        parent, joint, rate, acceleration = tree.parents[i], joints[i], x.qd[i - 1], x.qdd[i - 1]
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
    return BodyMotions(w, wd, a, list(map(Wrench, moments, forces)))


def loaded(motions: BodyMotions, external: Sequence[Vector]) -> list[Wrench]:
    """Return the wrenches of bodies less what acts on them from outside, if anything."""
    if not external:
        return motions.wrenches
    pairs = list(zip(motions.wrenches, external, strict=True))
    forces = [subtract(wrench.force, load[3:]) for wrench, load in pairs]
    return [
        Wrench(subtract(wrench.moment, load[:3]), force)
        for (wrench, load), force in zip(pairs, forces, strict=True)
    ]


def carried_wrenches(
    tree: Tree, joints: Sequence[JointMotion], wrenches: Sequence[Wrench]
) -> list[Wrench]:
    """Return the wrenches of bodies with all that they carry, from the leaves inward."""
    carried = [*wrenches]
    for i in tree.links_leaves_first():
        moment, force = joints[i].wrench_in_parent(carried[i])
        parent = carried[tree.parents[i]]
        force = add(parent.force, force)
        carried[tree.parents[i]] = Wrench(add(parent.moment, moment), force)
    return carried


def inverse_dynamics(tree: Tree, x: Inputs) -> list[Scalar]:
    """Return the wrench on the base, if it floats, and the joint forces of a given motion."""
    w, v = x.v0[:3], x.v0[3:]
    tau, wrench = newton_euler(tree, x, subtract(add(x.a0[3:], cross(w, v)), x.g))
    return [*wrench, *tau] if tree.is_floating else tau


def floating_base_inverse_dynamics(tree: Tree, x: Inputs) -> list[Scalar]:
    """Return the joint forces and the spatial acceleration of a base without any wrench."""
    tau, wrench = newton_euler(tree, replace(x, a0=[0.0] * 6), ZERO)
    joints, composite = joint_motions(tree, x.q), composites(tree, x.q)
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
    return [*tau, *spatial_acceleration(base_acceleration, x)]


def bias_torque(tree: Tree, x: Inputs) -> list[Scalar]:
    """Return the forces at zero joint and spatial base acceleration, base rows first."""
    return inverse_dynamics(tree, x.unaccelerated())


def spatial_acceleration(acceleration: Vector, x: Inputs) -> list[Scalar]:
    """Return a spatial acceleration from that of the base's origin relative to gravity."""
    w, v = x.v0[:3], x.v0[3:]
    return [*acceleration[:3], *add(subtract(acceleration[3:], cross(w, v)), x.g)]
