"""Transforms across many joints: the product of those across each, to keep headers short."""

from collections.abc import Iterator

from kindsl.mechanics.dynamics.generation.jacobians import support
from kindsl.mechanics.dynamics.generation.robot import PlacedFrame
from kindsl.mechanics.dynamics.generation.terms import Scalar
from kindsl.mechanics.dynamics.generation.vectors import (
    EYE,
    ZERO,
    Matrix,
    Vector,
    transform,
    transpose,
)
from kindsl.products.codegen.robcogen.robot import GeneratedRobot
from kindsl.products.codegen.robcogen.wanted_names import NamedPair

# One function of all joints is faster up to here, but its text is long: large robots have many.
MOST_JOINTS = 7
MOST_JOINTS_OF_LARGE = 2


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
