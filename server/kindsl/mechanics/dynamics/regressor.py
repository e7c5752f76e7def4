"""The regressor: forces as a linear function of the bodies' inertial parameters."""

import numpy as np

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.inverse_dynamics import body_motions
from kindsl.mechanics.dynamics.joints import apply
from kindsl.mechanics.dynamics.posture import moved_bodies, posture
from kindsl.mechanics.spatial.arrays import Array
from kindsl.mechanics.spatial.cross_products import force_cross, skew
from kindsl.mechanics.spatial.transforms import plucker

PARAMETERS_PER_BODY = 10
_TENSOR_ENTRIES = ((0, 0), (0, 1), (1, 1), (0, 2), (1, 2), (2, 2))


def inertial_parameters(bodies: Bodies) -> Array:
    """Return what the regressor multiplies, shape (10 k,), for the k bodies that move.

    Ten a body: mass, mass times centre of mass, then the entries xx, xy, yy, xz, yz, zz of the
    inertia tensor about the body's origin and axes, products of inertia with their minus signs.
    """
    rows, columns = zip(*_TENSOR_ENTRIES, strict=True)
    tensors = bodies.inertias[:, rows, columns]
    firsts = bodies.masses[:, None] * bodies.coms
    parameters = np.concatenate((bodies.masses[:, None], firsts, tensors), axis=1)
    return parameters[0 if bodies.is_floating else 1 :].ravel()


def regressor(
    bodies: Bodies, q: Array, qd: Array, qdd: Array, base_velocity: Array, base_acceleration: Array
) -> Array:
    """Return `Y`, with the forces of a motion `Y @ inertial_parameters(bodies)`.

    Args:
        bodies: The mechanism; all further arguments have the same batch shape.
        q: Joint positions, shape (..., n), radians and metres.
        qd: Joint velocities, shape (..., n).
        qdd: Joint accelerations, shape (..., n).
        base_velocity: Spatial velocity of the base, shape (..., 6), zero if it is fixed.
        base_acceleration: Spatial acceleration of the base less gravity's, shape (..., 6).

    Returns:
        Shape (..., nv, 10 k); a floating base's six rows, and its columns, come first.

    Source: Featherstone 2008, sec. 9.6 on the linearity in inertial parameters.
    """
    state, units = posture(bodies, q), _unit_inertias()
    v, a = body_motions(state, qd, qdd, base_velocity, base_acceleration)
    poses = state.poses
    X = plucker(np.swapaxes(poses[..., :3, :3], -1, -2), poses[..., :3, 3])
    v, a = apply(X, v), apply(X, a)
    forces = np.einsum("pij,...bj->...bip", units, a)
    forces = forces + force_cross(v) @ np.einsum("pij,...bj->...bip", units, v)
    # Of each body, what its parameters take of the velocity variables that move it.
    columns = state.columns()[..., None, :, :]
    blocks = columns @ np.swapaxes(X, -1, -2) @ forces
    blocks = blocks * state.path[:, moved_bodies(bodies)][..., None]
    moving = blocks[..., 0 if bodies.is_floating else 1 :, :, :]
    Y: Array = np.moveaxis(moving, -3, -2)
    return Y.reshape((*Y.shape[:-2], Y.shape[-2] * Y.shape[-1]))


def _unit_inertias() -> Array:
    """Return the 6x6 inertias with one inertial parameter of one each, shape (10, 6, 6)."""
    units = np.zeros((PARAMETERS_PER_BODY, 6, 6))
    units[0, 3:, 3:] = np.eye(3)
    for k, axis in enumerate(np.eye(3), start=1):
        units[k, :3, 3:], units[k, 3:, :3] = skew(axis), -skew(axis)
    for k, (row, column) in enumerate(_TENSOR_ENTRIES, start=4):
        units[k, row, column] = units[k, column, row] = 1.0
    return units
