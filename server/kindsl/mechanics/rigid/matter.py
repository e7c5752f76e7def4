"""Densities that a body of real matter has."""

from math import inf, pi, sqrt

from kindsl.mechanics.rigid.body import Eigenpairs, Symmetric, determinant

LEAST_DENSITY, GREATEST_DENSITY = 10.0, 30_000.0  # kg/m³: foam, and more than any metal

_LEAST_SQUARE = (3.0 / (4.0 * pi * LEAST_DENSITY)) ** 2 / 125.0
_GREATEST_SQUARE = (3.0 / (4.0 * pi * GREATEST_DENSITY)) ** 2 / 125.0

Pairs = Eigenpairs


def density_of(mass: float, pairs: Pairs) -> float:
    """Return the density of the homogeneous ellipsoid with these second moments, kg/m³.

    A body thinner than a tenth of its length is taken to be that thick, so that rods and plates
    whose thickness is lost in rounding are not dense without bound. A body without any extent is.

    Args:
        mass: kg, positive.
        pairs: Eigenpairs of the second moments about the CoM, ascending.
    """
    least = 0.01 * max(pairs[2].value, 0.0)
    volume = 4.0 / 3.0 * pi
    for pair in pairs:
        volume *= sqrt(5.0 * max(pair.value, least) / mass)
    return mass / volume if volume else inf


def is_dense_as_matter(mass: float, pairs: Pairs) -> bool:
    """Return whether a body is neither lighter than foam nor heavier than any metal."""
    return LEAST_DENSITY <= density_of(mass, pairs) <= GREATEST_DENSITY


def is_plainly_dense_as_matter(mass: float, second_moments: Symmetric) -> bool:
    """Return whether the equivalent ellipsoid's density is plausible, without eigenvalues.

    The ellipsoid with semi-axes `sqrt(5 s / m)` has the squared volume
    `(4/3 pi)^2 125 det(S) / m^3`, and density is mass by volume.
    """
    scale = mass * mass * mass * mass * mass
    return _GREATEST_SQUARE * scale <= determinant(second_moments) <= _LEAST_SQUARE * scale
