"""Masses, centres of mass, and the centre of mass's Jacobian."""

import numpy as np

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.joints import apply
from kindsl.mechanics.dynamics.posture import path_matrix
from kindsl.mechanics.spatial.arrays import Array
from kindsl.mechanics.spatial.cross_products import cross, skew


def subtree_masses(bodies: Bodies) -> Array:
    """Return each body's mass with all that it carries, shape (n + 1,), kg, base first."""
    return np.asarray(path_matrix(bodies.parents).T @ bodies.masses)


def subtree_first_moments(bodies: Bodies, poses: Array) -> Array:
    """Return mass times centre of mass of each body with all that it carries.

    Args:
        poses: The bodies' poses in the base, from `body_poses`.

    Returns:
        Shape (..., n + 1, 3), base coordinates, kg m.
    """
    coms = apply(poses[..., :3, :3], bodies.coms) + poses[..., :3, 3]
    return np.asarray(path_matrix(bodies.parents).T @ (bodies.masses[:, None] * coms))


def center_of_mass(bodies: Bodies, poses: Array) -> Array:
    """Return the whole mechanism's centre of mass (..., 3), a floating base's included.

    Args:
        bodies: The mechanism; its total mass is not zero.
        poses: The bodies' poses in the base, from `body_poses`.
    """
    return np.asarray(subtree_first_moments(bodies, poses)[..., 0, :] / np.sum(bodies.masses))


def center_of_mass_jacobian(bodies: Bodies, poses: Array) -> Array:
    """Return `J` (..., 3, nv), with the centre of mass's velocity `J @ (base velocity, qd)`.

    The velocity is relative to the world, in base coordinates; a floating base's six columns
    come first.

    Args:
        bodies: The mechanism; its total mass is not zero.
        poses: The bodies' poses in the base, from `body_poses`.

    Source: joint i moves its subtree's mass only: `m_i / m * z_i x (c_i - p_i)`.
    """
    moments, masses = subtree_first_moments(bodies, poses), subtree_masses(bodies)
    first = bodies.n_velocities - bodies.n_links
    J = np.zeros((*moments.shape[:-2], 3, bodies.n_velocities))
    if bodies.is_floating:
        J[..., :3] = -skew(moments[..., 0, :] / masses[0])
        J[..., 3:6] = np.eye(3)
    axes, origins = poses[..., 1:, :3, 2], poses[..., 1:, :3, 3]
    carried = masses[1:, None]
    is_revolute = np.array([[kind == "revolute"] for kind in bodies.joint_kinds])
    turning = cross(axes, moments[..., 1:, :] - carried * origins)
    moved = np.where(is_revolute, turning, carried * axes)
    J[..., first:] = np.swapaxes(moved, -1, -2) / masses[0]
    return J
