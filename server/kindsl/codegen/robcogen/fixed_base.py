"""Inverse dynamics of a robot whose base stands still: calls, and the code behind them."""

from collections.abc import Sequence

from kindsl.codegen.filling import template
from kindsl.codegen.robcogen.engines import (
    Arguments,
    at_rest,
    kernels_under_loads,
    parameters,
)
from kindsl.codegen.robcogen.link_motions import KEEP_MOTION
from kindsl.codegen.robcogen.robot import GeneratedRobot
from kindsl.dynamics.generation.inverse_dynamics import (
    bias_torque,
    inverse_dynamics,
)
from kindsl.dynamics.generation.terms import Scalar
from kindsl.dynamics.generation.vectors import ZERO, Vector

_CALLS = template("robcogen/inverse_dynamics_fixed.h")
_COMPUTING = template("robcogen/inverse_dynamics_fixed_private.h")


def fixed_base(robot: GeneratedRobot) -> tuple[str, str, list[str]]:
    """Return the class's functions, what they call, and the functions that compute."""
    hidden = robot.filled(_COMPUTING, KEEP=KEEP_MOTION, PARAMETERS=parameters(robot))
    return robot.filled(_CALLS), hidden, _kernels(robot)


def _kernels(robot: GeneratedRobot) -> list[str]:
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
