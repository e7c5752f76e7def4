"""Does large batches a part at a time."""

from collections.abc import Callable

import numpy as np

from kindsl.dynamics.evaluation.request import Request
from kindsl.spatial.arrays import Array


def evaluate_in_chunks(evaluate: Callable[[Request], Array], chunk: int, request: Request) -> Array:
    """Return a quantity's entries in one row per configuration, shape (*batch_shape, entries).

    Args:
        evaluate: Computes it for vectors that all have the shape (configurations, components).
        chunk: How many configurations it is given at most.
        request: What to compute.
    """
    batch_shape = request.batch_shape
    rows = [
        np.broadcast_to(vector, (*batch_shape, vector.shape[-1])).reshape((-1, vector.shape[-1]))
        for vector in (*request.joint_vectors, request.base_velocity, request.gravity)
    ]
    entries = []
    for start in range(0, max(1, len(rows[0])), chunk):
        *vectors, v_base, g = (row[start : start + chunk] for row in rows)
        part = Request(request.quantity, (len(v_base),), tuple(vectors), v_base, g)
        entries.append(evaluate(part))
    joined = entries[0] if len(entries) == 1 else np.concatenate(entries)
    return joined.reshape((*batch_shape, joined.shape[-1]))
