"""The Coriolis matrix whose sum with its transpose is the rate of the joint-space inertia."""

from dataclasses import replace

import numpy as np

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.inverse_dynamics_derivatives import inverse_dynamics_derivatives
from kindsl.mechanics.dynamics.posture import posture
from kindsl.mechanics.spatial.arrays import Array
from kindsl.mechanics.spatial.cross_products import motion_cross


def coriolis_matrix(bodies: Bodies, q: Array, qd: Array, base_velocity: Array) -> Array:
    """Return `C` (..., nv, nv), with the bias torque `C @ (base velocity, qd)` and gravity's.

    Friction of joints is in the bias torque and not in `C`.

    All arguments have the same batch shape. `C + C.T` is the rate of the joint-space inertia.

    Args:
        q: Joint positions, shape (..., n), radians and metres.
        qd: Joint velocities, shape (..., n).
        base_velocity: Spatial velocity of the base, shape (..., 6), zero if it is fixed.

    Source: with `J` the Jacobian of each point of mass, `C` is the sum of `m J.T Jd`; the bias is
        quadratic in velocities, so its derivative has `2 Jd` instead. Only a floating base's own
        columns differ, whose coordinates turn with it. Compare Echeandia and Wensing 2021.
    """
    bodies = replace(bodies, drives=None)
    rest = np.zeros((*qd.shape[:-1], 6))
    derivatives = inverse_dynamics_derivatives(
        posture(bodies, q), qd, np.zeros_like(qd), base_velocity, rest, rest[..., :3]
    )
    C = 0.5 * derivatives.dtau_dqd
    if bodies.is_floating:
        base = derivatives.dtau_dqdd[..., :6]
        C[..., :6] += 0.5 * base @ motion_cross(base_velocity)
    return C
