"""Runs an algorithm on expressions and keeps what it computed."""

from dataclasses import dataclass
from typing import Literal, TypeAlias

from kindsl.mechanics.dynamics.bodies import BodyFrame
from kindsl.mechanics.dynamics.generation.composite_bodies import joint_space_inertia
from kindsl.mechanics.dynamics.generation.forward_dynamics import forward_dynamics
from kindsl.mechanics.dynamics.generation.forward_kinematics import poses
from kindsl.mechanics.dynamics.generation.inverse_dynamics import (
    bias_torque,
    floating_base_inverse_dynamics,
    inverse_dynamics,
)
from kindsl.mechanics.dynamics.generation.terms import (
    Graph,
    Scalar,
    Term,
    needed,
    operand_nodes,
)
from kindsl.mechanics.dynamics.generation.tree import Tree
from kindsl.mechanics.dynamics.generation.vectors import Vector
from kindsl.mechanics.dynamics.quantities import JOINT_VECTORS, STANDARD_GRAVITY, Quantity

# At rest: the base does not move, gravity is the standard one; the code is shorter then.
Conditions: TypeAlias = Literal["at_rest", "any"]


@dataclass(frozen=True, slots=True)
class Trace:
    """A computation as a graph.

    Attributes:
        graph: All operations, and more than the outputs need.
        arguments: Of each argument, its components.
        outputs: The results, expressions and constants.
    """

    graph: Graph
    arguments: list[list[Term]]
    outputs: list[Scalar]

    def needed(self) -> list[int]:
        """Return the nodes that the outputs depend on, operands first."""
        return needed(self.graph, self.outputs)

    def operands(self, index: int) -> list[int]:
        """Return the nodes that a node depends on directly."""
        return operand_nodes(self.graph, index)


def trace(
    tree: Tree, frames: tuple[BodyFrame, ...], quantity: Quantity, conditions: Conditions
) -> Trace:
    """Trace a quantity.

    Args:
        tree: The mechanism.
        frames: The frames whose poses follow those of the links.
        quantity: The quantity to compute.
        conditions: Values known beforehand. Under any conditions the base's velocity, if it
            floats, and gravity are arguments too.

    Raises:
        SingularInertiaError: If an acceleration is asked for that nothing resists.
    """
    graph = Graph()
    arguments = [graph.vector(len(tree.links())) for _ in JOINT_VECTORS[quantity]]
    joint_vectors: list[Vector] = [[*argument] for argument in arguments]
    base_velocity: Vector = [0.0] * 6
    gravity: Vector = [*STANDARD_GRAVITY]
    if conditions == "any":
        arguments += [graph.vector(6), graph.vector(3)]
        gravity = [*arguments[-1]]
        if tree.is_floating:
            base_velocity = [*arguments[-2]]
    outputs = _outputs(tree, frames, quantity, joint_vectors, base_velocity, gravity)
    return Trace(graph, arguments, outputs)


def _outputs(
    tree: Tree,
    frames: tuple[BodyFrame, ...],
    quantity: Quantity,
    joint_vectors: list[Vector],
    base_velocity: Vector,
    gravity: Vector,
) -> list[Scalar]:
    q = joint_vectors[0]
    rest: Vector = [0.0] * len(q)
    if quantity == "poses":
        return poses(tree, frames, q)
    if quantity == "joint_space_inertia":
        return [entry for row in joint_space_inertia(tree, q) for entry in row]
    if quantity == "gravity_torque":
        return bias_torque(tree, q, rest, [0.0] * 6, gravity)
    qd = joint_vectors[1]
    if quantity == "bias_torque":
        return bias_torque(tree, q, qd, base_velocity, gravity)
    if quantity == "forward_dynamics":
        return forward_dynamics(tree, q, qd, joint_vectors[2], base_velocity, gravity)
    qdd = joint_vectors[2]
    if tree.is_floating:
        return floating_base_inverse_dynamics(tree, q, qd, qdd, base_velocity, gravity)
    return inverse_dynamics(tree, q, qd, qdd, gravity)
