"""Poses of bodies, frames and joints in the base."""

from functools import lru_cache

import numpy as np
import numpy.typing as npt

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.spatial.arrays import Array
from kindsl.mechanics.spatial.transforms import homogeneous, rotation_about_z


def body_poses(bodies: Bodies, q: Array) -> Array:
    """Return `base_T_body` (..., n + 1, 4, 4) of every body, the base first.

    Args:
        q: Joint positions, shape (..., n), radians and metres.
    """
    is_revolute = np.array([kind == "revolute" for kind in bodies.joint_kinds])
    joint_T_link = homogeneous(rotation_about_z(q * is_revolute), np.zeros(3))
    joint_T_link[..., 2, 3] = q * ~is_revolute
    poses = np.empty((*q.shape[:-1], bodies.n_links + 1, 4, 4))
    poses[..., 0, :, :] = np.eye(4)
    poses[..., 1:, :, :] = homogeneous(bodies.p_R_j, bodies.p_r_j) @ joint_T_link
    # Each jump doubles the length of the path that a pose spans; a batch is worth a call a link.
    for links, ancestors in _jumps(bodies.parents) if q.ndim == 1 else bodies.links():
        poses[..., links, :, :] = poses[..., ancestors, :, :] @ poses[..., links, :, :]
    return poses


def frame_poses(bodies: Bodies, poses: Array) -> Array:
    """Return `base_T_frame` (..., frames, 4, 4) of the named frames, given the bodies' poses."""
    carriers = [frame.body for frame in bodies.frames]
    placed = [homogeneous(frame.body_R_frame, frame.body_r_frame) for frame in bodies.frames]
    return np.asarray(poses[..., carriers, :, :] @ np.array(placed).reshape((-1, 4, 4)))


def joint_poses(bodies: Bodies, poses: Array) -> Array:
    """Return `base_T_joint` (..., n, 4, 4): each joint's frame, fixed to its predecessor.

    Joint i turns about, or slides along, the z axis (third column).
    """
    return np.asarray(poses[..., bodies.parents, :, :] @ homogeneous(bodies.p_R_j, bodies.p_r_j))


@lru_cache(maxsize=64)
def _jumps(parents: tuple[int, ...]) -> list[tuple[npt.NDArray[np.intp], npt.NDArray[np.intp]]]:
    """Return, by step, the links whose pose does not start at the base yet, and where it does."""
    ancestors = np.array([0, *parents])
    jumps = []
    while ancestors.any():
        links = np.flatnonzero(ancestors)
        jumps.append((links, ancestors[links]))
        ancestors = ancestors[ancestors]
    return jumps
