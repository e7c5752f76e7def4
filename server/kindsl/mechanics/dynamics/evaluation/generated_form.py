"""Evaluates quantities by code that is generated for a mechanism when first asked for."""

import math

import numpy as np

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.evaluation.request import Request
from kindsl.mechanics.dynamics.generation.emitters.numpy_rows import (
    BatchFunction,
    batch_function,
    run_in_chunks,
)
from kindsl.mechanics.dynamics.generation.emitters.scalar_python import (
    NumbersFunction,
    ScalarFunction,
    numbers_function,
    scalar_function,
)
from kindsl.mechanics.dynamics.generation.trace import Conditions, Trace, trace
from kindsl.mechanics.dynamics.generation.tree import Tree, tree_of
from kindsl.mechanics.dynamics.quantities import STANDARD_GRAVITY, Quantity
from kindsl.mechanics.spatial.arrays import Array

# A ufunc's call takes as long as a thousand additions; much longer rows leave the cache.
CHUNK = 5120
# Fewer configurations are computed one by one.
SMALLEST_BATCH = 40


class GeneratedForm:
    """Code for one mechanism; each quantity's is written on its first use.

    Two threads that ask for the same new code both write it, with the same result.

    Attributes:
        bodies: The mechanism.
        at_rest: The functions that are ready for one configuration at rest.
        pose_entries: The one for all entries of its poses, as floats, once it is ready.
    """

    __slots__ = ("_any_motion", "_batch", "_tree", "at_rest", "bodies", "pose_entries")

    def __init__(self, bodies: Bodies) -> None:
        self.bodies = bodies
        self.at_rest: dict[Quantity, ScalarFunction] = {}
        self.pose_entries: NumbersFunction | None = None
        self._any_motion: dict[Quantity, ScalarFunction] = {}
        self._batch: dict[tuple[Quantity, Conditions], BatchFunction] = {}
        self._tree: Tree | None = None

    def evaluate(self, request: Request) -> Array:
        """Return a quantity's entries in one row per configuration, shape (..., entries).

        Raises:
            ZeroDivisionError: For a few configurations, if nothing resists a motion; a batch
                holds values that are not finite then.
            SingularInertiaError: If nothing resists a motion in any configuration.
        """
        quantity, batch_shape, joint_vectors, base_velocity, gravity = request
        is_at_rest = not base_velocity.any() and tuple(gravity.tolist()) == STANDARD_GRAVITY
        conditions: Conditions = "at_rest" if is_at_rest else "any"
        arguments = joint_vectors if is_at_rest else (*joint_vectors, base_velocity, gravity)
        size = math.prod(batch_shape)
        if 0 < size < SMALLEST_BATCH:
            rows = [_flattened(argument, batch_shape) for argument in arguments]
            entries = self._one_by_one(quantity, conditions, rows)
            return entries.reshape((*batch_shape, entries.shape[-1]))
        function = self._batch_function(quantity, conditions)
        columns = [
            argument.tolist() if argument.ndim == 1 else _flattened(argument, batch_shape)
            for argument in arguments
        ]
        by_entry = run_in_chunks(function, columns, size, CHUNK)
        entries = by_entry.reshape((function.n_outputs, *batch_shape))
        return entries.transpose((*range(1, entries.ndim), 0))

    def _one_by_one(
        self, quantity: Quantity, conditions: Conditions, arguments: list[Array]
    ) -> Array:
        functions = self.at_rest if conditions == "at_rest" else self._any_motion
        if quantity not in functions:
            written = self._trace(quantity, conditions)
            functions[quantity] = scalar_function(written)
            if quantity == "poses":
                self.pose_entries = numbers_function(written)
        return np.stack([functions[quantity](*row) for row in zip(*arguments, strict=True)])

    def _batch_function(self, quantity: Quantity, conditions: Conditions) -> BatchFunction:
        key = (quantity, conditions)
        if key not in self._batch:
            self._batch[key] = batch_function(self._trace(quantity, conditions))
        return self._batch[key]

    def _trace(self, quantity: Quantity, conditions: Conditions) -> Trace:
        if self._tree is None:
            self._tree = tree_of(self.bodies)
        return trace(self._tree, self.bodies.frames, quantity, conditions)


def _flattened(argument: Array, batch_shape: tuple[int, ...]) -> Array:
    components = argument.shape[-1]
    if argument.shape[:-1] == batch_shape:
        return argument.reshape((-1, components))
    return np.broadcast_to(argument, (*batch_shape, components)).reshape((-1, components))
