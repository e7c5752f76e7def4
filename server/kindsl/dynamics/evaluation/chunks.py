"""What evaluates a quantity looks like, and how it does large batches a part at a time."""

from collections.abc import Callable
from typing import TypeAlias

import numpy as np

from kindsl.dynamics.quantities import Quantity
from kindsl.spatial.arrays import Array

# Computes a quantity for joint vectors, base velocities and gravities that all have the shape
# (configurations, components).
Evaluator: TypeAlias = Callable[[Quantity, list[Array], Array, Array], Array]
# The same for arguments whose leading dimensions broadcast to a batch shape.
BatchEvaluator: TypeAlias = Callable[[Quantity, tuple[int, ...], list[Array], Array, Array], Array]


def evaluate_in_chunks(
    evaluator: Evaluator,
    chunk: int,
    quantity: Quantity,
    batch_shape: tuple[int, ...],
    joint_vectors: list[Array],
    base_velocity: Array,
    gravity: Array,
) -> Array:
    """Return what the evaluator gives for all configurations, shape (*batch_shape, entries).

    Args:
        evaluator: Computes some configurations.
        chunk: How many it is given at most.
        quantity: What to compute.
        batch_shape: What the leading dimensions of all that follows broadcast to.
        joint_vectors: Each of shape (..., n).
        base_velocity: Shape (..., 6).
        gravity: Shape (..., 3).
    """
    rows = [
        np.broadcast_to(vector, (*batch_shape, vector.shape[-1])).reshape((-1, vector.shape[-1]))
        for vector in (*joint_vectors, base_velocity, gravity)
    ]
    entries = []
    for start in range(0, max(1, len(rows[0])), chunk):
        *vectors, v_base, g = (row[start : start + chunk] for row in rows)
        entries.append(evaluator(quantity, vectors, v_base, g))
    joined = entries[0] if len(entries) == 1 else np.concatenate(entries)
    return joined.reshape((*batch_shape, joined.shape[-1]))
