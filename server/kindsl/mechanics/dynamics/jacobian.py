"""The geometric Jacobian of a frame."""

import numpy as np

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.spatial.arrays import Array
from kindsl.mechanics.spatial.cross_products import cross, skew


def jacobian(bodies: Bodies, poses: list[Array], body: int, base_T_frame: Array) -> Array:
    """Return `J`, with the frame's velocity `J @ (base velocity, qd)`.

    The velocity is that of the frame relative to the world, in the frame's orientation, at its
    origin: angular part first.

    Args:
        bodies: The mechanism.
        poses: The bodies' poses in the base, from `body_poses`.
        body: Index of the body that carries the frame.
        base_T_frame: The frame's pose, shape (..., 4, 4).

    Returns:
        Shape (..., 6, nv); with a floating base the base's six columns come first.
    """
    R, r = base_T_frame[..., :3, :3], base_T_frame[..., :3, 3]
    frame_E_base = np.swapaxes(R, -1, -2)
    first = bodies.n_velocities - bodies.n_links
    J = np.zeros((*r.shape[:-1], 6, bodies.n_velocities))
    if bodies.is_floating:
        J[..., :3, :3] = J[..., 3:, 3:6] = frame_E_base
        J[..., 3:, :3] = -frame_E_base @ skew(r)
    for joint in bodies.support(body):
        axis, origin = poses[joint][..., :3, 2], poses[joint][..., :3, 3]
        column = J[..., first + joint - 1]
        if bodies.joint_kinds[joint - 1] == "revolute":
            column[..., :3] = _rotate(frame_E_base, axis)
            column[..., 3:] = _rotate(frame_E_base, cross(axis, r - origin))
        else:
            column[..., 3:] = _rotate(frame_E_base, axis)
    return J


def _rotate(E: Array, v: Array) -> Array:
    rotated: Array = (E @ v[..., None])[..., 0]
    return rotated
