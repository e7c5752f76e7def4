"""Poses and the constant motions that lead from one to another."""

import numpy as np
import numpy.typing as npt

from kindsl.mechanics.spatial.arrays import Array, real_array
from kindsl.mechanics.spatial.cross_products import skew

# Below, the series' first terms are exact to 1e-16 of the result.
SMALL_ANGLE = 1e-4


def pose_error(A_T_B: "npt.ArrayLike", A_T_C: "npt.ArrayLike") -> "Array":
    """Return the motion that takes frame B to frame C in a unit of time, shape (..., 6).

    It is the logarithm of `B_T_C`: a constant spatial velocity in B's coordinates, angular part
    first, radians and metres. The way round is the shorter one, a turn of at most pi.

    Args:
        A_T_B: Pose of B, shape (..., 4, 4).
        A_T_C: Pose of C, shape (..., 4, 4).

    Raises:
        ValueError: If one is no array of finite numbers of that shape.
    """
    B, C = pose_array("A_T_B", A_T_B), pose_array("A_T_C", A_T_C)
    B_E_A = np.swapaxes(B[..., :3, :3], -1, -2)
    rotation = B_E_A @ C[..., :3, :3]
    position = B_E_A @ (C[..., :3, 3:] - B[..., :3, 3:])
    turn = rotation_vector(rotation)
    angle = np.sqrt(np.sum(turn * turn, axis=-1))[..., None, None]
    half, near_zero = 0.5 * angle, angle < SMALL_ANGLE
    with np.errstate(divide="ignore", invalid="ignore"):
        factor = (1.0 - half / np.tan(half)) / angle**2
    W = skew(turn)
    factor = np.where(near_zero, 1.0 / 12.0 + angle**2 / 720.0, factor)
    linear = position - 0.5 * W @ position + factor * (W @ (W @ position))
    return np.concatenate((turn, linear[..., 0]), axis=-1)


def pose_array(quantity: str, values: npt.ArrayLike) -> Array:
    """Return poses as an array (..., 4, 4).

    Raises:
        ValueError: If they are not real, finite numbers, or of another shape.
    """
    return real_array(quantity, values, (4, 4))


def pose_of_motion(motion: Array) -> Array:
    """Return `B_T_C` (..., 4, 4) after a unit of time at a constant spatial velocity (..., 6).

    Source: Murray, Li, Sastry 1994, eq. 2.36.
    """
    W = skew(motion[..., :3])
    angle = np.sqrt(np.sum(motion[..., :3] ** 2, axis=-1))[..., None, None]
    near_zero = angle < SMALL_ANGLE
    with np.errstate(divide="ignore", invalid="ignore"):
        first = np.where(near_zero, 1.0 - angle**2 / 6.0, np.sin(angle) / angle)
        # By the half angle: of a small one, `1 - cos` has few digits.
        second = np.where(
            near_zero, 0.5 - angle**2 / 24.0, 2.0 * (np.sin(0.5 * angle) / angle) ** 2
        )
        third = np.where(near_zero, 1.0 / 6.0 - angle**2 / 120.0, (1.0 - first) / angle**2)
    pose = np.zeros((*motion.shape[:-1], 4, 4))
    pose[..., :3, :3] = np.eye(3) + first * W + second * (W @ W)
    moved = (np.eye(3) + second * W + third * (W @ W)) @ motion[..., 3:, None]
    pose[..., :3, 3] = moved[..., 0]
    pose[..., 3, 3] = 1.0
    return pose


def rotation_vector(R: Array) -> Array:
    """Return axis times angle (..., 3) of rotations (..., 3, 3), at most pi long, radians.

    By way of the unit quaternion, whose largest component is computed first (Shepperd 1978).
    """
    trace = np.trace(R, axis1=-2, axis2=-1)
    diagonal = np.diagonal(R, axis1=-2, axis2=-1)
    squares = np.concatenate(
        (1.0 + trace[..., None], 1.0 + 2.0 * diagonal - trace[..., None]), axis=-1
    )
    products = np.zeros((*trace.shape, 4, 4))
    products[..., np.arange(4), np.arange(4)] = squares
    for k, (i, j) in enumerate(((2, 1), (0, 2), (1, 0)), start=1):
        products[..., 0, k] = products[..., k, 0] = R[..., i, j] - R[..., j, i]
    for i, j in ((0, 1), (0, 2), (1, 2)):
        products[..., i + 1, j + 1] = R[..., i, j] + R[..., j, i]
        products[..., j + 1, i + 1] = products[..., i + 1, j + 1]
    largest = np.argmax(squares, axis=-1)[..., None, None]
    quaternion = np.take_along_axis(products, largest, axis=-2)[..., 0, :]
    quaternion = quaternion / np.sqrt(np.sum(quaternion * quaternion, axis=-1))[..., None]
    quaternion = np.where(quaternion[..., :1] < 0.0, -quaternion, quaternion)
    sine = np.sqrt(np.sum(quaternion[..., 1:] ** 2, axis=-1))[..., None]
    angle = 2.0 * np.arctan2(sine, quaternion[..., :1])
    with np.errstate(divide="ignore", invalid="ignore"):
        per_sine = np.where(sine > 0.0, angle / sine, 2.0)
    return np.asarray(per_sine * quaternion[..., 1:])
