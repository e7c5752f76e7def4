"""Inverse dynamics: the recursive Newton-Euler algorithm, for fixed and floating bases."""

import numpy as np

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.joint_space_inertia import composite_inertias
from kindsl.mechanics.dynamics.joints import (
    apply,
    apply_transposed,
    body_inertias,
    link_transforms,
    motion_cross_product,
    motion_subspaces,
    rigid_body_force,
    solve,
    uniform_acceleration,
)
from kindsl.mechanics.spatial.arrays import Array


def newton_euler(
    bodies: Bodies, q: Array, qd: Array, qdd: Array, base_velocity: Array, base_acceleration: Array
) -> tuple[Array, Array]:
    """Return the joint forces and the wrench on the base that a given motion takes.

    Args:
        bodies: The mechanism.
        q: Joint positions, shape (..., n), radians and metres.
        qd: Joint velocities, shape (..., n).
        qdd: Joint accelerations, shape (..., n).
        base_velocity: Spatial velocity of the base, shape (..., 6), base coordinates.
        base_acceleration: Spatial acceleration of the base less gravity's, shape (..., 6).

    Returns:
        `tau` (..., n), N m and N, and the wrench (..., 6) in base coordinates, moment first.

    Source: Featherstone 2008, table 5.1.
    """
    X, S, inertias = link_transforms(bodies, q), motion_subspaces(bodies), body_inertias(bodies)
    # Outward: velocities, accelerations, and the force that each body's motion takes.
    v, a = [base_velocity], [base_acceleration]
    f = [rigid_body_force(inertias[0], v[0], a[0])]
    for i, parent in bodies.links():
        v_joint = S[i] * qd[..., i - 1, None]
        v.append(apply(X[i], v[parent]) + v_joint)
        a_joint = S[i] * qdd[..., i - 1, None] + motion_cross_product(v[i], v_joint)
        a.append(apply(X[i], a[parent]) + a_joint)
        f.append(rigid_body_force(inertias[i], v[i], a[i]))
    # Inward: each joint carries its whole subtree.
    tau = np.zeros(np.broadcast_shapes(q.shape, (*base_acceleration.shape[:-1], 1)))
    for i, parent in bodies.links_leaves_first():
        tau[..., i - 1] = f[i] @ S[i]
        f[parent] = f[parent] + apply_transposed(X[i], f[i])
    if bodies.drives is not None:
        tau = tau + bodies.drives.force(qd, qdd)
    return tau, f[0]


def inverse_dynamics(bodies: Bodies, q: Array, qd: Array, qdd: Array, gravity: Array) -> Array:
    """Return the joint forces `tau` (..., n) of a mechanism with a fixed base.

    Args:
        bodies: The mechanism.
        q: Joint positions, shape (..., n), radians and metres.
        qd: Joint velocities, shape (..., n).
        qdd: Joint accelerations, shape (..., n).
        gravity: Shape (..., 3), m/s^2, base coordinates.
    """
    tau, _ = newton_euler(bodies, q, qd, qdd, np.zeros(6), -uniform_acceleration(gravity))
    return tau


def floating_base_inverse_dynamics(
    bodies: Bodies, q: Array, qd: Array, qdd: Array, base_velocity: Array, gravity: Array
) -> tuple[Array, Array]:
    """Return the joint forces and the acceleration of a base on which no wrench acts.

    Args:
        bodies: The mechanism.
        q: Joint positions, shape (..., n), radians and metres.
        qd: Joint velocities, shape (..., n).
        qdd: Joint accelerations, shape (..., n).
        base_velocity: Spatial velocity of the base, shape (..., 6), base coordinates.
        gravity: Shape (..., 3), m/s^2, base coordinates.

    Returns:
        `tau` (..., n), and the base's spatial acceleration (..., 6), gravity's effect included.

    Raises:
        numpy.linalg.LinAlgError: If the whole mechanism's inertia is singular.

    Source: Featherstone 2008, table 9.6.
    """
    X, S = link_transforms(bodies, q), motion_subspaces(bodies)
    tau, wrench = newton_euler(bodies, q, qd, qdd, base_velocity, np.zeros(6))
    # A free base takes the acceleration, relative to gravity, at which its wrench vanishes.
    composite = composite_inertias(bodies, X)
    a = [-solve(composite[0], wrench)]
    for i, parent in bodies.links():
        a.append(apply(X[i], a[parent]))
        tau[..., i - 1] += apply(composite[i], a[i]) @ S[i]
    return tau, a[0] + uniform_acceleration(gravity)
