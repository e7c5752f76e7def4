"""Runs an algorithm on expressions and keeps what it computed."""

from dataclasses import dataclass, field, replace
from typing import Literal, TypeAlias

from kindsl.mechanics.dynamics.generation.function import homogeneous, inputs_of
from kindsl.mechanics.dynamics.generation.functions import QUANTITIES
from kindsl.mechanics.dynamics.generation.robot import Robot
from kindsl.mechanics.dynamics.generation.terms import Graph, Scalar, Term, needed
from kindsl.mechanics.dynamics.quantities import STANDARD_GRAVITY

# At rest: the base does not move, gravity is the standard one; the code is shorter then.
Conditions: TypeAlias = Literal["at_rest", "any", "loaded"]


@dataclass(frozen=True, slots=True)
class Trace:
    """A computation as a graph.

    Attributes:
        graph: All operations, and more than the outputs need.
        arguments: Of each argument, its components.
        outputs: The results, expressions and constants.
        names: The arguments' names.
    """

    graph: Graph
    arguments: list[list[Term]]
    outputs: list[Scalar]
    names: list[str] = field(default_factory=list)

    def needed(self) -> list[int]:
        """Return the nodes that the outputs depend on, operands first."""
        return needed(self.graph, self.outputs)


def trace(robot: Robot, name: str, conditions: Conditions) -> Trace:
    """Trace the one function of a quantity in `QUANTITIES`.

    Under load the wrenches on all bodies are an argument `fext`.

    Raises:
        SingularInertiaError: If an acceleration is asked for that nothing resists.
    """
    robot = replace(robot, graph=Graph())
    inputs = inputs_of(robot)
    if conditions != "loaded":
        inputs = replace(inputs, external=[])
    if conditions == "at_rest":
        inputs = replace(inputs, v0=[0.0] * 6, a0=[0.0] * 6, g=[*STANDARD_GRAVITY])
    (function,) = QUANTITIES[name].build(robot, inputs)
    results = function.results if conditions != "loaded" else function.loaded or ()
    outputs = [entry for result in results for entry in result.entries]
    if name == "poses":
        outputs = homogeneous(outputs)
    arguments = {a.name: a.components for a in function.arguments if a.components}
    if conditions == "loaded":
        loads = [x for wrench in inputs.external for x in wrench if isinstance(x, Term)]
        arguments["fext"] = loads
    return Trace(robot.graph, [*arguments.values()], outputs, [*arguments])
