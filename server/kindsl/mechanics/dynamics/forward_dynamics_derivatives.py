"""Derivatives of the accelerations under given forces."""

from typing import NamedTuple

import numpy as np

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.forward_dynamics import forward_dynamics
from kindsl.mechanics.dynamics.inverse_dynamics_derivatives import inverse_dynamics_derivatives
from kindsl.mechanics.dynamics.posture import posture
from kindsl.mechanics.spatial.arrays import Array


class ForwardDynamicsDerivatives(NamedTuple):
    """The derivatives of the accelerations.

    A floating base's six rows come first, its spatial acceleration, and its six columns: small
    turns and shifts of the base about its own axes, changes of its velocity, and a wrench on it,
    all in base coordinates, which move with the base.

    Attributes:
        dqdd_dq: With positions, shape (..., nv, nv).
        dqdd_dqd: With velocities, shape (..., nv, nv).
        dqdd_dtau: With forces: the inverse of the joint-space inertia, shape (..., nv, nv).
    """

    dqdd_dq: Array
    dqdd_dqd: Array
    dqdd_dtau: Array


def forward_dynamics_derivatives(
    bodies: Bodies, q: Array, qd: Array, tau: Array, base_velocity: Array, gravity: Array
) -> ForwardDynamicsDerivatives:
    """Return all first derivatives; arguments as of `forward_dynamics`, of one batch shape.

    Raises:
        numpy.linalg.LinAlgError: If nothing resists some motion.

    Source: the equations of motion hold at the solution, so `M d qdd = -d tau` at held `qdd`.
    """
    state, first = posture(bodies, q), bodies.n_velocities - bodies.n_links
    a, M = forward_dynamics(state, qd, tau, base_velocity, gravity)
    a0 = a[..., :6] if first else np.zeros_like(base_velocity)
    dq, dqd, _ = inverse_dynamics_derivatives(state, qd, a[..., first:], base_velocity, a0, gravity)
    inverse = np.asarray(np.linalg.inv(M), dtype=np.float64)
    return ForwardDynamicsDerivatives(-inverse @ dq, -inverse @ dqd, inverse)
