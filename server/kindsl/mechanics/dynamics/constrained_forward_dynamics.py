"""Forward dynamics of a mechanism some of whose frames are held."""

import numpy as np

from kindsl.mechanics.dynamics.joints import apply, apply_transposed, solve
from kindsl.mechanics.spatial.arrays import Array

# Rows of a worse condition hold some motion twice, but for rounding.
WORST_CONDITION = 1e13


def constrained_forward_dynamics(
    M: Array, forces: Array, J: Array, drift: Array
) -> tuple[Array, Array, Array]:
    """Return the motion with `J @ a + drift = 0`, and what holds it.

    Args:
        M: The joint-space inertia, shape (..., nv, nv).
        forces: Those of the joints less the bias torque, shape (..., nv).
        J: The Jacobian of the constraints, shape (..., m, nv).
        drift: Their accelerations at zero acceleration, shape (..., m).

    Returns:
        Accelerations (..., nv), a floating base's spatial one first; the forces (..., m) along the
        rows of the constraints; and the inertia (..., m, m) that these meet, `(J M^-1 J^T)^-1`.

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
    return free + solve(M, apply_transposed(J, along)), along, Lambda
