"""The joint-space inertia matrix: the composite-rigid-body algorithm."""

import numpy as np

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.joints import (
    apply_transposed,
    body_inertias,
    link_transforms,
    motion_subspaces,
)
from kindsl.mechanics.spatial.arrays import Array


def joint_space_inertia(bodies: Bodies, q: Array) -> Array:
    """Return `M`, symmetric, with `M @ (base acceleration, qdd)` = the forces that it takes.

    Args:
        bodies: The mechanism.
        q: Joint positions, shape (..., n), radians and metres.

    Returns:
        Shape (..., nv, nv); with a floating base its six rows and columns come first, angular
        then linear, in base coordinates.

    Source: Featherstone 2008, table 6.2 and sec. 9.3.
    """
    X, S = link_transforms(bodies, q), motion_subspaces(bodies)
    composite = composite_inertias(bodies, X)
    first = bodies.n_velocities - bodies.n_links
    M = np.zeros((*q.shape[:-1], bodies.n_velocities, bodies.n_velocities))
    M[..., :first, :first] = composite[0][..., :first, :first]
    for i, _ in bodies.links():
        # The force that moves the subtree of joint i, seen by each joint that supports it.
        f, row = composite[i] @ S[i], first + i - 1
        for j in bodies.support(i):
            column = first + j - 1
            M[..., row, column] = M[..., column, row] = f @ S[j]
            f = apply_transposed(X[j], f)
        M[..., row, :first] = M[..., :first, row] = f[..., :first]
    add_rotors(bodies, M)
    return M


def add_rotors(bodies: Bodies, M: Array) -> None:
    """Add the inertia of the joints' rotors to a joint-space inertia (..., nv, nv)."""
    if bodies.drives is not None:
        joints = np.arange(bodies.n_velocities - bodies.n_links, bodies.n_velocities)
        M[..., joints, joints] += bodies.drives.armature


def composite_inertias(bodies: Bodies, X: list[Array]) -> list[Array]:
    """Return the inertia (..., 6, 6) of each body with all that it carries, as if rigid.

    Args:
        bodies: The mechanism.
        X: `i_X_p` of every body, from `link_transforms`.
    """
    composite = body_inertias(bodies)
    for i, parent in bodies.links_leaves_first():
        moved = np.swapaxes(X[i], -1, -2) @ composite[i] @ X[i]
        composite[parent] = composite[parent] + moved
    return composite
