"""Inverse dynamics of a robot whose base is free, or driven: calls, and the code behind them."""

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
    actuated_base_inverse_dynamics,
    bias_torque,
    floating_base_inverse_dynamics,
)
from kindsl.dynamics.generation.terms import Scalar
from kindsl.dynamics.generation.vectors import ZERO, Vector

_CALLS = template("robcogen/inverse_dynamics_floating.h")
_COMPUTING = template("robcogen/inverse_dynamics_floating_private.h")


def floating_base(robot: GeneratedRobot) -> tuple[str, str, list[str]]:
    """Return the class's functions, what they call, and the functions that compute."""
    hidden = robot.filled(_COMPUTING, KEEP=KEEP_MOTION, PARAMETERS=parameters(robot))
    return robot.filled(_CALLS), hidden, _kernels(robot)


def _kernels(robot: GeneratedRobot) -> list[str]:
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
