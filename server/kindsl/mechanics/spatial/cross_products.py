"""Cross products of 3-D and 6-D vectors as matrices, after Featherstone 2008, sec. 2.9."""

import numpy as np

from kindsl.mechanics.spatial.arrays import Array

_NEXT = np.array([1, 2, 0])
_AFTER_NEXT = np.array([2, 0, 1])


def cross(a: Array, b: Array) -> Array:
    """Return `a x b`, shape (..., 3), in a fraction of the time of `numpy.cross`."""
    product: Array = a[..., _NEXT] * b[..., _AFTER_NEXT] - a[..., _AFTER_NEXT] * b[..., _NEXT]
    return product


def skew(v: Array) -> Array:
    """Return the matrix `V` with `V @ u = cross(v, u)`, shape (..., 3, 3), for `v` (..., 3)."""
    V = np.zeros((*v.shape, 3))
    V[..., 0, 1], V[..., 0, 2], V[..., 1, 2] = -v[..., 2], v[..., 1], -v[..., 0]
    V[..., 1, 0], V[..., 2, 0], V[..., 2, 1] = v[..., 2], -v[..., 1], v[..., 0]
    return V


def motion_cross(v: Array) -> Array:
    """Return `v x`, which differentiates motion vectors that move with velocity `v`.

    Args:
        v: Spatial velocity, shape (..., 6), angular part first.

    Returns:
        Shape (..., 6, 6).

    Source: Featherstone 2008, eq. 2.31.
    """
    matrix = np.zeros((*v.shape, 6))
    matrix[..., :3, :3] = matrix[..., 3:, 3:] = skew(v[..., :3])
    matrix[..., 3:, :3] = skew(v[..., 3:])
    return matrix


def force_cross(v: Array) -> Array:
    """Return `v x*`, the force twin of `motion_cross`, shape (..., 6, 6).

    Source: Featherstone 2008, eq. 2.32.
    """
    return -np.swapaxes(motion_cross(v), -1, -2)
