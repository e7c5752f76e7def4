"""The functions compiled for a mechanism, with the arguments of `Mechanics`' methods."""

from collections.abc import Sequence

from kindsl.mechanics.dynamics.evaluation.results import FreeMotion, FreeMotionTorque
from kindsl.mechanics.dynamics.forward_dynamics_derivatives import ForwardDynamicsDerivatives
from kindsl.mechanics.dynamics.generation.emitters.extension import (
    Kernel,
    KernelArgument,
    KernelResult,
)
from kindsl.mechanics.dynamics.generation.function import Function, inputs_of
from kindsl.mechanics.dynamics.generation.functions import QUANTITIES
from kindsl.mechanics.dynamics.generation.masses import total_mass
from kindsl.mechanics.dynamics.generation.robot import Robot
from kindsl.mechanics.dynamics.generation.terms import Scalar
from kindsl.mechanics.dynamics.inverse_dynamics_derivatives import InverseDynamicsDerivatives
from kindsl.mechanics.dynamics.quantities import SingularInertiaError

# The quantities that are compiled together.
GROUPS = {
    "plain": (
        "poses", "jacobians", "joint_space_inertia", "inverse_dynamics", "forward_dynamics",
        "gravity_torque", "bias_torque", "energies", "center_of_mass",
    ),
    "derivatives": ("inverse_dynamics_derivatives", "forward_dynamics_derivatives", "regressor"),
    "control": (
        "centroidal_momentum", "joint_space_inertia_inverse", "coriolis_matrix", "contact_dynamics",
    ),
    "frame_motions": ("frame_motions",),
}  # fmt: skip
RESULT_CLASSES = {
    "inverse_dynamics": FreeMotionTorque,
    "forward_dynamics": FreeMotion,
    "inverse_dynamics_derivatives": InverseDynamicsDerivatives,
    "forward_dynamics_derivatives": ForwardDynamicsDerivatives,
}
# Keywords of methods, by the names of arguments in code, and what None stands for.
KEYWORDS = {"v0": "base_velocity", "a0": "base_acceleration", "g": "gravity"}
DEFAULTS = {"v0": "ZEROS", "a0": "ZEROS", "g": "GRAVITY"}
MOVING_BASE = {
    "inverse_dynamics": ("v0",), "forward_dynamics": ("v0",), "bias_torque": ("v0",),
    "kinetic_energy": ("v0",), "inverse_dynamics_derivatives": ("v0", "a0"),
    "forward_dynamics_derivatives": ("v0",), "regressor": ("v0", "a0"),
    "centroidal_momentum_drift": ("v0",), "coriolis_matrix": ("v0",), "contact_dynamics": ("v0",),
    "velocity": ("v0",), "acceleration": ("v0", "a0"), "acceleration_drift": ("v0",),
}  # fmt: skip
ACCELERATING = (
    "inverse_dynamics", "forward_dynamics", "forward_dynamics_derivatives",
    "joint_space_inertia_inverse", "contact_dynamics",
)  # fmt: skip
# Functions of one frame each: what follows their names is a number.
NUMBERED = ("jacobian", "velocity", "acceleration", "acceleration_drift")


def kernels_of(robot: Robot, group: str) -> list[Kernel]:
    """Return the kernels of a mechanism, of one group of quantities.

    Raises:
        SingularInertiaError: If nothing resists a motion in any configuration.
    """
    inputs = inputs_of(robot)
    is_massless = total_mass(robot) == 0.0
    kernels = []
    for name in GROUPS[group]:
        quantity = QUANTITIES[name]
        if quantity.needs_mass and is_massless:
            continue
        try:
            functions = quantity.build(robot, inputs)
        except ZeroDivisionError:
            raise SingularInertiaError from None
        if name == "jacobians":
            functions = [
                function._replace(name=f"jacobian_{number}")
                for number, function in enumerate(functions[::2])
            ]
        elif name == "frame_motions":
            kinds = NUMBERED[1:]
            functions = [
                function._replace(name=f"{kinds[place % len(kinds)]}_{place // len(kinds)}")
                for place, function in enumerate(functions)
            ]
        is_wide = group in ("plain", "control")
        kernels += [_kernel(function, robot, is_wide=is_wide) for function in functions]
    return kernels


def _kernel(function: Function, robot: Robot, *, is_wide: bool) -> Kernel:
    name = function.name
    results = [KernelResult(r.shape, r.entries) for r in function.results]
    if name == "poses":
        results = [_homogeneous(function.results[0].entries, len(robot.targets))]
    elif name in ("kinetic_energy", "potential_energy"):
        results = [KernelResult((), function.results[0].entries)]
    # A jacobian's body may not depend on joints at all; lanes would be empty then.
    wide = is_wide and not name.startswith("jacobian_")
    accelerates = name in ACCELERATING and (robot.tree.is_floating or name != "inverse_dynamics")
    return Kernel(name, _arguments(function), results, accelerates, wide)


def _arguments(function: Function) -> Sequence[KernelArgument]:
    given = {argument.name: argument.components for argument in function.arguments}
    joints = [n for n in given if n not in KEYWORDS]
    kind, _, number = function.name.rpartition("_")
    base = MOVING_BASE.get(kind if number.isdigit() and kind in NUMBERED else function.name, ())
    gravity = ["g"] if "g" in given else []
    return [
        KernelArgument(
            KEYWORDS.get(name, name),
            len(given.get(name, ())),
            list(given.get(name, ())),
            DEFAULTS.get(name),
        )
        for name in (*joints, *base, *gravity)
    ]


def _homogeneous(entries: Sequence[Scalar], n_poses: int) -> KernelResult:
    """Return whole 4x4 matrices of poses without their last row."""
    whole: list[Scalar] = []
    for pose in range(n_poses):
        whole += [*entries[12 * pose : 12 * pose + 12], 0.0, 0.0, 0.0, 1.0]
    return KernelResult((n_poses, 4, 4), whole)
