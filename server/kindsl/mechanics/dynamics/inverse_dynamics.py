"""Inverse dynamics: the Newton-Euler equations of all bodies, for fixed and floating bases."""

import numpy as np

from kindsl.mechanics.dynamics.joint_space_inertia import inertia_of
from kindsl.mechanics.dynamics.joints import (
    apply,
    motion_cross_product,
    rigid_body_force,
    solve,
    uniform_acceleration,
)
from kindsl.mechanics.dynamics.posture import Posture
from kindsl.mechanics.spatial.arrays import Array
from kindsl.mechanics.spatial.transforms import plucker


def newton_euler(
    state: Posture,
    qd: Array,
    qdd: Array,
    base_velocity: Array,
    base_acceleration: Array,
    external: Array | None = None,
) -> Array:
    """Return the forces that a given motion takes, shape (..., nv).

    Args:
        state: The mechanism in its configuration.
        qd: Joint velocities, shape (..., n).
        qdd: Joint accelerations, shape (..., n).
        base_velocity: Spatial velocity of the base, shape (..., 6), base coordinates.
        base_acceleration: Spatial acceleration of the base less gravity's, shape (..., 6).
        external: The wrench on each body at its origin in its coordinates, shape (..., n + 1, 6).

    Returns:
        `tau`, N m and N; with a floating base its wrench comes first, moment then force.

    Source: Featherstone 2008, sec. 5.3.
    """
    wrenches, tau = _carried_forces(state, qd, qdd, base_velocity, base_acceleration, external)
    return np.concatenate((wrenches, tau), axis=-1) if state.bodies.is_floating else tau


def base_wrench(
    state: Posture, qd: Array, qdd: Array, base_velocity: Array, base_acceleration: Array
) -> Array:
    """Return the wrench (..., 6) on the base, fixed or floating, that a motion takes."""
    return _carried_forces(state, qd, qdd, base_velocity, base_acceleration, None)[0]


def _carried_forces(
    state: Posture,
    qd: Array,
    qdd: Array,
    base_velocity: Array,
    base_acceleration: Array,
    external: Array | None,
) -> tuple[Array, Array]:
    v, a = body_motions(state, qd, qdd, base_velocity, base_acceleration)
    f = rigid_body_force(state.inertias, v, a)
    if external is not None:
        f = f - in_base(state, external)
    f = state.path.T @ f
    tau = np.sum(state.S * f, axis=-1)[..., 1:]
    drives = state.bodies.drives
    return f[..., 0, :], tau if drives is None else tau + drives.force(qd, qdd)


def body_motions(
    state: Posture, qd: Array, qdd: Array, base_velocity: Array, base_acceleration: Array
) -> tuple[Array, Array]:
    """Return the bodies' spatial velocities and accelerations, shape (..., n + 1, 6)."""
    v_joint = state.along_joints(qd)
    v = state.path @ v_joint + base_velocity[..., None, :]
    a_joint = state.along_joints(qdd) + motion_cross_product(v, v_joint)
    return v, state.path @ a_joint + base_acceleration[..., None, :]


def in_base(state: Posture, wrenches: Array) -> Array:
    """Return wrenches (..., n + 1, 6), given in the bodies, about the base's origin and axes."""
    poses = state.poses
    body_X_base = plucker(np.swapaxes(poses[..., :3, :3], -1, -2), poses[..., :3, 3])
    return apply(np.swapaxes(body_X_base, -1, -2), wrenches)


def floating_base_inverse_dynamics(
    state: Posture,
    qd: Array,
    qdd: Array,
    base_velocity: Array,
    gravity: Array,
    external: Array | None = None,
) -> tuple[Array, Array]:
    """Return the joint forces and the acceleration of a base that only gravity and `external` move.

    Args:
        state: The mechanism in its configuration.
        qd: Joint velocities, shape (..., n).
        qdd: Joint accelerations, shape (..., n).
        base_velocity: Spatial velocity of the base, shape (..., 6), base coordinates.
        gravity: Shape (..., 3), m/s^2, base coordinates.
        external: The wrench on each body, see `newton_euler`.

    Returns:
        `tau` (..., n), and the base's spatial acceleration (..., 6), gravity's effect included.

    Raises:
        numpy.linalg.LinAlgError: If the whole mechanism's inertia is singular.

    Source: Featherstone 2008, sec. 9.5.
    """
    forces = newton_euler(state, qd, qdd, base_velocity, np.zeros(6), external)
    # A free base takes the acceleration, relative to gravity, at which its wrench vanishes.
    M = inertia_of(state)
    a = -solve(M[..., :6, :6], forces[..., :6])
    return forces[..., 6:] + apply(M[..., 6:, :6], a), a + uniform_acceleration(gravity)
