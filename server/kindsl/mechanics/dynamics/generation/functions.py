"""All that can be generated for a mechanism, as functions with named arguments and results.

Base coordinates, angular part first; a floating base adds its six rows and columns in front.
"""

from collections.abc import Callable
from dataclasses import replace
from typing import Final, Literal, NamedTuple

from kindsl.mechanics.dynamics.generation import masses
from kindsl.mechanics.dynamics.generation import whole_body_functions as whole_body
from kindsl.mechanics.dynamics.generation.composite_bodies import joint_space_inertia
from kindsl.mechanics.dynamics.generation.derivative_functions import (
    forward_dynamics_derivatives,
    inverse_dynamics_derivatives,
    regressor,
)
from kindsl.mechanics.dynamics.generation.factorization import factorize
from kindsl.mechanics.dynamics.generation.forward_dynamics import forward_dynamics
from kindsl.mechanics.dynamics.generation.function import Function, Inputs, Result, argument, matrix
from kindsl.mechanics.dynamics.generation.inverse_dynamics import (
    bias_torque,
    floating_base_inverse_dynamics,
    inverse_dynamics,
)
from kindsl.mechanics.dynamics.generation.jacobians import body_poses, feet, frame_pose, jacobian
from kindsl.mechanics.dynamics.generation.relative_frames import relative_columns
from kindsl.mechanics.dynamics.generation.robot import PlacedFrame, Robot
from kindsl.mechanics.dynamics.generation.terms import Scalar
from kindsl.mechanics.dynamics.generation.vectors import EYE, ZERO, Vector, transpose

Builder = Callable[[Robot, Inputs], list[Function]]


class QuantityCode(NamedTuple):
    """One quantity that code is generated for.

    Attributes:
        build: Records its functions.
        group: What is generated only when asked for, derivatives or what is for control, by the
            name of the option; empty for others.
        needs_mass: Whether the total mass must not be zero.
    """

    build: Builder
    group: Literal["", "derivatives", "control"] = ""
    needs_mass: bool = False


def poses(robot: Robot, inputs: Inputs) -> list[Function]:
    """Record `base_T_x` of all links, then frames, without the last row."""
    found = body_poses(robot.tree, inputs.q)
    entries: list[Scalar] = []
    for frame in robot.targets:
        R, r = frame_pose(found, frame)
        entries += [x for row, c in zip(R, r, strict=True) for x in (*row, c)]
    shape = (len(robot.targets), 3, 4)
    summary = "the upper three rows of base_T_x of each link, then of each frame x"
    return [Function("poses", summary, inputs.positions, (Result("T", shape, entries),))]


def jacobians(robot: Robot, inputs: Inputs) -> list[Function]:
    """Record each link's and frame's Jacobian, in its own and in base coordinates."""
    found, functions = body_poses(robot.tree, inputs.q), []
    for frame in robot.targets:
        own, _ = frame_pose(found, frame)
        for suffix, seen_from, where in (
            ("", own, "own coordinates"),
            ("_in_base", EYE, "base coordinates"),
        ):
            J = jacobian(robot, found, frame, seen_from)
            functions.append(
                Function(
                    f"jacobian_{frame.name}{suffix}",
                    f"the geometric Jacobian of {frame.name}'s origin, in {where}",
                    inputs.positions,
                    (matrix("J", J),),
                    about=(frame.name,),
                )
            )
    return functions


def foot_jacobians(robot: Robot, inputs: Inputs) -> list[Function]:
    """Record the feet's Jacobians together."""
    base = PlacedFrame(robot.base_name, 0, EYE, ZERO)
    about = tuple(foot.name for foot in feet(robot))
    results = [
        matrix(f"J_{foot.name}", transpose(relative_columns(robot, inputs.q, base, foot)))
        for foot in feet(robot)
    ]
    summary = (
        "the feet's Jacobians relative to the base, in base coordinates, each with the columns "
        "of the joints that carry it"
    )
    function = Function("foot_jacobians", summary, inputs.positions, tuple(results), about=about)
    return [function] if results else []


def inertia(robot: Robot, inputs: Inputs) -> list[Function]:
    """Record the joint-space inertia."""
    result = matrix("M", joint_space_inertia(robot.tree, inputs.q))
    summary = "the joint-space inertia"
    return [Function("joint_space_inertia", summary, inputs.positions, (result,))]


def inertia_factorization(robot: Robot, inputs: Inputs) -> list[Function]:
    """Record `L` and `D` of `M = L^T D L`."""
    factors = factorize(joint_space_inertia(robot.tree, inputs.q))
    size = len(factors.inverse_pivots)
    unit: list[Vector] = [
        [*row[:-1], 1.0, *[0.0] * (size - i - 1)] for i, row in enumerate(factors.L)
    ]
    D = [row[-1] for row in factors.L]
    results = (matrix("L", unit), Result("D", (size,), D))
    summary = "M = L^T D L, L unit lower triangular with the zeros of the branches"
    return [Function("inertia_factorization", summary, inputs.positions, results)]


def _with_and_without_loads(
    results: Callable[[Inputs], tuple[Result, ...]], inputs: Inputs
) -> tuple[tuple[Result, ...], tuple[Result, ...] | None]:
    """Return results without external forces, then under these, if there are such inputs."""
    free = results(replace(inputs, external=[]))
    return free, results(inputs) if inputs.external else None


def inverse(robot: Robot, inputs: Inputs) -> list[Function]:
    """Record inverse dynamics; without any wrench on a floating base."""
    n = len(robot.link_names)

    def results(x: Inputs) -> tuple[Result, ...]:
        if not robot.tree.is_floating:
            return (Result("tau", (n,), inverse_dynamics(robot.tree, x)),)
        entries = floating_base_inverse_dynamics(robot.tree, x)
        return Result("tau", (n,), entries[:n]), Result("a0", (6,), entries[n:])

    what = ", and the base's acceleration under no wrench" if robot.tree.is_floating else ""
    summary, both = f"the joint forces of a motion{what}", _with_and_without_loads(results, inputs)
    return [Function("inverse_dynamics", summary, inputs.motion("qdd"), *both)]


def actuated(robot: Robot, inputs: Inputs) -> list[Function]:
    """Record inverse dynamics with a wrench on the floating base; nothing for a fixed one."""
    if not robot.tree.is_floating:
        return []
    n = len(robot.link_names)

    def results(x: Inputs) -> tuple[Result, ...]:
        entries = inverse_dynamics(robot.tree, x)
        return Result("tau", (n,), entries[6:]), Result("f0", (6,), entries[:6])

    summary = "the joint forces and the base's wrench of a motion"
    arguments, both = inputs.motion("qdd", "a0"), _with_and_without_loads(results, inputs)
    return [Function("inverse_dynamics_actuated", summary, arguments, *both)]


def forward(robot: Robot, inputs: Inputs) -> list[Function]:
    """Record forward dynamics."""
    n = len(robot.link_names)

    def results(x: Inputs) -> tuple[Result, ...]:
        entries = forward_dynamics(robot.tree, x)
        parts = (Result("qdd", (n,), entries[:n]), Result("a0", (6,), entries[n:]))
        return parts if robot.tree.is_floating else parts[:1]

    what = ", and the base's acceleration" if robot.tree.is_floating else ""
    summary = f"the joint accelerations under joint forces{what}"
    both = _with_and_without_loads(results, inputs)
    return [Function("forward_dynamics", summary, inputs.motion("tau"), *both)]


def gravity(robot: Robot, inputs: Inputs) -> list[Function]:
    """Record the forces that hold the mechanism at rest."""
    tau = bias_torque(robot.tree, replace(inputs, qd=[0.0] * len(inputs.q), v0=[0.0] * 6))
    arguments = (*inputs.positions, argument("g", inputs.g))
    summary = "the forces that hold the mechanism at rest"
    return [Function("gravity_torque", summary, arguments, (Result("tau", (len(tau),), tau),))]


def bias(robot: Robot, inputs: Inputs) -> list[Function]:
    """Record the forces at zero acceleration."""
    tau = bias_torque(robot.tree, inputs)
    summary = "the forces at zero acceleration, gravity's included"
    result = Result("tau", (len(tau),), tau)
    return [Function("bias_torque", summary, inputs.motion(), (result,))]


def energies(robot: Robot, inputs: Inputs) -> list[Function]:
    """Record kinetic and potential energy."""
    T = masses.kinetic_energy(robot, inputs)
    V = masses.potential_energy(robot, body_poses(robot.tree, inputs.q), inputs.g)
    *moving, g = inputs.motion()
    kinetic, potential = Result("T", (1,), [T]), Result("V", (1,), [V])
    about = "the potential energy, zero for all mass at the base's origin"
    return [
        Function("kinetic_energy", "the kinetic energy", tuple(moving), (kinetic,)),
        Function("potential_energy", about, (*inputs.positions, g), (potential,)),
    ]


def center_of_mass(robot: Robot, inputs: Inputs) -> list[Function]:
    """Record the centre of mass and its Jacobian."""
    found = body_poses(robot.tree, inputs.q)
    com = Result("c", (3,), masses.center_of_mass(robot, found))
    J = matrix("J", masses.center_of_mass_jacobian(robot, found))
    given, what = inputs.positions, "the centre of mass"
    return [
        Function("center_of_mass", f"{what} of all bodies", given, (com,)),
        Function(
            "center_of_mass_jacobian", f"the Jacobian of {what}, in base coordinates", given, (J,)
        ),
    ]


QUANTITIES: Final[dict[str, QuantityCode]] = {
    "poses": QuantityCode(poses),
    "jacobians": QuantityCode(jacobians),
    "foot_jacobians": QuantityCode(foot_jacobians),
    "inverse_dynamics": QuantityCode(inverse),
    "inverse_dynamics_actuated": QuantityCode(actuated),
    "forward_dynamics": QuantityCode(forward),
    "joint_space_inertia": QuantityCode(inertia),
    "inertia_factorization": QuantityCode(inertia_factorization),
    "gravity_torque": QuantityCode(gravity),
    "bias_torque": QuantityCode(bias),
    "energies": QuantityCode(energies),
    "center_of_mass": QuantityCode(center_of_mass, needs_mass=True),
    "inverse_dynamics_derivatives": QuantityCode(inverse_dynamics_derivatives, "derivatives"),
    "forward_dynamics_derivatives": QuantityCode(forward_dynamics_derivatives, "derivatives"),
    "regressor": QuantityCode(regressor, "derivatives"),
    "centroidal_momentum": QuantityCode(whole_body.centroidal_momentum, "control", needs_mass=True),
    "frame_motions": QuantityCode(whole_body.frame_motions, "control"),
    "joint_space_inertia_inverse": QuantityCode(whole_body.inertia_inverse, "control"),
    "coriolis_matrix": QuantityCode(whole_body.coriolis_matrix, "control"),
    "contact_dynamics": QuantityCode(whole_body.contact_dynamics, "control"),
}
