"""Inertial parameters that motions can tell: the rank of the regressor. Needs NumPy."""

import numpy as np

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.quantities import STANDARD_GRAVITY
from kindsl.mechanics.dynamics.regressor import PARAMETERS_PER_BODY, regressor

_SEED = 26
_ROWS_PER_PARAMETER = 3
_SMALLEST = 1e-9


def n_base_parameters(bodies: Bodies) -> tuple[int, int]:
    """Return how many combinations of inertial parameters motions can tell, and how many there are.

    What is left is the null space: changes of masses, centres of mass and moments that leave every
    joint torque, and the wrench on a floating base, as it is.

    Source: Wensing, Niemeyer, Slotine 2017, Observability in inertial parameter identification, on
    what the rank means; it is taken here of random motions.
    """
    random = np.random.default_rng(_SEED)
    n = bodies.n_links
    n_velocities = n + (6 if bodies.is_floating else 0)
    states = 1 + _ROWS_PER_PARAMETER * PARAMETERS_PER_BODY * (n + 1) // n_velocities
    q, qd, qdd = random.uniform(-1.0, 1.0, (3, states, n))
    v = random.uniform(-1.0, 1.0, (states, 6)) if bodies.is_floating else np.zeros((states, 6))
    a = random.uniform(-1.0, 1.0, (states, 6)) if bodies.is_floating else np.zeros((states, 6))
    a[:, 3:] -= np.array(STANDARD_GRAVITY)
    Y = regressor(bodies, q, qd, qdd, v, a)
    columns = Y.reshape(-1, Y.shape[-1])
    moving = n + (1 if bodies.is_floating else 0)
    values = np.linalg.svd(columns, compute_uv=False)
    rank = int(np.count_nonzero(values > _SMALLEST * values[0]))
    return rank, PARAMETERS_PER_BODY * moving
