"""The questions asked of every form."""

from typing import NamedTuple

import numpy as np

from kindsl.mechanics.dynamics.quantities import JOINT_VECTORS, Quantity
from kindsl.mechanics.spatial.arrays import Array


class Request(NamedTuple):
    """A quantity for a batch of configurations.

    Attributes:
        quantity: The quantity to compute.
        batch_shape: Common shape of the leading dimensions of all that follows.
        joint_vectors: As `quantities.JOINT_VECTORS` lists them, each of shape (..., n).
        base_velocity: Shape (..., 6), zero for a fixed base.
        gravity: Shape (..., 3), m/s^2, base coordinates.
        base_acceleration: Of inverse dynamics with a given one, shape (..., 6); None elsewhere.
        external: The wrenches on all bodies, shape (..., 6 (n + 1)), None for none.
    """

    quantity: Quantity
    batch_shape: tuple[int, ...]
    joint_vectors: tuple[Array, ...]
    base_velocity: Array
    gravity: Array
    base_acceleration: Array | None = None
    external: Array | None = None

    @property
    def function(self) -> str:
        """The name of the generated function that computes it."""
        is_actuated = self.base_acceleration is not None
        return f"{self.quantity}_actuated" if is_actuated else self.quantity

    def vectors(self) -> dict[str, Array]:
        """Return all vectors that are there by the names that generated functions have for them."""
        joints = zip(JOINT_VECTORS[self.quantity], self.joint_vectors, strict=True)
        others = {
            "v0": self.base_velocity, "a0": self.base_acceleration,
            "g": self.gravity, "fext": self.external,
        }  # fmt: skip
        return {**dict(joints), **{k: x for k, x in others.items() if x is not None}}


def rows_of(vector: Array, batch_shape: tuple[int, ...]) -> Array:
    """Return the vector of each configuration of a batch in a row."""
    components = vector.shape[-1]
    return np.broadcast_to(vector, (*batch_shape, components)).reshape((-1, components))
