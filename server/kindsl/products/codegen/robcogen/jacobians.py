"""The geometric Jacobians, and the functions that compute them."""

from collections.abc import Iterable
from itertools import chain

from kindsl.mechanics.dynamics.generation.relative_frames import relative_jacobians
from kindsl.mechanics.dynamics.generation.terms import Scalar
from kindsl.products.codegen.robcogen.robot import GeneratedRobot, MatrixMember
from kindsl.products.codegen.robcogen.wanted_names import NamedPair, joints_of


def jacobians(
    robot: GeneratedRobot, pairs: Iterable[NamedPair]
) -> tuple[list[MatrixMember], list[str]]:
    """Return the Jacobians of pairs of frames, and the functions that compute them."""
    columns = {pair.name: jacobian_columns(robot, pair) for pair in pairs}
    functions = [text for n, c in columns.items() for text in robot.matrix_kernels(n, c)]
    matrices = [
        MatrixMember(name, len(c), robot.depends_on_parameters(chain(*c)))
        for name, c in columns.items()
    ]
    return matrices, functions


def jacobian_columns(robot: GeneratedRobot, pair: NamedPair) -> list[list[Scalar]]:
    """Return the columns of a pair's Jacobian, one a joint between both."""
    library = robot.library
    (function,) = relative_jacobians(library.robot, library.inputs, [(pair.base, pair.target)])
    entries, n = function.results[0].entries, len(joints_of(robot, pair))
    return [entries[column::n] for column in range(n)]
