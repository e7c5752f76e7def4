"""Products of batches of matrices and spatial vectors."""

import numpy as np

from kindsl.mechanics.spatial.arrays import Array
from kindsl.mechanics.spatial.cross_products import cross


def apply(matrix: Array, vector: Array) -> Array:
    """Return `matrix @ vector` for batches of both."""
    product: Array = (matrix @ vector[..., None])[..., 0]
    return product


def apply_transposed(matrix: Array, vector: Array) -> Array:
    """Return `matrix.T @ vector` for batches of both."""
    return apply(np.swapaxes(matrix, -1, -2), vector)


def solve(matrix: Array, vector: Array) -> Array:
    """Return `x` of `matrix @ x = vector` for batches of both.

    Raises:
        numpy.linalg.LinAlgError: If a matrix is singular.
    """
    return np.asarray(np.linalg.solve(matrix, vector[..., None])[..., 0], dtype=np.float64)


def rigid_body_force(inertia: Array, v: Array, a: Array) -> Array:
    """Return the net force `I a + v x* I v` on a body, shape (..., 6).

    Source: Featherstone 2008, eq. 2.68, with `v x* = -(v x).T`.
    """
    momentum = apply(inertia, v)
    angular, linear = momentum[..., :3], momentum[..., 3:]
    w, v_linear = v[..., :3], v[..., 3:]
    rate = np.concatenate((cross(w, angular) + cross(v_linear, linear), cross(w, linear)), axis=-1)
    total: Array = apply(inertia, a) + rate
    return total


def motion_cross_product(v: Array, m: Array) -> Array:
    """Return `v x m` of two motion vectors, shape (..., 6).

    Source: Featherstone 2008, eq. 2.33.
    """
    angular = cross(v[..., :3], m[..., :3])
    linear = cross(v[..., :3], m[..., 3:]) + cross(v[..., 3:], m[..., :3])
    return np.concatenate((angular, linear), axis=-1)


def uniform_acceleration(gravity: Array) -> Array:
    """Return gravity (..., 3) as a spatial acceleration of the base (..., 6), m/s^2."""
    return np.concatenate((np.zeros_like(gravity), gravity), axis=-1)
