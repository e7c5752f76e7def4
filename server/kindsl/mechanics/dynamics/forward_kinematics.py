"""Poses of bodies, frames and joints in the base."""

import numpy as np

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.joints import link_poses_in_parents
from kindsl.mechanics.spatial.arrays import Array
from kindsl.mechanics.spatial.transforms import homogeneous


def body_poses(bodies: Bodies, q: Array) -> list[Array]:
    """Return `base_T_body` of every body, the base first.

    Args:
        bodies: The mechanism.
        q: Joint positions, shape (..., n), radians and metres.

    Returns:
        One array (..., 4, 4) per body.
    """
    rotations, positions = link_poses_in_parents(bodies, q)
    poses = [np.broadcast_to(np.eye(4), (*q.shape[:-1], 4, 4))]
    for link, parent in bodies.links():
        poses.append(poses[parent] @ homogeneous(rotations[link - 1], positions[link - 1]))
    return poses


def frame_poses(bodies: Bodies, poses: list[Array]) -> list[Array]:
    """Return `base_T_frame` (..., 4, 4) of the named frames, given the bodies' poses."""
    return [
        poses[frame.body] @ homogeneous(frame.body_R_frame, frame.body_r_frame)
        for frame in bodies.frames
    ]


def joint_poses(bodies: Bodies, poses: list[Array]) -> list[Array]:
    """Return `base_T_joint` (..., 4, 4): each joint's frame, fixed to its predecessor.

    Joint i turns about, or slides along, the z axis (third column).
    """
    return [
        poses[parent] @ homogeneous(bodies.p_R_j[link - 1], bodies.p_r_j[link - 1])
        for link, parent in bodies.links()
    ]
