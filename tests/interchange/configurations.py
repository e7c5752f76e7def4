"""Joint positions in pinocchio's order and form."""

import numpy as np
import pinocchio

from kindsl.mechanics.spatial.arrays import Array


def configuration(model: pinocchio.Model, values: dict[str, float]) -> Array:
    """Return the configuration vector for joint values by name."""
    q = pinocchio.neutral(model)
    for name, value in values.items():
        joint = model.joints[model.getJointId(name)]
        if joint.nq == 2:  # an endless joint is a point on the circle there
            q[joint.idx_q : joint.idx_q + 2] = np.cos(value), np.sin(value)
        else:
            q[joint.idx_q] = value
    return np.asarray(q)


def velocity_order(model: pinocchio.Model, names: list[str]) -> list[int]:
    """Return the row of each joint."""
    return [model.joints[model.getJointId(name)].idx_v for name in names]
