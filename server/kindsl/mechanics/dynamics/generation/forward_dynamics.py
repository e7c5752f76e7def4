"""Forward dynamics, for tracing: bias and joint-space inertia, solved along the branches."""

from collections.abc import Sequence

from kindsl.mechanics.dynamics.generation.composite_bodies import joint_space_inertia
from kindsl.mechanics.dynamics.generation.factorization import solve_symmetric
from kindsl.mechanics.dynamics.generation.inverse_dynamics import newton_euler, spatial_acceleration
from kindsl.mechanics.dynamics.generation.terms import Scalar
from kindsl.mechanics.dynamics.generation.tree import Tree
from kindsl.mechanics.dynamics.generation.vectors import ZERO, Vector, subtract


def forward_dynamics(
    tree: Tree,
    q: Vector,
    qd: Vector,
    tau: Vector,
    base_velocity: Vector,
    gravity: Vector,
    external: Sequence[Vector] = (),
) -> list[Scalar]:
    """Return the joint accelerations, then a floating base's spatial acceleration."""
    rest: Vector = [0.0] * len(q)
    M = joint_space_inertia(tree, q)
    if not tree.is_floating:
        up = subtract(ZERO, gravity)
        bias, _ = newton_euler(tree, q, qd, rest, ZERO, up, external=external)
        return solve_symmetric(M, subtract(tau, bias))
    w, v = base_velocity[:3], base_velocity[3:]
    bias, wrench = newton_euler(tree, q, qd, rest, w, ZERO, external=external)
    forces = [*subtract([0.0] * 6, wrench), *subtract(tau, bias)]
    accelerations = solve_symmetric(M, forces)
    return [*accelerations[6:], *spatial_acceleration(accelerations[:6], w, v, gravity)]
