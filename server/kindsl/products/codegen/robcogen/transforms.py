"""The coordinate transforms of motions, forces and points, and the functions that compute them."""

from collections.abc import Iterable
from itertools import chain
from typing import NamedTuple

from kindsl.mechanics.dynamics.generation.vectors import Matrix, Vector, multiply, transpose
from kindsl.products.codegen.robcogen.long_transforms import is_long, long_kernels
from kindsl.products.codegen.robcogen.robot import GeneratedRobot, MatrixMember
from kindsl.products.codegen.robcogen.wanted_names import NamedPair


class Kind(NamedTuple):
    """A kind of transforms.

    Attributes:
        letter: First of its functions' names.
        name: First of its class's name.
        what: What its class holds, in a sentence.
    """

    letter: str
    name: str
    what: str


KINDS = (
    Kind("m", "Motion", "The 6x6 transforms of motion vectors."),
    Kind("f", "Force", "The 6x6 transforms of force vectors."),
    Kind("h", "Homogeneous", "The 4x4 transforms of points."),
)


def transforms(
    robot: GeneratedRobot, pairs: Iterable[NamedPair]
) -> tuple[list[MatrixMember], list[str]]:
    """Return the transforms of pairs of frames, and the functions that compute them."""
    functions, products, matrices = [robot.rendered("transform_helpers.h")], [], []
    for pair in pairs:
        if is_long(robot, pair):
            products += long_kernels(robot, pair)
            matrices.append(MatrixMember(pair.name, 0, bool(robot.kinematic_groups)))
            continue
        E, p = robot.pose_in(pair.base, pair.target)
        for kind in KINDS:
            columns = transpose(matrix_of(kind.letter, E, p))
            functions += robot.matrix_kernels(f"{kind.letter}_{pair.name}", columns)
        matrices.append(MatrixMember(pair.name, 0, robot.depends_on_parameters(chain(*E, p))))
    return matrices, [*functions, *products, robot.rendered("across.h")]


def matrix_of(letter: str, E: Matrix, p: Vector) -> Matrix:
    """Return a transform of motions, forces or points (m, f, h) from rotation and position."""
    if letter == "h":
        return [[*E[row], p[row]] for row in range(3)] + [[0.0, 0.0, 0.0, 1.0]]
    crossed: Matrix = [[0.0, 0.0 - p[2], p[1]], [p[2], 0.0, 0.0 - p[0]], [0.0 - p[1], p[0], 0.0]]
    coupling, nothing = multiply(crossed, E), [0.0] * 3
    if letter == "m":
        below = [[*c, *e] for c, e in zip(coupling, E, strict=True)]
        return [[*e, *nothing] for e in E] + below
    return [[*e, *c] for e, c in zip(E, coupling, strict=True)] + [[*nothing, *e] for e in E]
