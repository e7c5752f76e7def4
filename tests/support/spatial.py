"""Spatial algebra that only tests need."""

import numpy as np

from kindsl.mechanics.spatial.arrays import Array
from kindsl.mechanics.spatial.inertia import second_moment


def pseudo_inertia(mass: Array, com: Array, inertia: Array) -> Array:
    """Return `[[second moment, m c], [m c^T, m]]`, shape (..., 4, 4).

    It moves by congruence, `A_T_B @ P_B @ A_T_B.T`, and is positive definite exactly for
    physically consistent bodies.

    Source: Wensing, Kim, Slotine 2018, sec. III.
    """
    P = np.zeros((*inertia.shape[:-2], 4, 4))
    P[..., :3, :3] = second_moment(inertia)
    P[..., :3, 3] = P[..., 3, :3] = np.asarray(mass)[..., None] * com
    P[..., 3, 3] = mass
    return P


def rotation_from_intrinsic_xyz(angles: Array) -> Array:
    """Return `Rx @ Ry @ Rz`: turns about x, then the new y, then the new z.

    Args:
        angles: `(rx, ry, rz)`, shape (..., 3), radians.

    Returns:
        `A_R_B` of the turned frame B, shape (..., 3, 3).
    """
    cx, cy, cz = np.moveaxis(np.cos(angles), -1, 0)
    sx, sy, sz = np.moveaxis(np.sin(angles), -1, 0)
    rows = (
        (cy * cz, -cy * sz, sy),
        (cx * sz + sx * sy * cz, cx * cz - sx * sy * sz, -sx * cy),
        (sx * sz - cx * sy * cz, sx * cz + cx * sy * sz, cx * cy),
    )
    return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)
