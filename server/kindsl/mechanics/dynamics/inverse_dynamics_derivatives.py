"""Derivatives of the forces that a motion takes."""

from typing import NamedTuple

import numpy as np

from kindsl.mechanics.dynamics.inverse_dynamics import body_motions
from kindsl.mechanics.dynamics.joint_space_inertia import add_rotors
from kindsl.mechanics.dynamics.joints import (
    apply,
    apply_transposed,
    motion_cross_product,
    rigid_body_force,
    uniform_acceleration,
)
from kindsl.mechanics.dynamics.posture import Posture, supports
from kindsl.mechanics.spatial.arrays import Array
from kindsl.mechanics.spatial.cross_products import cross, force_cross, motion_cross, skew


class InverseDynamicsDerivatives(NamedTuple):
    """The derivatives of the forces.

    A floating base's six rows come first, the wrench on it, and its six columns: small turns and
    shifts of the base about its own axes, and changes of its velocity and acceleration, all in
    base coordinates, which move with the base.

    Attributes:
        dtau_dq: With positions, shape (..., nv, nv).
        dtau_dqd: With velocities, shape (..., nv, nv).
        dtau_dqdd: With accelerations: the joint-space inertia, shape (..., nv, nv).
    """

    dtau_dq: Array
    dtau_dqd: Array
    dtau_dqdd: Array


def inverse_dynamics_derivatives(
    state: Posture,
    qd: Array,
    qdd: Array,
    base_velocity: Array,
    base_acceleration: Array,
    gravity: Array,
) -> InverseDynamicsDerivatives:
    """Return all first derivatives of the forces; all arguments have the same batch shape.

    Args:
        state: The mechanism in its configuration.
        qd: Joint velocities, shape (..., n).
        qdd: Joint accelerations, shape (..., n).
        base_velocity: Spatial velocity of the base, shape (..., 6), zero if it is fixed.
        base_acceleration: Spatial acceleration of the base, shape (..., 6), zero if it is fixed.
        gravity: Shape (..., 3), m/s^2, base coordinates.

    Source: Singh, Russell, Wensing 2022, Efficient analytical derivatives of rigid-body dynamics
        using spatial vector algebra, eqs. 40 to 47.
    """
    bodies, S = state.bodies, state.columns()
    v, a = body_motions(
        state, qd, qdd, base_velocity, base_acceleration - uniform_acceleration(gravity)
    )
    rate, rate_of_rate, both = _axis_rates(state, v, a)
    # What each velocity variable carries: inertia, what its motion adds, and force.
    inertia = state.of_columns(state.composites())
    coriolis = state.of_columns(state.carried(_coriolis(state, v)))
    force = state.of_columns(state.carried(rigid_body_force(state.inertias, v, a)))
    by_position = apply(coriolis, rate) + apply(inertia, rate_of_rate)
    by_velocity = apply(coriolis, S) + apply(inertia, both)
    # Of a row's variable, the columns that carry it; then the rows that carry a column's, whose
    # force turns with its axis. The upper triangle of M mirrors the lower.
    carriers, S_coriolis = supports(bodies), apply_transposed(coriolis, S)
    above = carriers.T * (1.0 - carriers)
    momentum, S_T = apply(inertia, S), np.swapaxes(S, -1, -2)

    def rows(first: Array, with_first: Array, second: Array, with_second: Array) -> Array:
        return np.asarray(
            first @ np.swapaxes(with_first, -1, -2) + second @ np.swapaxes(with_second, -1, -2)
        )

    turning = apply(force_cross(S), force)
    dq = rows(S_coriolis, rate, momentum, rate_of_rate) * carriers
    dq += S @ np.swapaxes(by_position + turning, -1, -2) * above
    dqd = rows(S_coriolis, S, momentum, both) * carriers
    dqd += S @ np.swapaxes(by_velocity, -1, -2) * above
    M: Array = momentum @ S_T * carriers
    M += np.swapaxes(M * (1.0 - carriers.T), -1, -2)
    if bodies.is_floating:
        # The base turns: gravity turns the other way in its coordinates.
        turned = cross(gravity[..., None, :], np.eye(3))
        dq[..., :3] = -M[..., 3:6] @ np.swapaxes(turned, -1, -2)
    joints = np.arange(bodies.n_velocities - bodies.n_links, bodies.n_velocities)
    if bodies.drives is not None:
        dqd[..., joints, joints] += bodies.drives.damping
    add_rotors(bodies, M)
    return InverseDynamicsDerivatives(dq, dqd, M)


def _axis_rates(state: Posture, v: Array, a: Array) -> tuple[Array, Array, Array]:
    """Return how each velocity variable's unit motion moves with what carries it, (..., nv, 6)."""
    S, parents = state.S[..., 1:, :], state.bodies.parents
    rate = motion_cross_product(v[..., parents, :], S)
    second = motion_cross_product(a[..., parents, :], S)
    second = second + motion_cross_product(v[..., parents, :], rate)
    both = rate + motion_cross_product(v[..., 1:, :], S)
    if not state.bodies.is_floating:
        return rate, second, both
    still = np.zeros((*rate.shape[:-2], 6, 6))
    turning = np.swapaxes(motion_cross(v[..., 0, :]), -1, -2) + still
    return (
        np.concatenate((still, rate), axis=-2),
        np.concatenate((still, second), axis=-2),
        np.concatenate((turning, both), axis=-2),
    )


def _coriolis(state: Posture, v: Array) -> Array:
    """Return what the force of each body changes by with its velocity, (..., n + 1, 6, 6)."""
    moving, inertias = motion_cross(v), state.inertias
    # `m x* h` as a matrix times m: the momentum's moments and forces as cross products.
    h = -skew(apply(inertias, v).reshape((*v.shape[:-1], 2, 3)))
    turning = np.zeros((*v.shape, 6))
    turning[..., :3, :3] = h[..., 0, :, :]
    turning[..., :3, 3:] = turning[..., 3:, :3] = h[..., 1, :, :]
    return np.asarray(turning - np.swapaxes(moving, -1, -2) @ inertias - inertias @ moving)
