"""The parts of a library of generated code, whatever the language."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Literal, NamedTuple

from kindsl.mechanics.dynamics.generation.emitters.numbers import evaluate
from kindsl.mechanics.dynamics.generation.emitters.straight_line import setup_nodes
from kindsl.mechanics.dynamics.generation.function import Function, Inputs, inputs_of
from kindsl.mechanics.dynamics.generation.functions import QUANTITIES
from kindsl.mechanics.dynamics.generation.masses import total_mass
from kindsl.mechanics.dynamics.generation.relative_frames import (
    FramePair,
    relative_jacobians,
    relative_poses,
)
from kindsl.mechanics.dynamics.generation.robot import Robot
from kindsl.mechanics.dynamics.generation.terms import Scalar, Term, needed, operand_nodes
from kindsl.mechanics.dynamics.quantities import SingularInertiaError
from kindsl.products.codegen.layouts import LAYOUTS
from kindsl.products.codegen.names_in_code import identifiers, prefix_of

Real = Literal["double", "float"]


class GenerationError(ValueError):
    """Code cannot be generated for a document as asked."""


@dataclass(frozen=True, slots=True)
class Options:
    """The options of a generation.

    Attributes:
        language: In which language, by the name of its module.
        quantities: Which, by the names of `QUANTITIES`.
        real: The type of all numbers, in C.
        is_single_header: Whether C is one file.
        parameters: `unbound`, `all`, or names separated by commas: what stays an input.
        prefix: Beginning of all names.
        layout: Whose folders RobCoGen's classes are laid out for.
        has_runtime: Whether the headers that all robots share are written too.
        frames: The links and frames to restrict poses and Jacobians to; all if empty.
    """

    language: str
    quantities: tuple[str, ...]
    real: Real
    is_single_header: bool
    parameters: str
    prefix: str
    layout: str = LAYOUTS[0]
    has_runtime: bool = False
    frames: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Stamp:
    """The origin of generated code.

    Attributes:
        generator: Name and version of this program.
        document: The document's file name.
        sha256: Of the document's bytes.
        options: As they could be typed in the document's folder.
    """

    generator: str
    document: str
    sha256: str
    options: str


class Wanted(NamedTuple):
    """Pairs of frames, base and target."""

    transforms: tuple[FramePair, ...]
    jacobians: tuple[FramePair, ...]


@dataclass(frozen=True)
class Library:
    """Functions of one robot, named.

    Attributes:
        options: Options of the command.
        stamp: Where it comes from.
        robot_name: As in the document.
        robot: The robot that the functions are recorded for.
        functions: By quantity.
        defaults: The values of the parameters that stay inputs, None where unbound.
        inputs: All that functions may depend on.
        wanted: Pairs of frames that are asked for besides.
        parameter_kinds: The classes of values that each parameter stands in.
        version: The robot's.
    """

    options: Options
    stamp: Stamp
    robot_name: str
    robot: Robot
    functions: Mapping[str, tuple[Function, ...]]
    defaults: Mapping[str, float | None]
    inputs: Inputs
    wanted: Wanted = Wanted((), ())  # noqa: RUF009
    parameter_kinds: Mapping[str, frozenset[str]] = field(default_factory=dict)
    version: str = "1.0.0"

    @property
    def external(self) -> list[Scalar]:
        """The wrenches on all bodies, one after the other."""
        return [component for wrench in self.inputs.external for component in wrench]

    @property
    def prefix(self) -> str:
        """The prefix of all names."""
        return self.options.prefix

    @property
    def all_functions(self) -> tuple[Function, ...]:
        """The functions of all quantities, in order."""
        return tuple(function for group in self.functions.values() for function in group)

    @cached_property
    def function_names(self) -> dict[str, str]:
        """The names of functions in code, without prefix; `_batch` is the end of others."""
        names = identifiers(function.name for function in self.all_functions)
        return {k: f"{name}_" if name.endswith("_batch") else name for k, name in names.items()}

    @cached_property
    def body_names(self) -> dict[str, str]:
        """The names of bodies in code, base first."""
        return identifiers((self.robot.base_name, *self.robot.link_names))

    @cached_property
    def joint_names(self) -> dict[str, str]:
        """The names of joints in code."""
        return identifiers(self.robot.joint_names)

    @cached_property
    def pose_names(self) -> dict[str, str]:
        """The names of links and frames in code."""
        return identifiers(target.name for target in self.robot.targets)

    @cached_property
    def parameter_names(self) -> dict[str, str]:
        """The names of parameters in code."""
        return identifiers(self.robot.parameters)

    @cached_property
    def renamed(self) -> dict[str, str]:
        """The names that are others in code; the robot's is in lower case there."""
        groups = (self.joint_names, self.body_names, self.pose_names, self.parameter_names)
        found = {name: safe for group in groups for name, safe in group.items() if name != safe}
        if self.prefix == prefix_of(self.robot_name, None) != self.robot_name.lower():
            found[self.robot_name] = self.prefix
        return found

    @property
    def is_bound(self) -> bool:
        """True if every parameter that stays an input has a default."""
        return all(value is not None for value in self.defaults.values())

    @cached_property
    def setup(self) -> list[Term]:
        """The model's constants: values that depend on parameters only and that others use."""
        graph = self.robot.graph
        values = [entry for function in self.all_functions for entry in _entries(function)]
        order = needed(graph, values)
        parameters = [p.index for p in self.robot.parameters.values()]
        fixed = setup_nodes(graph, parameters, order)
        crossing = {v.index for v in values if isinstance(v, Term)} & fixed
        for node in order:
            if node not in fixed:
                crossing.update(fixed.intersection(operand_nodes(graph, node)))
        return [Term(graph, node) for node in sorted(crossing)]

    @cached_property
    def setup_values(self) -> list[float]:
        """The model's constants for the defaults; all parameters must be bound."""
        inputs = {p.index: self.defaults[name] or 0.0 for name, p in self.robot.parameters.items()}
        return evaluate(self.robot.graph, inputs, self.setup)


def library_of(
    robot: Robot,
    robot_name: str,
    defaults: Mapping[str, float | None],
    options: Options,
    stamp: Stamp,
    wanted: Wanted | None = None,
) -> Library:
    """Record all functions that are asked for.

    Args:
        robot: The robot.
        robot_name: As in the document.
        defaults: The values of the parameters that stay inputs.
        options: Choice of the functions.
        stamp: Where it comes from.
        wanted: Pairs of frames whose poses and Jacobians are asked for besides.

    Raises:
        GenerationError: A quantity is not defined for this robot.
    """
    inputs = inputs_of(robot)
    functions = {}
    for name in options.quantities:
        if group := tuple(_recorded(robot, inputs, name)):
            functions[name] = group
    if wanted is not None:
        pairs = {
            "transforms": relative_poses(robot, inputs, wanted.transforms),
            "relative_jacobians": relative_jacobians(robot, inputs, wanted.jacobians),
        }
        functions |= {name: tuple(group) for name, group in pairs.items() if group}
    if not functions:
        raise GenerationError("none of the quantities exists for a fixed base")
    listed = wanted or Wanted((), ())
    return Library(options, stamp, robot_name, robot, functions, defaults, inputs, listed)


def _recorded(robot: Robot, inputs: Inputs, name: str) -> list[Function]:
    quantity = QUANTITIES[name]
    is_massless = total_mass(robot) == 0.0
    if quantity.needs_mass and is_massless:
        raise GenerationError(
            f"'{name}' is not defined: the total mass is zero; "
            "use --quantities to choose others, such as poses,jacobians"
        )
    try:
        functions = quantity.build(robot, inputs)
    except (SingularInertiaError, ZeroDivisionError):
        raise GenerationError(
            f"'{name}' is not defined: the inertia matrix is "
            "singular; use --quantities to choose others, such as poses,jacobians"
        ) from None
    graph = robot.graph
    for function in functions:
        entries = _entries(function)
        operands = (x for node in needed(graph, entries) for x in graph.nodes[node][1:])
        if not all(math.isfinite(x) for x in (*entries, *operands) if isinstance(x, float)):
            raise GenerationError(f"'{name}': the values of the document are too large")
    return [_with_safe_results(function) for function in functions]


def _entries(function: Function) -> list[Scalar]:
    """Return all that a function gives, without and with external forces."""
    results = (*function.results, *(function.loaded or ()))
    return [entry for result in results for entry in result.entries]


def _with_safe_results(function: Function) -> Function:
    names = identifiers(result.name for result in function.results)
    results = tuple(r._replace(name=names[r.name]) for r in function.results)
    return function._replace(results=results)
