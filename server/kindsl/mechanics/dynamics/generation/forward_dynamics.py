"""Forward dynamics, for tracing: by the joint-space inertia, or by articulated bodies."""

from dataclasses import replace

from kindsl.mechanics.dynamics.generation.articulated_bodies import accelerations
from kindsl.mechanics.dynamics.generation.composite_bodies import joint_space_inertia
from kindsl.mechanics.dynamics.generation.factorization import solve_symmetric
from kindsl.mechanics.dynamics.generation.function import Inputs
from kindsl.mechanics.dynamics.generation.inverse_dynamics import (
    body_motions,
    loaded,
    newton_euler,
    spatial_acceleration,
)
from kindsl.mechanics.dynamics.generation.terms import Scalar, Term, operations
from kindsl.mechanics.dynamics.generation.tree import Tree, joint_motions
from kindsl.mechanics.dynamics.generation.vectors import ZERO, Vector, subtract

# Articulated bodies take 60 to 560 operations a link, as axes and offsets have it. With fewer a
# link the inertia is solved sooner, with more never.
SURELY_SHALLOW = 100
SURELY_DEEP = 560
# To move a wrench from a joint to the one that carries it.
WRENCH_OPERATIONS = 15


def forward_dynamics(tree: Tree, x: Inputs) -> list[Scalar]:
    """Return the joint accelerations, then a floating base's spatial acceleration.

    Of both ways the one with fewer operations is taken: those of articulated bodies grow with the
    number of bodies, those of the inertia's factors with its square and with the cube of the depth.
    """
    start = ZERO if tree.is_floating else subtract(ZERO, x.g)
    per_link = factorization_operations(tree) / len(tree.links())
    rest = replace(x.unaccelerated(), external=x.external)
    ways = []
    if per_link > SURELY_SHALLOW:
        ways.append(_by_articulated_bodies(tree, rest, start))
    if per_link < SURELY_DEEP:
        ways.append(_by_inertia(tree, rest, start))
    qdd, base = ways[0] if len(ways) == 1 else min(ways, key=lambda way: _operations(*way))
    return [*qdd, *spatial_acceleration(base, x)] if tree.is_floating else qdd


def factorization_operations(tree: Tree) -> int:
    """Return how many operations it takes at least to fill the inertia and to solve with it."""
    depths = [6 if tree.is_floating else 0]
    for i in tree.links():
        depths.append(depths[tree.parents[i]] + 1)
    return sum(depth * (depth + WRENCH_OPERATIONS) for depth in depths[1:])


def _operations(*values: Vector) -> int:
    entries = [x for vector in values for x in vector]
    graph = next((x.graph for x in entries if isinstance(x, Term)), None)
    return operations(graph, entries) if graph is not None else 0


def _by_inertia(tree: Tree, rest: Inputs, start: Vector) -> tuple[Vector, Vector]:
    M = joint_space_inertia(tree, rest.q)
    bias, wrench = newton_euler(tree, rest, start)
    if not tree.is_floating:
        return solve_symmetric(M, subtract(rest.tau, bias)), []
    found = solve_symmetric(M, [*subtract([0.0] * 6, wrench), *subtract(rest.tau, bias)])
    return found[6:], found[:6]


def _by_articulated_bodies(tree: Tree, rest: Inputs, start: Vector) -> tuple[Vector, Vector]:
    joints, tau = joint_motions(tree, rest.q), rest.tau
    wrenches = loaded(body_motions(tree, joints, rest, start), rest.external)
    if tree.drives is not None:
        tau = subtract(tau, tree.drives.force(rest.qd, rest.qdd))
    return accelerations(tree, joints, tau, wrenches)
