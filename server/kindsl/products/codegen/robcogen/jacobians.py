"""`jacobians.h` and `jacobians.impl.h`: geometric Jacobians."""

from itertools import chain

from kindsl.mechanics.dynamics.generation.relative_frames import relative_jacobians
from kindsl.mechanics.dynamics.generation.terms import Scalar
from kindsl.products.codegen.filling import template
from kindsl.products.codegen.robcogen.parameters import (
    parameter_array,
    parameters_of_class,
    setters,
)
from kindsl.products.codegen.robcogen.robot import GeneratedRobot
from kindsl.products.codegen.robcogen.wanted_names import NamedPair, jacobian_pairs, joints_of

_TEXT = template("robcogen/jacobians.h")
_TYPE = template("robcogen/jacobian.h")


def jacobians(robot: GeneratedRobot) -> dict[str, str]:
    """Return both headers by their names."""
    pairs = jacobian_pairs(robot)
    columns = {pair.name: jacobian_columns(robot, pair) for pair in pairs}
    functions = [text for n, c in columns.items() for text in robot.matrix_kernels(n, c)]
    dependent = [n for n, c in columns.items() if robot.depends_on_parameters(chain(*c))]
    construction, values = setters(robot, "Jacobians", dependent)
    body = robot.filled(
        _TEXT,
        TYPES="\n".join(_type(robot, n, len(c), n in dependent) for n, c in columns.items()),
        CONSTRUCTION=construction,
        MEMBERS="".join(f"    Type_{name} {name};\n" for name in columns),
        VALUES=values,
    )
    includes = [
        "<iit/rbd/rbd.h>", "<iit/rbd/TransformsBase.h>", "<iit/rbd/traits/DoubleTrait.h>",
        '"declarations.h"', '"kinematics_parameters.h"',
    ]  # fmt: skip
    return robot.headers("jacobians", includes, body, functions)


def jacobian_columns(robot: GeneratedRobot, pair: NamedPair) -> list[list[Scalar]]:
    """Return the columns of a pair's Jacobian, one a joint between both."""
    library = robot.library
    (function,) = relative_jacobians(library.robot, library.inputs, [(pair.base, pair.target)])
    entries, n = function.results[0].entries, len(joints_of(robot, pair))
    return [entries[column::n] for column in range(n)]


def _type(robot: GeneratedRobot, name: str, columns: int, has_parameters: bool) -> str:
    return robot.filled(
        _TYPE,
        NAME=name,
        COLUMNS=columns,
        PARAMETERS=parameter_array(robot, "            ") if has_parameters else "",
        P=("p, " if has_parameters else "nullptr, ") if robot.has_parameters else "",
        MEMORY=parameters_of_class(robot) if has_parameters else "",
    )
