"""The joint-space inertia matrix, by composite rigid bodies."""

import numpy as np

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.joints import apply
from kindsl.mechanics.dynamics.posture import Posture, posture, supports
from kindsl.mechanics.spatial.arrays import Array

# A body on the way to an axis turns it once, by products of three terms.
ROUNDINGS_PER_BODY = 3


def joint_space_inertia(bodies: Bodies, q: Array) -> Array:
    """Return `M`, symmetric, with `M @ (base acceleration, qdd)` = the forces that it takes.

    Args:
        q: Joint positions, shape (..., n), radians and metres.

    Returns:
        Shape (..., nv, nv); with a floating base its six rows and columns come first, angular
        then linear, in base coordinates.

    Source: Featherstone 2008, sec. 6.2 and 9.3.
    """
    return inertia_of(posture(bodies, q))


def inertia_of(state: Posture) -> Array:
    """Return the joint-space inertia in a configuration, see `joint_space_inertia`."""
    columns, carried = state.columns(), state.of_columns(state.composites())
    # The force that moves each subtree, seen by the joints that support it.
    f = apply(carried, columns)
    lower = np.tril(f @ np.swapaxes(columns, -1, -2) * supports(state.bodies))
    M: Array = lower + np.swapaxes(np.tril(lower, -1), -1, -2)
    # What nothing resists is zero: about the base, rounding would leave an inertia.
    unresisted = np.abs(np.sum(columns * f, axis=-1)) < _rounding(state, columns, carried)
    M[unresisted[..., :, None] | unresisted[..., None, :]] = 0.0
    add_rotors(state.bodies, M)
    return M


def _rounding(state: Posture, columns: Array, carried: Array) -> Array:
    """Return what rounding may make of each diagonal entry that is zero, shape (..., nv)."""
    sizes = np.abs(columns)
    terms = np.sum(sizes * apply(np.abs(carried), sizes), axis=-1)
    roundings = ROUNDINGS_PER_BODY * (state.bodies.n_links + 1)
    return np.asarray(roundings * np.finfo(np.float64).eps * terms)


def add_rotors(bodies: Bodies, M: Array) -> None:
    """Add the inertia of the joints' rotors to a joint-space inertia (..., nv, nv)."""
    if bodies.drives is not None:
        joints = np.arange(bodies.n_velocities - bodies.n_links, bodies.n_velocities)
        M[..., joints, joints] += bodies.drives.armature
