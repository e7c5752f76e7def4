"""Kinetic and potential energy."""

import numpy as np

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.center_of_mass import subtree_first_moments
from kindsl.mechanics.dynamics.joints import apply
from kindsl.mechanics.dynamics.posture import posture
from kindsl.mechanics.spatial.arrays import Array


def kinetic_energy(bodies: Bodies, q: Array, qd: Array, base_velocity: Array) -> Array:
    """Return the kinetic energy, shape (...), joule.

    Args:
        q: Joint positions, shape (..., n), radians and metres.
        qd: Joint velocities, shape (..., n).
        base_velocity: Spatial velocity of the base, shape (..., 6), zero if it is fixed.

    Source: Featherstone 2008, eq. 2.67, summed over the bodies.
    """
    state = posture(bodies, q)
    v = state.velocities(qd, base_velocity)
    energy = 0.5 * np.sum(v * apply(state.inertias, v), axis=(-2, -1))
    if bodies.drives is not None:
        energy = energy + 0.5 * np.sum(bodies.drives.armature * qd**2, axis=-1)
    return np.asarray(energy)


def potential_energy(bodies: Bodies, poses: Array, gravity: Array) -> Array:
    """Return the potential energy, zero for all mass at the base's origin: (...), joule.

    Args:
        poses: The bodies' poses in the base, from `body_poses`.
        gravity: Shape (..., 3), m/s^2, base coordinates.
    """
    return np.asarray(-np.sum(subtree_first_moments(bodies, poses)[..., 0, :] * gravity, axis=-1))
