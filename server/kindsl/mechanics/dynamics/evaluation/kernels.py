"""The functions compiled for a mechanism, with the arguments of `Mechanics`' methods."""

import inspect
from collections.abc import Callable, Iterable
from typing import Any

from kindsl.mechanics.dynamics.evaluation.compiling import compiled_module
from kindsl.mechanics.dynamics.evaluation.mechanics import Mechanics
from kindsl.mechanics.dynamics.evaluation.results import FreeMotion, FreeMotionTorque
from kindsl.mechanics.dynamics.forward_dynamics_derivatives import ForwardDynamicsDerivatives
from kindsl.mechanics.dynamics.generation.emitters.extension import (
    MODULE,
    Kernel,
    KernelArgument,
    extension_source,
)
from kindsl.mechanics.dynamics.generation.emitters.lanes import is_worth_lanes
from kindsl.mechanics.dynamics.generation.function import (
    Function,
    Result,
    argument,
    homogeneous,
    inputs_of,
)
from kindsl.mechanics.dynamics.generation.functions import QUANTITIES
from kindsl.mechanics.dynamics.generation.loops import functions_of
from kindsl.mechanics.dynamics.generation.masses import total_mass
from kindsl.mechanics.dynamics.generation.robot import Robot
from kindsl.mechanics.dynamics.inverse_dynamics_derivatives import InverseDynamicsDerivatives
from kindsl.mechanics.dynamics.quantities import (
    ACCELERATING,
    KEYWORDS,
    STANDARD_GRAVITY,
    SingularInertiaError,
)

Method = Callable[..., Any]

# The quantities that are compiled together: all but the first when they are asked for.
GROUPS = {
    "plain": ("poses", "inverse_dynamics", "forward_dynamics"),
    "bias": ("gravity_torque", "bias_torque"),
    "masses": ("joint_space_inertia", "energies", "center_of_mass"),
    "jacobians": ("jacobians",),
    "loads": ("inverse_dynamics", "inverse_dynamics_actuated", "forward_dynamics"),
    "derivatives": ("inverse_dynamics_derivatives", "forward_dynamics_derivatives", "regressor"),
    "control": (
        "centroidal_momentum", "joint_space_inertia_inverse", "coriolis_matrix", "contact_dynamics",
    ),
    "frame_motions": ("frame_motions",),
}  # fmt: skip
# Those whose batches may be computed in lanes.
WIDE_GROUPS = ("plain", "bias", "masses", "control")
RESULT_CLASSES = {
    "inverse_dynamics": FreeMotionTorque,
    "forward_dynamics": FreeMotion,
    "inverse_dynamics_derivatives": InverseDynamicsDerivatives,
    "forward_dynamics_derivatives": ForwardDynamicsDerivatives,
}
# What None stands for, of arguments in code.
DEFAULTS = {"v0": "ZEROS", "a0": "ZEROS", "g": "GRAVITY"}
# The motion of the base that methods take, also where it is fixed: then it has to be None.
MOVING_BASE = {
    "inverse_dynamics": ("v0",), "forward_dynamics": ("v0",), "bias_torque": ("v0",),
    "kinetic_energy": ("v0",), "inverse_dynamics_derivatives": ("v0", "a0"),
    "forward_dynamics_derivatives": ("v0",), "regressor": ("v0", "a0"),
    "centroidal_momentum_drift": ("v0",), "coriolis_matrix": ("v0",), "contact_dynamics": ("v0",),
    "velocity": ("v0",), "acceleration": ("v0", "a0"), "acceleration_drift": ("v0",),
}  # fmt: skip
# Of each frame, a kernel of each kind, whose name ends in the frame's number.
OF_FRAMES = {
    "jacobians": ("jacobian", "jacobian_in_base"),
    "frame_motions": ("velocity", "acceleration", "acceleration_drift"),
}


def _nothing(*_: object, **__: object) -> None:
    """Return nothing: Python has to look at the arguments."""


class Extension:
    """The compiled functions of a group.

    Attributes:
        kernels: What they compute, by name.
    """

    def __init__(self, robot: Robot, group: str) -> None:
        kernels = kernels_of(robot, group)
        self.kernels = {kernel.name: kernel for kernel in kernels}
        source = extension_source(robot.graph, robot.tree, kernels, STANDARD_GRAVITY)
        # The function, not its module: a file that is loaded again fills one module of this name
        # with whatever robot's functions were loaded last.
        self._bind: Method = compiled_module(MODULE, source).bind

    def bind(self, name: str, general: Method = _nothing, *, batches: bool = True) -> Method:
        """Return a compiled function that calls `general` for what it does not take."""
        bound: Method = self._bind(name, general, RESULT_CLASSES.get(name), batches)
        return bound


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
            functions = functions_of(robot, inputs, name, has_loops=True)
        except ZeroDivisionError:
            raise SingularInertiaError from None
        except OverflowError:
            continue
        if kinds := OF_FRAMES.get(name):
            functions = [
                function._replace(name=f"{kinds[place % len(kinds)]}_{place // len(kinds)}")
                for place, function in enumerate(functions)
                if kinds[place % len(kinds)] != "jacobian_in_base"
            ]
        if group == "loads":
            load = argument("external_forces", [x for wrench in inputs.external for x in wrench])
            functions = [
                f._replace(
                    name=f"{f.name}_loaded", results=f.loaded, arguments=(*f.arguments, load)
                )
                for f in functions
                if f.loaded is not None
            ]
        kernels += [
            _kernel(function, robot, may_be_wide=group in WIDE_GROUPS) for function in functions
        ]
    return kernels


def _kernel(function: Function, robot: Robot, *, may_be_wide: bool) -> Kernel:
    name = function.name
    results = [*function.results]
    if name == "poses":
        entries = homogeneous(function.results[0].entries)
        results = [Result("T", (len(robot.targets), 4, 4), entries)]
    elif name in ("kinetic_energy", "potential_energy"):
        results = [result._replace(shape=()) for result in results]
    solved = ACCELERATING.get(name.removesuffix("_loaded"))
    accelerates = solved == "all" or (solved == "base" and robot.tree.is_floating)
    entries = [entry for result in results for entry in result.entries]
    is_wide = may_be_wide and not function.is_loop and is_worth_lanes(robot.graph, entries)
    given = {argument.name: argument.components for argument in function.arguments}
    names = _names(name, given)
    arguments = [
        KernelArgument(KEYWORDS.get(name, name), given.get(name, ()), DEFAULTS.get(name))
        for name in names
    ]
    in_code = ["fext" if name == "external_forces" else name for name in names if name in given]
    loop = (function, in_code) if function.is_loop else None
    return Kernel(name, arguments, results, accelerates, is_wide, documentation(name), loop)


def _names(name: str, given: Iterable[str]) -> list[str]:
    """Return the names of a kernel's arguments, of a fixed base's motion too."""
    kind, _, number = name.rpartition("_")
    base = MOVING_BASE.get(kind if number.isdigit() else name, ())
    joints = [n for n in given if n not in KEYWORDS and n != "external_forces"]
    others = [n for n in given if n not in (*joints, *base)]
    return [*joints, *base, *others]


def signature_with_out(method: Method) -> inspect.Signature:
    """Return a method's signature with a further argument `out`, and without annotations."""
    signature = inspect.signature(method)
    parameters = [
        p.replace(annotation=inspect.Parameter.empty) for p in signature.parameters.values()
    ]
    out = inspect.Parameter("out", inspect.Parameter.KEYWORD_ONLY, default=None)
    return inspect.Signature([*parameters, out])


def documentation(name: str) -> str | None:
    """Return what `help` shows of a compiled method, as CPython reads it; None for others."""
    method = getattr(Mechanics, name, None)
    if method is None:
        return None
    signature = str(signature_with_out(method)).replace("(self", "($self", 1)
    return f"{name}{signature}\n--\n\n{inspect.getdoc(method)}"
