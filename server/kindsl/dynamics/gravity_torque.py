"""Gravity torque: the forces that hold a mechanism at rest."""

import numpy as np

from kindsl.dynamics.bias_torque import bias_torque
from kindsl.dynamics.bodies import Bodies
from kindsl.spatial.arrays import Array


def gravity_torque(bodies: Bodies, q: Array, gravity: Array) -> Array:
    """Return the forces at rest, shape (..., nv), base rows first with a floating base.

    Args:
        bodies: The mechanism.
        q: Joint positions, shape (..., n), radians and metres.
        gravity: Shape (..., 3), m/s^2, base coordinates.
    """
    return bias_torque(bodies, q, np.zeros_like(q), np.zeros(6), gravity)
