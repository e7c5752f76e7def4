"""Bias torque: the forces that a motion without acceleration takes, gravity included."""

import numpy as np

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.inverse_dynamics import newton_euler
from kindsl.mechanics.dynamics.joints import uniform_acceleration
from kindsl.mechanics.dynamics.posture import posture
from kindsl.mechanics.spatial.arrays import Array


def bias_torque(bodies: Bodies, q: Array, qd: Array, base_velocity: Array, gravity: Array) -> Array:
    """Return the forces at zero joint and (spatial) base acceleration, shape (..., nv).

    Args:
        bodies: The mechanism.
        q: Joint positions, shape (..., n), radians and metres.
        qd: Joint velocities, shape (..., n).
        base_velocity: Spatial velocity of the base, shape (..., 6), zero if it is fixed.
        gravity: Shape (..., 3), m/s^2, base coordinates.

    Returns:
        With a floating base the six components of its wrench come first, moment then force.

    Source: Featherstone 2008, sec. 6.1: `C` of `tau = M qdd + C`.
    """
    state, weightless = posture(bodies, q), -uniform_acceleration(gravity)
    return newton_euler(state, qd, np.zeros_like(qd), base_velocity, weightless)


def gravity_torque(bodies: Bodies, q: Array, gravity: Array) -> Array:
    """Return the forces at rest, shape (..., nv); arguments as of `bias_torque`."""
    return bias_torque(bodies, q, np.zeros_like(q), np.zeros(6), gravity)
