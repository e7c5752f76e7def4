"""Whether a possible body is one that people build."""

from math import pi

from kindsl.rigid.body import (
    Eigenpair,
    MassDistribution,
    Symmetric,
    determinant,
    equivalent_density,
)

LEAST_DENSITY = 10.0
GREATEST_DENSITY = 30_000.0
GREATEST_LENGTH = 10.0

_LEAST = (3.0 / (4.0 * pi * LEAST_DENSITY)) ** 2 / 125.0
_GREATEST = (3.0 / (4.0 * pi * GREATEST_DENSITY)) ** 2 / 125.0


def is_plainly_dense_as_matter(mass: float, second_moments: Symmetric) -> bool:
    """Return whether the equivalent ellipsoid's density is plausible, without eigenvalues.

    The ellipsoid with semi-axes `sqrt(5 s / m)` has the squared volume
    `(4/3 pi)^2 125 det(S) / m^3`, and density is mass by volume.
    """
    scale = mass * mass * mass * mass * mass
    return _GREATEST * scale <= determinant(second_moments) <= _LEAST * scale


def is_placeholder(body: MassDistribution) -> bool:
    """Return whether mass and moments are all 1.0, which no body is by chance."""
    return body.mass == 1.0 and body.moments[:3] == (1.0, 1.0, 1.0)


def density_of(mass: float, pairs: tuple[Eigenpair, Eigenpair, Eigenpair]) -> float:
    """Return the density of the equivalent ellipsoid, kg/m³; infinite without extent.

    Args:
        mass: kg, positive.
        pairs: Eigenpairs of the second moments about the CoM, ascending.
    """
    return equivalent_density(mass, (pairs[0].value, pairs[1].value, pairs[2].value))


def is_dense_as_matter(mass: float, pairs: tuple[Eigenpair, Eigenpair, Eigenpair]) -> bool:
    """Return whether a body is neither lighter than foam nor heavier than any metal."""
    return LEAST_DENSITY <= density_of(mass, pairs) <= GREATEST_DENSITY
