"""The questions asked of every form."""

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from kindsl.mechanics.spatial.arrays import Array


class Request(NamedTuple):
    """A quantity for a batch of configurations.

    Attributes:
        function: The name of the generated function that computes it.
        batch_shape: Common shape of the leading dimensions of all vectors.
        vectors: What it depends on by the names that generated functions have for it: joint vectors
            (..., n), `v0` and `g`, and where they are given `a0` and `fext` (..., 6 (n + 1)).
    """

    function: str
    batch_shape: tuple[int, ...]
    vectors: Mapping[str, Array]


def rows_of(vector: Array, batch_shape: tuple[int, ...]) -> Array:
    """Return the vector of each configuration of a batch in a row."""
    components = vector.shape[-1]
    return np.broadcast_to(vector, (*batch_shape, components)).reshape((-1, components))
