"""Answers by code that is generated for a mechanism, or by the book's algorithms.

Generated code stays because of its speed: in Python it answers one configuration ten to thirty
times sooner than the book's algorithms (the quadruped's inverse dynamics 0.12 ms against 1 ms), in
NumPy rows a batch of a thousand ten times sooner; see benchmarks/dynamics.py.
"""

import math

import numpy as np

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.evaluation import book
from kindsl.mechanics.dynamics.evaluation.book import Request, rows_of
from kindsl.mechanics.dynamics.generation.emitters.numpy_rows import (
    BatchFunction,
    batch_function,
    run_in_chunks,
)
from kindsl.mechanics.dynamics.generation.emitters.scalar_python import (
    ScalarFunction,
    scalar_function,
)
from kindsl.mechanics.dynamics.generation.robot import Robot, robot_of
from kindsl.mechanics.dynamics.generation.trace import Conditions, Trace, trace
from kindsl.mechanics.dynamics.quantities import STANDARD_GRAVITY
from kindsl.mechanics.spatial.arrays import Array

# More links take longer to generate code for than anyone wants to wait.
MOST_LINKS_TO_GENERATE_FOR = 30
# Of longer chains, these quantities' code grows with the number of links only, and so many
# configurations take longer in the other form than code takes to generate.
LINEAR = (
    "poses", "inverse_dynamics", "inverse_dynamics_actuated", "forward_dynamics", "gravity_torque",
    "bias_torque",
)  # fmt: skip
WORTH_GENERATING = 3000


# A ufunc's call takes as long as a thousand additions; much longer rows leave the cache.
CHUNK = 5120
# Fewer configurations are computed one by one.
SMALLEST_BATCH = 40


class Forms:
    """Code for one mechanism, each quantity's written on its first use, and the book beside it.

    Two threads that ask for the same new code both write it, with the same result.

    Attributes:
        bodies: The mechanism.
        at_rest: The functions that are ready for one configuration at rest.
    """

    __slots__ = ("_batch", "_generates_code", "_robot", "_single", "at_rest", "bodies")

    def __init__(self, bodies: Bodies, *, generates_code: bool = True) -> None:
        self.bodies = bodies
        self.at_rest: dict[str, ScalarFunction] = {}
        self._generates_code = generates_code
        self._single: dict[tuple[str, Conditions], tuple[ScalarFunction, list[str]]] = {}
        self._batch: dict[tuple[str, Conditions], tuple[BatchFunction, list[str]]] = {}
        self._robot: Robot | None = None

    def evaluate(self, request: Request) -> Array:
        """Return a quantity's entries in one row per configuration, by the form that is sooner.

        Shape (..., entries).

        Raises:
            SingularInertiaError, ZeroDivisionError, numpy.linalg.LinAlgError: If nothing resists a
                motion; or the result holds values that are not finite.
        """
        is_large = math.prod(request.batch_shape) >= WORTH_GENERATING
        is_worth_it = self.bodies.n_links <= MOST_LINKS_TO_GENERATE_FOR or (
            request.function in LINEAR and is_large
        )
        if self._generates_code and is_worth_it:
            return self.by_code(request)
        return book.evaluate(self.bodies, request)

    def by_code(self, request: Request) -> Array:
        """Return the same by code.

        Raises:
            ZeroDivisionError: For a few configurations, if nothing resists a motion; a batch
                holds values that are not finite then.
            SingularInertiaError: If nothing resists a motion in any configuration.
        """
        key = request.function, _conditions(request)
        _, shape, vectors = request
        size = math.prod(shape)
        if 0 < size < SMALLEST_BATCH:
            single, names = self._single.get(key) or self._new_single(*key)
            rows = zip(*(rows_of(vectors[name], shape) for name in names), strict=True)
            entries = np.stack([single(*row) for row in rows])
            return entries.reshape((*shape, entries.shape[-1]))
        if key not in self._batch:
            recorded = self._trace(*key)
            self._batch[key] = batch_function(recorded), recorded.names
        function, names = self._batch[key]
        columns = [
            vectors[name].tolist() if vectors[name].ndim == 1 else rows_of(vectors[name], shape)
            for name in names
        ]
        by_entry = run_in_chunks(function, columns, size, CHUNK)
        entries = by_entry.reshape((function.n_outputs, *shape))
        return entries.transpose((*range(1, entries.ndim), 0))

    def _new_single(self, name: str, conditions: Conditions) -> tuple[ScalarFunction, list[str]]:
        recorded = self._trace(name, conditions)
        found = self._single[name, conditions] = scalar_function(recorded), recorded.names
        if conditions == "at_rest":
            self.at_rest[name] = found[0]
        return found

    def _trace(self, name: str, conditions: Conditions) -> Trace:
        if self._robot is None:
            self._robot = robot_of(self.bodies)
        return trace(self._robot, name, conditions)


def _conditions(request: Request) -> Conditions:
    vectors = request.vectors
    if "fext" in vectors:
        return "loaded"
    is_standard = tuple(vectors["g"].tolist()) == STANDARD_GRAVITY
    is_still = "a0" not in vectors and not vectors["v0"].any()
    return "at_rest" if is_still and is_standard else "any"
