"""Momentum about the centre of mass, and what changes it without acceleration."""

import numpy as np

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.center_of_mass import center_of_mass
from kindsl.mechanics.dynamics.inverse_dynamics import base_wrench
from kindsl.mechanics.dynamics.joints import apply
from kindsl.mechanics.dynamics.posture import posture
from kindsl.mechanics.spatial.arrays import Array
from kindsl.mechanics.spatial.cross_products import cross


def centroidal_momentum_matrix(bodies: Bodies, q: Array) -> Array:
    """Return `A` (..., 6, nv), with the momentum about the CoM `A @ (base velocity, qd)`.

    The angular part comes first, in base coordinates; a floating base's six columns come first.

    Args:
        bodies: The mechanism; its total mass is not zero.
        q: Joint positions, shape (..., n), radians and metres.

    Source: Orin, Goswami, Lee 2013, Centroidal dynamics of a humanoid robot.
    """
    state = posture(bodies, q)
    columns = apply(state.of_columns(state.composites()), state.columns())
    com = center_of_mass(bodies, state.poses)
    return np.swapaxes(_about(com[..., None, :], columns), -1, -2)


def centroidal_momentum_drift(bodies: Bodies, q: Array, qd: Array, base_velocity: Array) -> Array:
    """Return the rate (..., 6) of momentum about the CoM at zero acceleration.

    With accelerations, the base's spatial one first, the rate is `A @ a` more. It is the one that
    the world sees, in base coordinates: without gravity and other forces it is zero.

    Args:
        bodies: The mechanism; its total mass is not zero.
        q: Joint positions, shape (..., n), radians and metres.
        qd: Joint velocities, shape (..., n).
        base_velocity: Spatial velocity of the base, shape (..., 6), zero if it is fixed.
    """
    state = posture(bodies, q)
    wrench = base_wrench(state, qd, np.zeros_like(qd), base_velocity, np.zeros(6))
    return _about(center_of_mass(bodies, state.poses), wrench)


def _about(point: Array, wrench: Array) -> Array:
    """Return a momentum or wrench (..., 6) about a point (..., 3) instead of the origin."""
    moment = wrench[..., :3] - cross(point, wrench[..., 3:])
    return np.concatenate((moment, wrench[..., 3:]), axis=-1)
