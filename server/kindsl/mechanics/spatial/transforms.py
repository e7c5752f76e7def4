"""Rotations, homogeneous and Pluecker transforms.

`A_X_B` maps motion vectors, `v_A = A_X_B @ v_B`; its transpose maps forces back,
`f_B = A_X_B.T @ f_A`. `A_R_B` rotates coordinates from B to A and is the rotation of `A_T_B`;
`A_E_B` is the same matrix under the book's name.
"""

import numpy as np

from kindsl.mechanics.spatial.arrays import Array
from kindsl.mechanics.spatial.cross_products import skew


def plucker(B_E_A: Array, A_r_B: Array) -> Array:
    """Return `B_X_A`, the motion transform from frame A to frame B.

    Args:
        B_E_A: Rotation of coordinates from A to B, shape (..., 3, 3), orthonormal.
        A_r_B: Position of B's origin in A, shape (..., 3), metres.

    Returns:
        `B_X_A`, shape (..., 6, 6), angular part first.

    Source: Featherstone 2008, sec. 2.8.
    """
    batch = np.broadcast_shapes(B_E_A.shape[:-2], A_r_B.shape[:-1])
    B_X_A = np.zeros((*batch, 6, 6))
    B_X_A[..., :3, :3] = B_X_A[..., 3:, 3:] = B_E_A
    B_X_A[..., 3:, :3] = -B_E_A @ skew(A_r_B)
    return B_X_A


def homogeneous(A_R_B: Array, A_r_B: Array) -> Array:
    """Return `A_T_B`, which maps B's homogeneous coordinates to A's, shape (..., 4, 4)."""
    batch = np.broadcast_shapes(A_R_B.shape[:-2], A_r_B.shape[:-1])
    A_T_B = np.zeros((*batch, 4, 4))
    A_T_B[..., :3, :3] = A_R_B
    A_T_B[..., :3, 3] = A_r_B
    A_T_B[..., 3, 3] = 1.0
    return A_T_B


def rotation_about_z(angle: Array) -> Array:
    """Return `A_R_B` for B turned about A's z axis by `angle` (...), radians: (..., 3, 3)."""
    R = np.zeros((*angle.shape, 3, 3))
    R[..., 0, 0] = R[..., 1, 1] = np.cos(angle)
    R[..., 1, 0] = np.sin(angle)
    R[..., 0, 1] = -R[..., 1, 0]
    R[..., 2, 2] = 1.0
    return R
