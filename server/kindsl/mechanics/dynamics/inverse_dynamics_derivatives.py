"""Derivatives of the forces that a motion takes."""

from typing import NamedTuple

import numpy as np

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.joint_space_inertia import add_rotors
from kindsl.mechanics.dynamics.joints import apply, body_inertias
from kindsl.mechanics.dynamics.spatial_motion import (
    force_of,
    in_base,
    spatial_motion,
    support_mask,
    velocity_columns,
)
from kindsl.mechanics.spatial.arrays import Array
from kindsl.mechanics.spatial.cross_products import cross, force_cross, motion_cross


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
    bodies: Bodies,
    q: Array,
    qd: Array,
    qdd: Array,
    base_velocity: Array,
    base_acceleration: Array,
    gravity: Array,
) -> InverseDynamicsDerivatives:
    """Return all first derivatives of the forces; all arguments have the same batch shape.

    Args:
        bodies: The mechanism.
        q: Joint positions, shape (..., n), radians and metres.
        qd: Joint velocities, shape (..., n).
        qdd: Joint accelerations, shape (..., n).
        base_velocity: Spatial velocity of the base, shape (..., 6), zero if it is fixed.
        base_acceleration: Spatial acceleration of the base, shape (..., 6), zero if it is fixed.
        gravity: Shape (..., 3), m/s^2, base coordinates.

    Source: Singh, Russell, Wensing 2022, Efficient analytical derivatives of rigid-body dynamics
        using spatial vector algebra, eqs. 40 to 47.
    """
    relative = base_acceleration.copy()
    relative[..., 3:] -= gravity
    motion = spatial_motion(bodies, q, qd, qdd, base_velocity, relative)
    first = bodies.n_velocities - bodies.n_links
    # How each joint's axis moves with what carries it.
    rate, rate_of_rate, both = [np.zeros(6)], [np.zeros(6)], [np.zeros(6)]
    for i, parent in bodies.links():
        rate.append(apply(motion_cross(motion.v[parent]), motion.S[i]))
        second = apply(motion_cross(motion.a[parent]), motion.S[i])
        rate_of_rate.append(second + apply(motion_cross(motion.v[parent]), rate[i]))
        both.append(rate[i] + apply(motion_cross(motion.v[i]), motion.S[i]))
    # What each joint carries: inertia, what its motion adds, and force.
    composite = _composites(bodies, motion.i_X_base, motion.v, motion.a)
    S = velocity_columns(bodies, motion.S)
    rates = [_columns(bodies, vectors) for vectors in (rate, rate_of_rate, both)]
    nv = bodies.n_velocities
    dq, dqd, M = (np.zeros((*q.shape[:-1], nv, nv)) for _ in range(3))

    def fill(i: int, rows: slice) -> None:
        inertia, coriolis, _ = composite[i]
        mask = support_mask(bodies, i)
        S_T = np.swapaxes(S[..., rows], -1, -2)
        dq[..., rows, :] = (S_T @ (coriolis @ rates[0] + inertia @ rates[1])) * mask
        dqd[..., rows, :] = (S_T @ (coriolis @ S + inertia @ rates[2])) * mask
        M[..., rows, :] = (S_T @ inertia @ S) * mask

    if first:
        rates[2][..., :6] = motion_cross(motion.v[0])
        fill(0, slice(0, 6))
    for i, _ in bodies.links():
        rows = slice(first + i - 1, first + i)
        fill(i, rows)
        inertia, coriolis, force = composite[i]
        mask = support_mask(bodies, i)
        # The same for what carries joint i; the force turns with the axis.
        supports = mask.astype(bool)
        supports[rows] = False
        by_position = apply(coriolis, rate[i]) + apply(inertia, rate_of_rate[i])
        by_position = by_position + apply(force_cross(motion.S[i]), force)
        by_velocity = apply(coriolis, motion.S[i]) + apply(inertia, both[i])
        above = np.swapaxes(S[..., supports], -1, -2)
        column = first + i - 1
        dq[..., supports, column] = apply(above, by_position)
        dqd[..., supports, column] = apply(above, by_velocity)
        M[..., supports, column] = apply(above, apply(inertia, motion.S[i]))
    if first:
        # The base turns: gravity turns the other way in its coordinates.
        for k, axis in enumerate(np.eye(3)):
            dq[..., k] = -apply(M[..., 3:6], cross(gravity, np.broadcast_to(axis, gravity.shape)))
    if bodies.drives is not None:
        joints = np.arange(first, nv)
        dqd[..., joints, joints] += bodies.drives.damping
    add_rotors(bodies, M)
    return InverseDynamicsDerivatives(dq, dqd, M)


def _columns(bodies: Bodies, vectors: list[Array]) -> Array:
    """Return the joints' vectors as columns, zeros for the base's."""
    shape = np.broadcast_shapes(*(vector.shape for vector in vectors))
    columns = np.zeros((*shape, bodies.n_velocities))
    first = bodies.n_velocities - bodies.n_links
    for i, _ in bodies.links():
        columns[..., first + i - 1] = vectors[i]
    return columns


def _composites(
    bodies: Bodies, i_X_base: list[Array], v: list[Array], a: list[Array]
) -> list[tuple[Array, Array, Array]]:
    """Return inertia, Coriolis matrix and force of each body with all that it carries."""
    sums = []
    for inertia, X, v_i, a_i in zip(body_inertias(bodies), i_X_base, v, a, strict=True):
        moved = in_base(X, inertia)
        momentum = apply(moved, v_i)
        coriolis = force_cross(v_i) @ moved - moved @ motion_cross(v_i) + _force_cross_of(momentum)
        sums.append((moved, coriolis, force_of(moved, v_i, a_i)))
    for i, parent in bodies.links_leaves_first():
        above, carried = sums[parent], sums[i]
        sums[parent] = (above[0] + carried[0], above[1] + carried[1], above[2] + carried[2])
    return sums


def _force_cross_of(f: Array) -> Array:
    """Return the matrix that takes a motion `m` to `m x* f`, shape (..., 6, 6)."""
    basis = np.eye(6)
    return np.stack([apply(force_cross(axis), f) for axis in basis], axis=-1)
