"""Momentum about the centre of mass, and what changes it without acceleration."""

import numpy as np

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.center_of_mass import center_of_mass
from kindsl.mechanics.dynamics.forward_kinematics import body_poses
from kindsl.mechanics.dynamics.inverse_dynamics import newton_euler
from kindsl.mechanics.dynamics.joints import apply, body_inertias
from kindsl.mechanics.dynamics.spatial_motion import in_base, spatial_motion
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
    rest, first = np.zeros_like(q), bodies.n_velocities - bodies.n_links
    motion = spatial_motion(bodies, q, rest, rest, np.zeros(6), np.zeros(6))
    carried = [
        in_base(X, inertia)
        for X, inertia in zip(motion.i_X_base, body_inertias(bodies), strict=True)
    ]
    for i, parent in bodies.links_leaves_first():
        carried[parent] = carried[parent] + carried[i]
    columns = [carried[0][..., k] for k in range(first)]
    columns += [apply(carried[i], motion.S[i]) for i, _ in bodies.links()]
    com = center_of_mass(bodies, body_poses(bodies, q))
    return np.stack([_about(com, column) for column in columns], axis=-1)


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
    rest = np.zeros_like(qd)
    _, wrench = newton_euler(bodies, q, qd, rest, base_velocity, np.zeros(6))
    return _about(center_of_mass(bodies, body_poses(bodies, q)), wrench)


def _about(point: Array, wrench: Array) -> Array:
    """Return a momentum or wrench (..., 6) about a point (..., 3) instead of the origin."""
    moment = wrench[..., :3] - cross(point, wrench[..., 3:])
    return np.concatenate((moment, wrench[..., 3:]), axis=-1)
