"""The functions behind the classes of dynamics and inertia."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import TypeAlias

from kindsl.mechanics.dynamics.generation.composite_bodies import joint_space_inertia
from kindsl.mechanics.dynamics.generation.forward_dynamics import forward_dynamics
from kindsl.mechanics.dynamics.generation.inverse_dynamics import (
    bias_torque,
    floating_base_inverse_dynamics,
    inverse_dynamics,
)
from kindsl.mechanics.dynamics.generation.terms import Scalar
from kindsl.mechanics.dynamics.generation.vectors import ZERO, Vector, transpose
from kindsl.products.codegen.robcogen.robot import GeneratedRobot

Arguments: TypeAlias = Mapping[str, Sequence[Scalar]]


def inertia_kernels(robot: GeneratedRobot) -> list[str]:
    """Return the function that computes mass, centre and moments of each link."""
    values = [value for i in robot.inertial_bodies for value in ten_of(robot, i)]
    return [robot.kernel("inertia_properties", {}, {"m": values})]


def ten_of(robot: GeneratedRobot, body: int) -> list[Scalar]:
    """Return mass, centre, and the upper triangle of the inertia about the origin."""
    moments = robot.library.robot.bodies[body]
    (xx, xy, xz), (_, yy, yz), (_, _, zz) = moments.inertia()
    is_massless = isinstance(moments.mass, float) and not moments.mass
    centre = [0.0 if is_massless else x / moments.mass for x in moments.first]
    return [moments.mass, *centre, xx, xy, xz, yy, yz, zz]


def joint_space_inertia_kernels(robot: GeneratedRobot) -> list[str]:
    """Return the functions of the joint-space inertia matrix."""
    M = joint_space_inertia(robot.tree, robot.library.inputs.q)
    return robot.matrix_kernels("joint_space_inertia", transpose(M))


def inverse_dynamics_kernels(robot: GeneratedRobot) -> list[str]:
    """Return the functions that compute joint forces, and what of them gravity and speed are."""
    return (_of_floating_base if robot.is_floating else _of_fixed_base)(robot)


def _of_fixed_base(robot: GeneratedRobot) -> list[str]:
    """Return functions for a base that stands still."""
    graph, tree, x = robot.library.robot.graph, robot.tree, robot.library.inputs
    g = graph.input()
    weight: Vector = [0.0, 0.0, -g]
    motion: dict[str, Sequence[Scalar]] = {"q": x.q, "qd": x.qd, "qdd": x.qdd, "g": [g]}
    still = bias_torque(tree, replace(x, qd=[0.0] * robot.n_joints, g=weight))
    floating = bias_torque(tree, replace(x, g=ZERO))

    def results(forces: list[Vector]) -> Arguments:
        return {"tau": inverse_dynamics(tree, replace(x, g=weight, external=forces))}

    return [
        *_under_loads(robot, "inverse_dynamics", motion, results),
        robot.kernel("gravity", {"q": x.q, "g": [g]}, {"tau": still}),
        robot.kernel("coriolis", {"q": x.q, "qd": x.qd}, {"tau": floating}),
    ]


def _of_floating_base(robot: GeneratedRobot) -> list[str]:
    """Return functions for a base in free fall; what gravity does is added to accelerations."""
    tree, x, n = robot.tree, replace(robot.library.inputs, g=ZERO), robot.n_joints
    motion: dict[str, Sequence[Scalar]] = {"q": x.q, "qd": x.qd, "qdd": x.qdd, "v0": x.v0}
    driven = {**motion, "a0": x.a0}

    def free(forces: list[Vector]) -> Arguments:
        found = floating_base_inverse_dynamics(tree, replace(x, external=forces))
        return {"tau": found[:n], "a0": found[n:]}

    def held(forces: list[Vector]) -> Arguments:
        found = inverse_dynamics(tree, replace(x, external=forces))
        return {"tau": found[6:], "f0": found[:6]}

    kernels = _under_loads(robot, "inverse_dynamics", motion, free)
    kernels += _under_loads(robot, "inverse_dynamics_actuated", driven, held)
    rest: Vector = [0.0] * n
    weight = inverse_dynamics(tree, replace(x, qd=rest, qdd=rest, v0=[0.0] * 6, external=[]))
    moving = bias_torque(tree, x)
    gives = {"tau": weight[6:], "f0": weight[:6]}
    kernels.append(robot.kernel("gravity", {"q": x.q, "a0": x.a0}, gives))
    takes = {"q": x.q, "qd": x.qd, "v0": x.v0}
    kernels.append(robot.kernel("coriolis", takes, {"tau": moving[6:], "f0": moving[:6]}))
    return kernels


def forward_dynamics_kernels(robot: GeneratedRobot) -> list[str]:
    """Return the functions that compute joint accelerations."""
    tree, x, n = robot.tree, robot.library.inputs, robot.n_joints
    takes: dict[str, Sequence[Scalar]] = {"q": x.q, "qd": x.qd, "tau": x.tau}
    weight: Vector = ZERO
    if robot.is_floating:
        takes["v0"] = x.v0
    else:
        g = robot.library.robot.graph.input()
        takes["g"], weight = [g], [0.0, 0.0, -g]

    def results(forces: list[Vector]) -> Arguments:
        found = forward_dynamics(tree, replace(x, g=weight, external=forces))
        return {"qdd": found[:n], "a0": found[n:]} if robot.is_floating else {"qdd": found[:n]}

    return _under_loads(robot, "forward_dynamics", takes, results)


def _under_loads(
    robot: GeneratedRobot, name: str, takes: Arguments, results: Callable[[list[Vector]], Arguments]
) -> list[str]:
    """Return a function without forces on links, and with them: its name with `_loaded`.

    That of a large robot is one for both, which compilers take half the time for: forces add little
    there.

    Args:
        name: The function's name.
        takes: Its arguments.
        results: Takes the wrench on each body, none for no forces; returns the results.
    """
    given: Arguments = {**takes, "fext": robot.library.external}
    loaded = results(robot.library.inputs.external)
    with_loads = robot.kernel(f"{name}_loaded", given, loaded)
    if not robot.is_large:
        return [robot.kernel(name, takes, results([])), with_loads]
    number, first = "typename TRAIT::Scalar", ["p"] if robot.has_parameters else []
    declared = [f"const {number}* {n}" for n in (*first, *takes)]
    without = robot.rendered(
        "without_loads.h",
        function=name,
        declared=declared + [f"{number}* {n}" for n in loaded],
        handed_on=[*first, *takes, "none", *loaded],
        size=len(given["fext"]),
    )
    return [with_loads, without]
