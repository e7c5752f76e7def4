"""`forward_dynamics.h` and `forward_dynamics.impl.h`."""

from collections.abc import Sequence

from kindsl.mechanics.dynamics.generation.forward_dynamics import forward_dynamics
from kindsl.mechanics.dynamics.generation.terms import Scalar
from kindsl.mechanics.dynamics.generation.vectors import ZERO, Vector
from kindsl.products.codegen.filling import template
from kindsl.products.codegen.robcogen.engines import (
    Arguments,
    Engine,
    engine_headers,
    kernels_under_loads,
    parameters,
)
from kindsl.products.codegen.robcogen.robot import GeneratedRobot


def forward_dynamics_headers(robot: GeneratedRobot) -> dict[str, str]:
    """Return both headers by their names."""
    file = f"robcogen/forward_dynamics_{'floating' if robot.is_floating else 'fixed'}"
    computing = robot.filled(template(f"{file}_private.h"), PARAMETERS=parameters(robot))
    construction = "    ForwardDynamics(IProperties& in, MTransforms& tr)"
    calls = robot.filled(template(f"{file}.h"))
    engine = Engine(
        "ForwardDynamics",
        "The joint accelerations under joint forces.",
        f"{construction} : inertiaProps(&in), xm(&tr) {{}}\n\n{calls}",
        f"private:\n{computing}",
    )
    return engine_headers(robot, "forward_dynamics", engine, _kernels(robot))


def _kernels(robot: GeneratedRobot) -> list[str]:
    tree, x, n = robot.tree, robot.library.inputs, robot.n_joints
    takes: dict[str, Sequence[Scalar]] = {"q": x.q, "qd": x.qd, "tau": x.tau}
    weight: Vector = ZERO
    if robot.is_floating:
        takes["v0"] = x.v0
    else:
        g = robot.library.robot.graph.input()
        takes["g"], weight = [g], [0.0, 0.0, -g]

    def results(forces: Sequence[Vector]) -> Arguments:
        found = forward_dynamics(tree, x.q, x.qd, x.tau, x.v0, weight, forces)
        return {"qdd": found[:n], "a0": found[n:]} if robot.is_floating else {"qdd": found[:n]}

    return kernels_under_loads(robot, "forward_dynamics", takes, results)
