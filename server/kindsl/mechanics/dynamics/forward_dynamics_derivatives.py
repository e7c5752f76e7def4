"""Derivatives of the accelerations under given forces."""

from typing import NamedTuple

import numpy as np

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.forward_dynamics import forward_dynamics
from kindsl.mechanics.dynamics.inverse_dynamics_derivatives import inverse_dynamics_derivatives
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
    qdd, base_acceleration = forward_dynamics(bodies, q, qd, tau, base_velocity, gravity)
    dq, dqd, M = inverse_dynamics_derivatives(
        bodies, q, qd, qdd, base_velocity, base_acceleration, gravity
    )
    inverse: Array = np.asarray(np.linalg.inv(M), dtype=np.float64)
    return ForwardDynamicsDerivatives(-inverse @ dq, -inverse @ dqd, inverse)
