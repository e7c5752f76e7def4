"""Forward dynamics of a mechanism some of whose frames are held."""

from typing import NamedTuple

import numpy as np

from kindsl.mechanics.dynamics.joints import apply, apply_transposed, solve
from kindsl.mechanics.spatial.arrays import Array

# Rows of a worse condition hold some motion twice, but for rounding.
WORST_CONDITION = 1e13


class ConstrainedAccelerations(NamedTuple):
    """The motion of a mechanism, and what holds it.

    Attributes:
        a: Accelerations, a floating base's spatial one first, shape (..., nv).
        forces: What acts along the rows of the constraints, shape (..., m).
        Lambda: The inertia that the rows meet, `(J M^-1 J^T)^-1`, shape (..., m, m).
    """

    a: Array
    forces: Array
    Lambda: Array


def constrained_forward_dynamics(
    M: Array, forces: Array, J: Array, drift: Array
) -> ConstrainedAccelerations:
    """Return the motion with `J @ a + drift = 0`.

    Args:
        M: The joint-space inertia, shape (..., nv, nv).
        forces: Those of the joints less the bias torque, shape (..., nv).
        J: The Jacobian of the constraints, shape (..., m, nv).
        drift: Their accelerations at zero acceleration, shape (..., m).

    Raises:
        numpy.linalg.LinAlgError: If an inertia is singular.
        ValueError: If constraints hold the same motion.

    Source: Featherstone 2008, sec. 8.3; Khatib 1987 for Lambda.
    """
    free = solve(M, forces)
    J_T = np.swapaxes(J, -1, -2)
    inverse = J @ np.linalg.solve(M, J_T)
    if inverse.size and not (np.linalg.cond(inverse) < WORST_CONDITION).all():
        raise ValueError("the contacts hold some motion twice, or one that nothing can make")
    Lambda = np.asarray(np.linalg.inv(inverse), dtype=np.float64)
    along = -apply(Lambda, apply(J, free) + drift)
    return ConstrainedAccelerations(free + solve(M, apply_transposed(J, along)), along, Lambda)
