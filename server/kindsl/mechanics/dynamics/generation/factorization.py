"""Linear systems with a symmetric matrix and the zeros that a tree's branches leave in it."""

from typing import NamedTuple

from kindsl.mechanics.dynamics.generation.terms import Scalar
from kindsl.mechanics.dynamics.generation.vectors import Matrix, Vector
from kindsl.mechanics.dynamics.quantities import SingularInertiaError


class Factorization(NamedTuple):
    """A symmetric matrix as `L^T D L`, with `L` unit lower triangular.

    Attributes:
        L: The lower triangle by rows; what stands on the diagonal is `D`.
        inverse_pivots: The diagonal of `D^-1`.
    """

    L: Matrix
    inverse_pivots: Vector


def solve_symmetric(A: Matrix, b: Vector) -> Vector:
    """Solve `A x = b`, skipping zeros; see `factorize`."""
    return solve_factorized(factorize(A), b)


def factorize(A: Matrix) -> Factorization:
    """Factorize from the last row on, so that a mechanism's branches stay zero.

    Args:
        A: Symmetric, definite; only the lower triangle is read.

    Raises:
        SingularInertiaError: If a pivot is a constant zero.

    Source: Featherstone 2008, sec. 6.5.
    """
    size = len(A)
    L = [list(row[: index + 1]) for index, row in enumerate(A)]
    inverse_pivots: Vector = [0.0] * size
    for k in reversed(range(size)):
        inverse_pivots[k] = _inverse(L[k][k])
        support = [i for i in range(k) if not is_zero(L[k][i])]
        for i in reversed(support):
            factor = L[k][i] * inverse_pivots[k]
            for j in (j for j in support if j <= i):
                L[i][j] = L[i][j] - factor * L[k][j]
            L[k][i] = factor
    return Factorization(L, inverse_pivots)


def solve_factorized(factorization: Factorization, b: Vector) -> Vector:
    """Solve `A x = b` for a factorized `A`."""
    L, inverse_pivots = factorization
    x = half_solved(factorization, b)
    x = [value * inverse for value, inverse in zip(x, inverse_pivots, strict=True)]
    for k in range(len(x)):
        for i in range(k):
            x[k] = x[k] - L[k][i] * x[i]
    return x


def half_solved(factorization: Factorization, b: Vector) -> Vector:
    """Return `L^-T b` of a factorized matrix: `b A^-1 b` is its square, weighted with `D^-1`."""
    x = list(b)
    for k in reversed(range(len(x))):
        for i in range(k):
            x[i] = x[i] - factorization.L[k][i] * x[k]
    return x


def inverse(factorization: Factorization) -> Matrix:
    """Return the inverse of a factorized matrix; what its symmetry tells is not solved for."""
    L, inverse_pivots = factorization
    size = len(inverse_pivots)
    found: Matrix = [[0.0] * size for _ in range(size)]
    for column in range(size):
        for row in range(column, size):
            entry = inverse_pivots[column] if row == column else 0.0
            for k in range(row):
                entry = entry - L[row][k] * found[k][column]
            found[row][column] = found[column][row] = entry
    return found


def is_zero(value: Scalar) -> bool:
    """Return whether a value is a constant zero."""
    return isinstance(value, float) and value == 0.0


def _inverse(pivot: Scalar) -> Scalar:
    if is_zero(pivot):
        raise SingularInertiaError
    return 1.0 / pivot
