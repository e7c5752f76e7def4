"""Coordinate transforms and Jacobians, and the functions that compute them."""

from collections.abc import Iterable, Iterator
from itertools import chain
from typing import NamedTuple

from kindsl.mechanics.dynamics.generation.jacobians import support
from kindsl.mechanics.dynamics.generation.relative_frames import relative_jacobians
from kindsl.mechanics.dynamics.generation.robot import PlacedFrame
from kindsl.mechanics.dynamics.generation.terms import Scalar
from kindsl.mechanics.dynamics.generation.vectors import (
    EYE,
    ZERO,
    Matrix,
    Vector,
    multiply,
    transform,
    transpose,
)
from kindsl.products.codegen.robcogen.robot import GeneratedRobot, MatrixMember
from kindsl.products.codegen.robcogen.wanted_names import NamedPair, joints_of

# One function of all joints is faster up to here, but its text is long: large robots have many.
MOST_JOINTS = 7
MOST_JOINTS_OF_LARGE = 2


class Kind(NamedTuple):
    """A kind of transforms.

    Attributes:
        letter: Of the matrices in short.
        name: First of its class's name.
        what: What its class holds, in a sentence.
        coupling: Where the block of spatial ones is that couples turns and shifts, as an argument.
    """

    letter: str
    name: str
    what: str
    coupling: str = ""

    @property
    def function(self) -> str:
        """First of its functions' names: spatial ones have the same entries."""
        return "s" if self.coupling else "h"


KINDS = (
    Kind("m", "Motion", "The 6x6 transforms of motion vectors.", ", this->data() + 3"),
    Kind("f", "Force", "The 6x6 transforms of force vectors.", ", this->data() + 18"),
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
        columns, n = transpose(matrix_of("m", E, p)), 3
        coupling = [x for column in columns[:n] for x in [*column[n:], *[None] * n]]
        halves = [[*c[:n], *[None] * n] for c in columns[:n]] + columns[n:]
        spatial = {"X": [x for half in halves for x in half], "C": coupling}
        functions += robot.entry_kernels(f"s_{pair.name}", spatial)
        functions += robot.matrix_kernels(f"h_{pair.name}", _columns(E, p))
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


def is_long(robot: GeneratedRobot, pair: NamedPair) -> bool:
    """Return whether a pair's frames are too many joints apart for one function."""
    most = MOST_JOINTS if not robot.is_large else MOST_JOINTS_OF_LARGE
    return len([*_across(robot, pair)]) > most


def long_kernels(robot: GeneratedRobot, pair: NamedPair) -> list[str]:
    """Return the functions of a pair's three matrices."""
    functions, steps = [], [*_across(robot, pair)]
    for end, (R, r) in (("base", _inverse(pair.base)), ("target", (pair.target.R, pair.target.r))):
        if (R, r) != (EYE, ZERO):
            name = f"{pair.name}_{end}"
            functions += robot.matrix_kernels(f"h_{name}", _columns(R, r))
            steps = [name, *steps] if end == "base" else [*steps, name]
    return [*functions, robot.rendered("transform_product.h", pair=pair, steps=steps)]


def _across(robot: GeneratedRobot, pair: NamedPair) -> Iterator[str]:
    """Yield the transforms across joints from a pair's base to its target."""
    back, forth = (support(robot.tree, frame.body) for frame in (pair.base, pair.target))
    shared = len([None for a, b in zip(back, forth, strict=False) if a == b])
    for link in reversed(back[shared:]):
        yield robot.across(link)
    for link in forth[shared:]:
        yield robot.back_across(link)


def _inverse(frame: PlacedFrame) -> tuple[Matrix, Vector]:
    E = transpose(frame.R)
    return E, [0.0 - x if x else 0.0 for x in transform(E, frame.r)]


def _columns(R: Matrix, r: Vector) -> list[list[Scalar]]:
    return [*([*column, 0.0] for column in transpose(R)), [*r, 1.0]]


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
