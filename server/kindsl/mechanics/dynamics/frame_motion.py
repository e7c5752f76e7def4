"""Velocity and acceleration of a frame."""

import numpy as np

from kindsl.mechanics.dynamics.inverse_dynamics import body_motions
from kindsl.mechanics.dynamics.joints import apply
from kindsl.mechanics.dynamics.posture import Posture
from kindsl.mechanics.spatial.arrays import Array
from kindsl.mechanics.spatial.cross_products import cross
from kindsl.mechanics.spatial.transforms import plucker


def frame_motion(
    state: Posture,
    qd: Array,
    qdd: Array,
    base_velocity: Array,
    base_acceleration: Array,
    body: int,
    body_T_frame: Array,
) -> tuple[Array, Array]:
    """Return velocity and acceleration (..., 6) of a frame on a body, angular part first.

    Both are relative to the world, in the frame's own coordinates, linear parts of its origin.

    Args:
        state: The mechanism in its configuration.
        qd: Joint velocities, shape (..., n).
        qdd: Joint accelerations, shape (..., n).
        base_velocity: Spatial velocity of the base, shape (..., 6), zero if it is fixed.
        base_acceleration: Spatial acceleration of the base, shape (..., 6), zero if it is fixed.
        body: Index of the body that carries the frame.
        body_T_frame: The frame's pose in the body, shape (4, 4).

    Source: Featherstone 2008, sec. 5.3; the acceleration of a point is the linear part of the
        spatial one and `w x v` (sec. 2.11).
    """
    base_T_frame = state.poses[..., body, :, :] @ body_T_frame
    R, r = base_T_frame[..., :3, :3], base_T_frame[..., :3, 3]
    frame_X_base = plucker(np.swapaxes(R, -1, -2), r)
    motions = body_motions(state, qd, qdd, base_velocity, base_acceleration)
    v, a = (apply(frame_X_base, motion[..., body, :]) for motion in motions)
    turning = cross(v[..., :3], v[..., 3:])
    return v, np.concatenate((a[..., :3], a[..., 3:] + turning), axis=-1)
