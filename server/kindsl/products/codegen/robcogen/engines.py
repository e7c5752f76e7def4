"""The class around the code of inverse dynamics and of forward dynamics."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import NamedTuple, TypeAlias

from kindsl.mechanics.dynamics.generation.terms import Scalar
from kindsl.mechanics.dynamics.generation.vectors import Vector
from kindsl.products.codegen.filling import template
from kindsl.products.codegen.robcogen.robot import GeneratedRobot

Arguments: TypeAlias = Mapping[str, Sequence[Scalar]]

_INCLUDES = (
    "<Eigen/Dense>", "<iit/rbd/rbd.h>", "<iit/rbd/InertiaMatrix.h>", "<iit/rbd/utils.h>",
    "<iit/rbd/robcogen_commons.h>", "<iit/rbd/traits/DoubleTrait.h>", '"declarations.h"',
    '"inertia_properties.h"', '"transforms.h"', '"link_data_map.h"',
)  # fmt: skip

_CLASS = template("robcogen/engine.h")


class Engine(NamedTuple):
    """A class that computes dynamics.

    Attributes:
        name: Its name.
        about: What it computes, in a sentence.
        calls: Its constructor and the functions that programs call.
        rest: What follows them, private at its end.
    """

    name: str
    about: str
    calls: str
    rest: str


def engine_headers(
    robot: GeneratedRobot, file: str, engine: Engine, kernels: Iterable[str]
) -> dict[str, str]:
    """Return the header of a class, and that of the functions that it calls, by their names."""
    body = robot.filled(
        _CLASS,
        CLASS=engine.name,
        ABOUT=engine.about,
        CALLS=engine.calls,
        UPDATES="".join(f"        xm->{robot.across(i)}(q);\n" for i in robot.tree.links()),
        REST=engine.rest,
    )
    return robot.headers(file, _INCLUDES, body, kernels)


def parameters(robot: GeneratedRobot, transforms: str = "xm->", indent: str = "        ") -> str:
    """Return the statements that list all parameters."""
    if not robot.has_parameters:
        return ""
    return (
        f"{indent}Scalar p[{len(robot.library.robot.parameters)}] = {{}};\n"
        f"{indent}{transforms}parameters(p);\n{indent}inertiaProps->parameters(p);\n"
    )


def kernels_under_loads(
    robot: GeneratedRobot,
    name: str,
    takes: Arguments,
    results: Callable[[Sequence[Vector]], Arguments],
) -> list[str]:
    """Return a function without forces on links, and with them: its name with `_loaded`.

    That of a large robot is one for both, which compilers take half the time for: forces add little
    there.

    Args:
        robot: The robot.
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
    declared += [f"{number}* {n}" for n in loaded]
    handed_on = ", ".join((*first, *takes, "none", *loaded))
    size = len(given["fext"])
    without = (
        f"template <class TRAIT>\ninline void {name}({', '.join(declared)})\n{{\n"
        f"    {number} none[{size}];\n    for (int i = 0; i < {size}; i++) {{\n"
        f"        none[i] = {number}(0);\n    }}\n    {name}_loaded<TRAIT>({handed_on});\n}}\n"
    )
    return [with_loads, without]


def at_rest(robot: GeneratedRobot) -> Vector:
    """Return joint velocities of zero."""
    return [0.0] * robot.n_joints
