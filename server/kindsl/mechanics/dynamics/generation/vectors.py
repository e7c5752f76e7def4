"""3-D vectors and matrices as lists of scalars, for algorithms that are traced."""

from collections.abc import Callable
from typing import TypeAlias

from kindsl.mechanics.dynamics.generation.terms import Scalar

Vector: TypeAlias = list[Scalar]
Matrix: TypeAlias = list[list[Scalar]]

ZERO: Vector = [0.0, 0.0, 0.0]
EYE: Matrix = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]


def add(a: Vector, b: Vector) -> Vector:
    """Return `a + b`."""
    return [x + y for x, y in zip(a, b, strict=True)]


def subtract(a: Vector, b: Vector) -> Vector:
    """Return `a - b`."""
    return [x - y for x, y in zip(a, b, strict=True)]


def scale(factor: Scalar, v: Vector) -> Vector:
    """Return `factor * v`."""
    return [factor * x for x in v]


def dot(a: Vector, b: Vector) -> Scalar:
    """Return `a . b`."""
    total: Scalar = 0.0
    for x, y in zip(a, b, strict=True):
        total = total + x * y
    return total


def cross(a: Vector, b: Vector) -> Vector:
    """Return `a x b`."""
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def transform(M: Matrix, v: Vector) -> Vector:
    """Return `M @ v`."""
    return [dot(row, v) for row in M]


def transpose(M: Matrix) -> Matrix:
    """Return `M.T`."""
    return [list(column) for column in zip(*M, strict=True)]


def multiply(A: Matrix, B: Matrix) -> Matrix:
    """Return `A @ B`."""
    columns = transpose(B)
    return [[dot(row, column) for column in columns] for row in A]


def add_matrices(A: Matrix, B: Matrix) -> Matrix:
    """Return `A + B`."""
    return [add(a, b) for a, b in zip(A, B, strict=True)]


def symmetric(entry: Callable[[int, int], Scalar]) -> Matrix:
    """Return a symmetric 3x3 matrix, each pair of entries computed once."""
    M: Matrix = [[0.0] * 3 for _ in range(3)]
    for row in range(3):
        for column in range(row, 3):
            M[row][column] = M[column][row] = entry(row, column)
    return M


def rotate_symmetric(R: Matrix, M: Matrix) -> Matrix:
    """Return `R @ M @ R.T` of a symmetric matrix."""
    half = multiply(R, M)
    return symmetric(lambda i, j: dot(half[i], R[j]))
