"""Evaluates quantities by code that is generated for a mechanism when first asked for."""

import numpy as np

from kindsl.dynamics.bodies import Bodies
from kindsl.dynamics.generation.batch_code import BatchFunction, batch_function, run_in_chunks
from kindsl.dynamics.generation.scalar_code import ScalarFunction, scalar_function
from kindsl.dynamics.generation.trace import Trace, trace
from kindsl.dynamics.generation.tree import Tree, tree_of
from kindsl.dynamics.quantities import ARGUMENTS, Quantity
from kindsl.spatial.arrays import Array

# Measured on arms and quadrupeds: rows of 8 kB, some 50 of them, fit a core's cache.
CHUNK = 1024
# Fewer configurations are computed one by one.
SMALLEST_BATCH = 40

_GRAVITY_AXES = ("gravity_x", "gravity_y", "gravity_z")


class GeneratedForm:
    """Code for one mechanism; each quantity's is written on its first use.

    Two threads that ask for the same new code both write it, with the same result.
    """

    __slots__ = ("_batch", "_scalar", "_tree", "bodies")

    def __init__(self, bodies: Bodies) -> None:
        self.bodies = bodies
        self._tree: Tree | None = None
        self._scalar: dict[tuple[Quantity, frozenset[str]], ScalarFunction] = {}
        self._batch: dict[tuple[Quantity, frozenset[str]], BatchFunction] = {}

    def scalar(self, quantity: Quantity, vanishing: frozenset[str]) -> ScalarFunction:
        """Return the function of lists of floats for one configuration."""
        function = self._scalar.get((quantity, vanishing))
        if function is None:
            function = scalar_function(self._trace(quantity, vanishing))
            self._scalar[quantity, vanishing] = function
        return function

    def batch(self, quantity: Quantity, vanishing: frozenset[str]) -> BatchFunction:
        """Return the function of rows for many configurations."""
        function = self._batch.get((quantity, vanishing))
        if function is None:
            function = batch_function(self._trace(quantity, vanishing))
            self._batch[quantity, vanishing] = function
        return function

    def evaluate(self, quantity: Quantity, arguments: list[Array]) -> Array:
        """Return a quantity's entries in one row per configuration, shape (..., entries).

        Args:
            quantity: What to compute.
            arguments: As `quantities.ARGUMENTS` lists them; leading dimensions broadcast.

        Raises:
            ZeroDivisionError: For one configuration, if nothing resists a motion; a batch holds
                values that are not finite then.
            SingularInertiaError: If nothing resists a motion in any configuration.
        """
        vanishing = _vanishing(quantity, arguments)
        batch_shape = np.broadcast_shapes(*(argument.shape[:-1] for argument in arguments))
        size = int(np.prod(batch_shape))
        if size < SMALLEST_BATCH:
            return self._one_by_one(quantity, vanishing, arguments, batch_shape)
        rows: list[Array | list[float]] = [
            argument.tolist() if argument.ndim == 1 else _flattened(argument, batch_shape)
            for argument in arguments
        ]
        entries = run_in_chunks(self.batch(quantity, vanishing), rows, size, CHUNK)
        return np.moveaxis(entries.reshape((-1, *batch_shape)), 0, -1)

    def _one_by_one(
        self,
        quantity: Quantity,
        vanishing: frozenset[str],
        arguments: list[Array],
        batch_shape: tuple[int, ...],
    ) -> Array:
        function = self.scalar(quantity, vanishing)
        if not batch_shape:
            return np.array(function(*(argument.tolist() for argument in arguments)))
        columns = [_flattened(argument, batch_shape).tolist() for argument in arguments]
        rows = [function(*row) for row in zip(*columns, strict=True)]
        entries = np.array(rows).reshape((len(rows), -1)) if rows else np.zeros((0, 0))
        return entries

    def _trace(self, quantity: Quantity, vanishing: frozenset[str]) -> Trace:
        if self._tree is None:
            self._tree = tree_of(self.bodies)
        return trace(self._tree, self.bodies.frames, quantity, vanishing)


def _vanishing(quantity: Quantity, arguments: list[Array]) -> frozenset[str]:
    named = dict(zip(ARGUMENTS[quantity], arguments, strict=True))
    vanishing = set()
    if "base_velocity" in named and not named["base_velocity"].any():
        vanishing.add("base_velocity")
    if "gravity" in named:
        is_used = named["gravity"].reshape((-1, 3)).any(axis=0).tolist()
        vanishing |= {axis for axis, used in zip(_GRAVITY_AXES, is_used, strict=True) if not used}
    return frozenset(vanishing)


def _flattened(argument: Array, batch_shape: tuple[int, ...]) -> Array:
    components = argument.shape[-1]
    return np.broadcast_to(argument, (*batch_shape, components)).reshape((-1, components))
