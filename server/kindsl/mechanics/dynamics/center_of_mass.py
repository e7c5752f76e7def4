"""Masses, centres of mass, and the centre of mass's Jacobian."""

import numpy as np

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.spatial.arrays import Array
from kindsl.mechanics.spatial.cross_products import cross, skew


def subtree_masses(bodies: Bodies) -> Array:
    """Return each body's mass with all that it carries, shape (n + 1,), kg, base first."""
    masses = bodies.masses.copy()
    for i, parent in bodies.links_leaves_first():
        masses[parent] += masses[i]
    return masses


def subtree_first_moments(bodies: Bodies, poses: list[Array]) -> list[Array]:
    """Return mass times centre of mass of each body with all that it carries.

    Args:
        bodies: The mechanism.
        poses: The bodies' poses in the base, from `body_poses`.

    Returns:
        One array (..., 3) per body, base coordinates, kg m.
    """
    moments = [
        m * ((pose[..., :3, :3] @ c) + pose[..., :3, 3])
        for m, c, pose in zip(bodies.masses, bodies.coms, poses, strict=True)
    ]
    for i, parent in bodies.links_leaves_first():
        moments[parent] = moments[parent] + moments[i]
    return moments


def center_of_mass(bodies: Bodies, poses: list[Array]) -> Array:
    """Return the whole mechanism's centre of mass (..., 3), a floating base's included.

    Args:
        bodies: The mechanism; its total mass is not zero.
        poses: The bodies' poses in the base, from `body_poses`.
    """
    center: Array = subtree_first_moments(bodies, poses)[0] / np.sum(bodies.masses)
    return center


def center_of_mass_jacobian(bodies: Bodies, poses: list[Array]) -> Array:
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
    J = np.zeros((*moments[0].shape[:-1], 3, bodies.n_velocities))
    if bodies.is_floating:
        J[..., :3] = -skew(moments[0] / masses[0])
        J[..., 3:6] = np.eye(3)
    for i, kind in enumerate(bodies.joint_kinds, start=1):
        axis, origin = poses[i][..., :3, 2], poses[i][..., :3, 3]
        if kind == "revolute":
            moved = cross(axis, moments[i] - masses[i] * origin)
        else:
            moved = masses[i] * axis
        J[..., first + i - 1] = moved / masses[0]
    return J
