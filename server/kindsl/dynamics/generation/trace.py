"""Runs an algorithm on expressions and keeps what it computed."""

from collections.abc import Sequence
from dataclasses import dataclass

from kindsl.dynamics.bodies import Frame
from kindsl.dynamics.generation.composite_bodies import joint_space_inertia
from kindsl.dynamics.generation.expressions import Expression, Graph, Scalar
from kindsl.dynamics.generation.forward_dynamics import forward_dynamics
from kindsl.dynamics.generation.forward_kinematics import poses
from kindsl.dynamics.generation.inverse_dynamics import (
    bias_torque,
    floating_base_inverse_dynamics,
    inverse_dynamics,
)
from kindsl.dynamics.generation.tree import Tree
from kindsl.dynamics.generation.vectors import ZERO, Vector
from kindsl.dynamics.quantities import ARGUMENTS, Quantity


@dataclass(frozen=True, slots=True)
class Trace:
    """A computation as a graph.

    Attributes:
        graph: All operations, and more than the outputs need.
        arguments: Of each argument, its components.
        outputs: The results, expressions and constants.
    """

    graph: Graph
    arguments: list[Vector]
    outputs: list[Scalar]

    def needed(self) -> list[int]:
        """Return the nodes that the outputs depend on, operands first."""
        nodes = self.graph.nodes
        is_needed = [False] * len(nodes)
        for output in self.outputs:
            if isinstance(output, Expression):
                is_needed[output.index] = True
        for index in reversed(range(len(nodes))):
            if is_needed[index]:
                for operand in self.operands(index):
                    is_needed[operand] = True
        return [index for index, needed in enumerate(is_needed) if needed]

    def operands(self, index: int) -> list[int]:
        """Return the nodes that a node depends on directly."""
        operation, *operands = self.graph.nodes[index]
        if operation == "input":
            return []
        return [operand for operand in operands if isinstance(operand, int)]


def trace(
    tree: Tree, frames: tuple[Frame, ...], quantity: Quantity, vanishing: frozenset[str]
) -> Trace:
    """Trace a quantity.

    Args:
        tree: The mechanism.
        frames: The frames whose poses follow those of the links.
        quantity: What to compute.
        vanishing: What is known to be zero, of `base_velocity`, `gravity_x`, `gravity_y` and
            `gravity_z`.

    Raises:
        SingularInertiaError: If an acceleration is asked for that nothing resists.
    """
    graph = Graph()
    n = len(tree.links())
    sizes = {"base_velocity": 6, "gravity": 3}
    arguments = [graph.vector(sizes.get(name, n)) for name in ARGUMENTS[quantity]]
    values = [
        _without(vanishing, name, argument)
        for name, argument in zip(ARGUMENTS[quantity], arguments, strict=True)
    ]
    return Trace(graph, arguments, _outputs(tree, frames, quantity, values))


def _without(vanishing: frozenset[str], name: str, argument: Vector) -> Vector:
    if name == "gravity":
        axes = ("gravity_x", "gravity_y", "gravity_z")
        return [0.0 if a in vanishing else x for a, x in zip(axes, argument, strict=True)]
    return [0.0] * len(argument) if name in vanishing else argument


def _outputs(
    tree: Tree, frames: tuple[Frame, ...], quantity: Quantity, values: Sequence[Vector]
) -> list[Scalar]:
    if quantity == "poses":
        return poses(tree, frames, *values)
    if quantity == "joint_space_inertia":
        return [entry for row in joint_space_inertia(tree, *values) for entry in row]
    if quantity == "inverse_dynamics":
        q, qd, qdd, base_velocity, gravity = values
        if tree.is_floating:
            return floating_base_inverse_dynamics(tree, q, qd, qdd, base_velocity, gravity)
        return inverse_dynamics(tree, q, qd, qdd, gravity)
    if quantity == "forward_dynamics":
        return forward_dynamics(tree, *values)
    if quantity == "gravity_torque":
        q, gravity = values
        return bias_torque(tree, q, [0.0] * len(q), [*ZERO, *ZERO], gravity)
    return bias_torque(tree, *values)
