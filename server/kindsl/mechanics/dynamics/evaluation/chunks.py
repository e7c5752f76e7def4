"""Does large batches a part at a time."""

from collections.abc import Callable

import numpy as np

from kindsl.mechanics.dynamics.evaluation.request import Request
from kindsl.mechanics.spatial.arrays import Array

# The working set is some dozens of 6x6 matrices per body and configuration.
BODIES_AT_A_TIME = 20_000


def evaluate_in_chunks(
    evaluate: Callable[[Request], Array], n_links: int, request: Request
) -> Array:
    """Return a quantity's entries in one row per configuration, shape (*batch_shape, entries).

    Args:
        evaluate: Computes it for vectors that all have the shape (configurations, components).
        n_links: Of the mechanism; the more, the fewer configurations are done at a time.
        request: The computation.
    """
    batch_shape = request.batch_shape
    chunk = max(1, BODIES_AT_A_TIME // n_links)
    rows = [
        np.broadcast_to(vector, (*batch_shape, vector.shape[-1])).reshape((-1, vector.shape[-1]))
        for vector in (*request.joint_vectors, request.base_velocity, request.gravity)
    ]
    entries = []
    for start in range(0, max(1, len(rows[0])), chunk):
        *vectors, v_base, g = (row[start : start + chunk] for row in rows)
        part = Request(request.quantity, (len(v_base),), tuple(vectors), v_base, g)
        entries.append(evaluate(part))
    joined = np.concatenate(entries)
    return joined.reshape((*batch_shape, joined.shape[-1]))
