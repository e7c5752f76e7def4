"""A compiled module with functions for one robot."""

from collections.abc import Callable
from typing import Any

from kindsl.mechanics.dynamics.evaluation.compiling import compiled_module
from kindsl.mechanics.dynamics.evaluation.kernels import RESULT_CLASSES, kernels_of
from kindsl.mechanics.dynamics.generation.emitters.extension import MODULE, extension_source
from kindsl.mechanics.dynamics.generation.robot import Robot
from kindsl.mechanics.dynamics.quantities import STANDARD_GRAVITY

Method = Callable[..., Any]


class Extension:
    """The functions of a group.

    Attributes:
        names: Their names.
        shapes: The shapes of their results.
    """

    def __init__(self, robot: Robot, group: str) -> None:
        kernels = kernels_of(robot, group)
        self.names = frozenset(kernel.name for kernel in kernels)
        self.shapes = {
            kernel.name: [result.shape for result in kernel.results] for kernel in kernels
        }
        source = extension_source(robot.graph, kernels, STANDARD_GRAVITY)
        self._module = compiled_module(MODULE, source)

    def bind(self, name: str, general: Method, batches: bool) -> Method:
        """Return a compiled function that calls `general` for what it does not take."""
        bound: Method = self._module.bind(name, general, RESULT_CLASSES.get(name), batches)
        return bound


def not_direct(*_: object, **__: object) -> None:
    """Tell that Python has to look at the arguments."""
