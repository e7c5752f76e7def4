"""Geometric Jacobians of frames."""

import numpy as np

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.joints import apply
from kindsl.mechanics.spatial.arrays import Array
from kindsl.mechanics.spatial.cross_products import cross, skew


def jacobian(bodies: Bodies, poses: Array, body: int, base_T_frame: Array) -> Array:
    """Return `J`, with the frame's velocity `J @ (base velocity, qd)`.

    The velocity is that of the frame relative to the world, in the frame's orientation, at its
    origin: angular part first.

    Args:
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
        axis, origin = poses[..., joint, :3, 2], poses[..., joint, :3, 3]
        column = J[..., first + joint - 1]
        if bodies.joint_kinds[joint - 1] == "revolute":
            column[..., :3] = apply(frame_E_base, axis)
            column[..., 3:] = apply(frame_E_base, cross(axis, r - origin))
        else:
            column[..., 3:] = apply(frame_E_base, axis)
    return J


def relative_jacobian(
    bodies: Bodies, poses: Array, base: tuple[int, Array], target: tuple[int, Array]
) -> Array:
    """Return `J` (..., 6, nv), with a target's velocity relative to a base `J @ (..., qd)`.

    The velocity is that of the target's origin as the base sees it, in the base's coordinates. The
    mechanism's base has no part in it.

    Args:
        poses: The bodies' poses in the base, from `body_poses`.
        base: The body that carries the base frame, and the frame's pose (..., 4, 4).
        target: The same of the target.
    """
    (one, seen_from), (other, pose) = base, target
    at_target = np.concatenate((seen_from[..., :3], pose[..., 3:]), axis=-1)
    J = jacobian(bodies, poses, other, at_target) - jacobian(bodies, poses, one, at_target)
    J[..., : bodies.n_velocities - bodies.n_links] = 0.0
    return J
