"""A rigid body's inertia: as a 6x6 matrix, about other frames, as a pseudo-inertia."""

import numpy as np

from kindsl.mechanics.spatial.arrays import Array
from kindsl.mechanics.spatial.cross_products import skew


def spatial_inertia(mass: Array, com: Array, inertia: Array) -> Array:
    """Return the 6x6 inertia of bodies about their frames' origins.

    Args:
        mass: Shape (...), kg.
        com: Centre of mass in the body's frame, shape (..., 3), metres.
        inertia: Rotational inertia about that frame's origin and axes, shape (..., 3, 3), kg m^2.

    Returns:
        Shape (..., 6, 6), angular part first.

    Source: Featherstone 2008, eq. 2.63.
    """
    mass_column = np.asarray(mass)[..., None]
    h = skew(mass_column * com)
    matrix = np.zeros((*inertia.shape[:-2], 6, 6))
    matrix[..., :3, :3] = inertia
    matrix[..., :3, 3:] = h
    matrix[..., 3:, :3] = -h
    matrix[..., 3:, 3:] = mass_column[..., None] * np.eye(3)
    return matrix


def point_inertia(mass: Array, position: Array) -> Array:
    """Return the inertia about the origin of point masses at `position`: (..., 3, 3), kg m^2."""
    square = np.sum(position * position, axis=-1)[..., None, None] * np.eye(3)
    outer = position[..., :, None] * position[..., None, :]
    inertia: Array = np.asarray(mass)[..., None, None] * (square - outer)
    return inertia


def move_inertia(
    mass: Array, com: Array, inertia: Array, A_R_B: Array, A_r_B: Array
) -> tuple[Array, Array]:
    """Express a body's centre of mass and inertia, given in frame B, in frame A.

    Args:
        mass: Shape (...), kg.
        com: Centre of mass in B, shape (..., 3), metres.
        inertia: Inertia about B's origin and axes, shape (..., 3, 3), kg m^2.
        A_R_B: Rotation of coordinates from B to A, shape (..., 3, 3).
        A_r_B: Position of B's origin in A, shape (..., 3), metres.

    Returns:
        Centre of mass in A, and inertia about A's origin and axes.
    """
    about_com = A_R_B @ (inertia - point_inertia(mass, com)) @ np.swapaxes(A_R_B, -1, -2)
    moved_com = (A_R_B @ com[..., None])[..., 0] + A_r_B
    return moved_com, about_com + point_inertia(mass, moved_com)


def second_moment(inertia: Array) -> Array:
    """Return `integral r r^T dm`, the dual form of the inertia tensor `(..., 3, 3)`.

    Source: Wensing, Kim, Slotine 2018, eq. 11.
    """
    trace = np.trace(inertia, axis1=-2, axis2=-1)
    second: Array = 0.5 * trace[..., None, None] * np.eye(3) - inertia
    return second
