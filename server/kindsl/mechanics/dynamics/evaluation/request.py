"""The questions asked of every form."""

from typing import NamedTuple

from kindsl.mechanics.dynamics.quantities import Quantity
from kindsl.mechanics.spatial.arrays import Array


class Request(NamedTuple):
    """A quantity for a batch of configurations.

    Attributes:
        quantity: The quantity to compute.
        batch_shape: Common shape of the leading dimensions of all that follows.
        joint_vectors: As `quantities.JOINT_VECTORS` lists them, each of shape (..., n).
        base_velocity: Shape (..., 6), zero for a fixed base.
        gravity: Shape (..., 3), m/s^2, base coordinates.
    """

    quantity: Quantity
    batch_shape: tuple[int, ...]
    joint_vectors: tuple[Array, ...]
    base_velocity: Array
    gravity: Array
