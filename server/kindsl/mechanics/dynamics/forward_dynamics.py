"""Forward dynamics by the joint-space inertia.

In NumPy it takes no longer than articulated bodies do, of chains of 100 and batches of thousands
neither: its calls do not grow with the bodies.
"""

import numpy as np

from kindsl.mechanics.dynamics.inverse_dynamics import newton_euler
from kindsl.mechanics.dynamics.joint_space_inertia import inertia_of
from kindsl.mechanics.dynamics.joints import solve, uniform_acceleration
from kindsl.mechanics.dynamics.posture import Posture
from kindsl.mechanics.spatial.arrays import Array


def forward_dynamics(
    state: Posture,
    qd: Array,
    tau: Array,
    base_velocity: Array,
    gravity: Array,
    external: Array | None = None,
) -> tuple[Array, Array]:
    """Return all accelerations (..., nv), a floating base's first, and the joint-space inertia.

    The base's is spatial, gravity's effect included.

    Args:
        state: The mechanism in its configuration.
        qd: Joint velocities, shape (..., n).
        tau: Joint forces, shape (..., n), N m and N.
        base_velocity: Spatial velocity of the base, shape (..., 6), zero if it is fixed.
        gravity: Shape (..., 3), m/s^2, base coordinates.
        external: The wrench on each body at its origin in its coordinates, shape (..., n + 1, 6).

    Raises:
        numpy.linalg.LinAlgError: If nothing resists some motion.

    Source: Featherstone 2008, sec. 6.1.
    """
    first = state.bodies.n_velocities - state.bodies.n_links
    rest, weight = np.zeros_like(qd), uniform_acceleration(gravity)
    M = inertia_of(state)
    start = -weight if not first else np.zeros_like(weight)
    bias = newton_euler(state, qd, rest, base_velocity, start, external)
    forces = np.concatenate((np.zeros((*tau.shape[:-1], first)), tau), axis=-1)
    accelerations = solve(M, forces - bias)
    accelerations[..., :first] += weight[..., :first]
    return accelerations, M
