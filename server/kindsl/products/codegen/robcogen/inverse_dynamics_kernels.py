"""The code that inverse dynamics calls: of a base that stands still, of a free, of a driven one."""

from collections.abc import Sequence

from kindsl.mechanics.dynamics.generation.inverse_dynamics import (
    actuated_base_inverse_dynamics,
    bias_torque,
    floating_base_inverse_dynamics,
    inverse_dynamics,
)
from kindsl.mechanics.dynamics.generation.terms import Scalar
from kindsl.mechanics.dynamics.generation.vectors import ZERO, Vector
from kindsl.products.codegen.robcogen.engines import Arguments, at_rest, kernels_under_loads
from kindsl.products.codegen.robcogen.robot import GeneratedRobot


def inverse_dynamics_kernels(robot: GeneratedRobot) -> list[str]:
    """Return the functions that compute joint forces, and what of them gravity and speed are."""
    return (_of_floating_base if robot.is_floating else _of_fixed_base)(robot)


def _of_fixed_base(robot: GeneratedRobot) -> list[str]:
    """Return functions for a base that stands still."""
    graph, tree, x = robot.library.robot.graph, robot.tree, robot.library.inputs
    g = graph.input()
    weight: Vector = [0.0, 0.0, -g]
    motion: dict[str, Sequence[Scalar]] = {"q": x.q, "qd": x.qd, "qdd": x.qdd, "g": [g]}
    rest = at_rest(robot)
    still = bias_torque(tree, x.q, rest, [0.0] * 6, weight)
    floating = bias_torque(tree, x.q, x.qd, [0.0] * 6, ZERO)

    def results(forces: Sequence[Vector]) -> Arguments:
        return {"tau": inverse_dynamics(tree, x.q, x.qd, x.qdd, weight, forces)}

    return [
        *kernels_under_loads(robot, "inverse_dynamics", motion, results),
        robot.kernel("gravity", {"q": x.q, "g": [g]}, {"tau": still}),
        robot.kernel("coriolis", {"q": x.q, "qd": x.qd}, {"tau": floating}),
    ]


def _of_floating_base(robot: GeneratedRobot) -> list[str]:
    """Return functions for a base in free fall; what gravity does is added to accelerations."""
    tree, x, n = robot.tree, robot.library.inputs, robot.n_joints
    motion: dict[str, Sequence[Scalar]] = {"q": x.q, "qd": x.qd, "qdd": x.qdd, "v0": x.v0}
    driven = {**motion, "a0": x.a0}

    def free(forces: Sequence[Vector]) -> Arguments:
        found = floating_base_inverse_dynamics(tree, x.q, x.qd, x.qdd, x.v0, ZERO, forces)
        return {"tau": found[:n], "a0": found[n:]}

    def held(forces: Sequence[Vector]) -> Arguments:
        found = actuated_base_inverse_dynamics(tree, x.q, x.qd, x.qdd, x.v0, x.a0, ZERO, forces)
        return {"tau": found[6:], "f0": found[:6]}

    kernels = kernels_under_loads(robot, "inverse_dynamics", motion, free)
    kernels += kernels_under_loads(robot, "inverse_dynamics_actuated", driven, held)
    rest, still = at_rest(robot), [0.0] * 6
    weight = actuated_base_inverse_dynamics(tree, x.q, rest, rest, [*still], x.a0, ZERO)
    moving = bias_torque(tree, x.q, x.qd, x.v0, ZERO)
    gives = {"tau": weight[6:], "f0": weight[:6]}
    kernels.append(robot.kernel("gravity", {"q": x.q, "a0": x.a0}, gives))
    takes = {"q": x.q, "qd": x.qd, "v0": x.v0}
    kernels.append(robot.kernel("coriolis", takes, {"tau": moving[6:], "f0": moving[:6]}))
    return kernels
