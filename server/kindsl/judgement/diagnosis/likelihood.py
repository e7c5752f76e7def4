"""The likelihood that ten numbers are those of a robot's link.

A prior over bodies: how dense, how large against the distance of its CoM, of which proportions, and
how it lies in the link frame. Links lie along their axes far more often than chance would have it,
so products about the CoM that vanish within the rounding are strong evidence. Everything is written
as a density over the six second moments about the CoM, so that hypotheses that move or scale them
can be compared.

With eigenvalues `a b c` the second moments' volume element is `|a-b| |b-c| |a-c| da db dc` times
that of the rotations, whose whole is `2 pi^2` because an axis has no direction.
"""

from math import exp, inf, log, pi, sqrt
from typing import NamedTuple

from kindsl.mechanics.rigid.body import (
    Eigenpair,
    MassDistribution,
    Symmetric,
    eigensystem,
    second_moments_about_com,
)
from kindsl.mechanics.rigid.pose import Vector3

_DENSITY, _DENSITY_SPREAD = 1500.0, 1.2
_SIZE, _SIZE_SPREAD = 0.5, 1.0
# Of the logarithm of a link's mass by its robot's middle one: 1,154 links of 69 published robots.
_MASS_SPREAD = 1.5
_BACKGROUND = 0.05
_BACKGROUND_WIDTH = 10.0
_TILT = 0.2
_ALIGNED, _TURNED, _TILTED, _ANYHOW = 0.35, 0.15, 0.25, 0.25
_SURE = 2.0
_ZERO = 1e-3


class MassShape(NamedTuple):
    """The second moments of a body about its CoM.

    Attributes:
        matrix: As given, kg·m².
        errors: How far each may be from that.
        pairs: Eigenvalues and axes, ascending.
    """

    matrix: Symmetric
    errors: Symmetric
    pairs: tuple[Eigenpair, Eigenpair, Eigenpair]


def shape_of(body: MassDistribution, half: MassDistribution) -> MassShape | None:
    """Return the second moments about the CoM, None where one is negative beyond the digits."""
    matrix = second_moments_about_com(body)
    errors = errors_of(body, half)
    if any(matrix[i] < -errors[i] for i in range(3)):
        return None
    return MassShape(matrix, errors, eigensystem(matrix))


def log_likelihood(mass: float, shape: MassShape, reach: float) -> float:
    """Return the logarithm of the density of a body's second moments, up to a constant.

    Args:
        mass: kg, positive.
        shape: Its second moments about the CoM.
        reach: How far the link goes from its origin, m; zero if that is not known.
    """
    error = max(shape.errors[:3])
    small, middle, large = (max(pair.value, error, 1e-30) for pair in shape.pairs)
    total = _of_density(mass, shape) - log(small * middle * large)
    if reach > 0.0:
        total += _of_ratio(sqrt((small + middle + large) / mass) / reach, _SIZE, _SIZE_SPREAD)
    return total + _of_orientation(shape, (small, middle, large), error)


def log_likelihood_of_mass(mass: float, others: float) -> float:
    """Return the logarithm of the density of a mass, seeing what the others weigh, kg, or zero."""
    return _of_ratio(mass, others, _MASS_SPREAD) if others > 0.0 else 0.0


def density(mass: float, shape: MassShape) -> float:
    """Return the density of the equivalent ellipsoid, kg/m³, no thinner than the digits tell."""
    error = max(shape.errors[:3])
    small, middle, large = (max(pair.value, error, 1e-30) for pair in shape.pairs)
    return _density(mass, (small, middle, large))


def vanishing_products(shape: MassShape) -> tuple[bool, bool, bool]:
    """Return which products about the CoM are zero within the digits."""
    xy, xz, yz = (abs(shape.matrix[i]) <= _SURE * shape.errors[i] for i in (3, 4, 5))
    return xy, xz, yz


def _density(mass: float, eigenvalues: Vector3) -> float:
    volume = 4.0 / 3.0 * pi
    for value in eigenvalues:
        volume *= sqrt(5.0 * value / mass)
    return mass / volume if volume else inf


def _of_density(mass: float, shape: MassShape) -> float:
    """Return the log density; a body thinner than its digits tell may be denser than it seems."""
    seeming = density(mass, shape)
    is_thin = shape.pairs[0].value <= max(shape.errors[:3])
    return _of_ratio(max(seeming, _DENSITY) if is_thin else seeming, _DENSITY, _DENSITY_SPREAD)


def _of_ratio(value: float, middle: float, spread: float) -> float:
    """Return the log density of a quantity that is log-normal, with a thin background."""
    if not 0.0 < value < inf:
        return log(1e-9)
    z = log(value / middle) / spread
    normal = exp(-0.5 * z * z) / (spread * sqrt(2.0 * pi))
    return log((1.0 - _BACKGROUND) * normal + _BACKGROUND / _BACKGROUND_WIDTH * exp(-0.05 * z * z))


def _of_orientation(shape: MassShape, values: Vector3, error: float) -> float:
    """Return the log density of the products and of the differences on the diagonal."""
    a, b, c = values
    least = max(error, 0.02 * c)
    ab, bc, ac = max(b - a, least), max(c - b, least), max(c - a, least)
    anyhow = 1.0 / (ab * bc * ac * 2.0 * pi * pi)
    xx, yy, zz, *products = shape.matrix
    gaps = (max(abs(xx - yy), least), max(abs(xx - zz), least), max(abs(yy - zz), least))
    tilted = 1.0 / 6.0
    for product, gap in zip(products, gaps, strict=True):
        z = product / (_TILT * gap)
        tilted *= exp(-0.5 * z * z) / (_TILT * gap * sqrt(2.0 * pi))
    # A product that is zero under every hypothesis says nothing of how exactly it is known.
    known = [shape.errors[i] if shape.matrix[i] else 0.0 for i in (3, 4, 5)]
    widths = [2.0 * max(_SURE * error, _ZERO * c) for error in known]
    zero = [abs(p) <= 0.5 * width for p, width in zip(products, widths, strict=True)]
    aligned = 1.0 / (6.0 * widths[0] * widths[1] * widths[2]) if all(zero) else 0.0
    turned = 0.0
    for i in range(3):
        j, k = (n for n in range(3) if n != i)
        if zero[j] and zero[k]:
            turned += 1.0 / (9.0 * widths[j] * widths[k] * (pi / 2.0) * max(gaps[i], least))
    return log(_ALIGNED * aligned + _TURNED * turned + _TILTED * tilted + _ANYHOW * anyhow)


def errors_of(body: MassDistribution, half: MassDistribution) -> Symmetric:
    """Return how far the second moments about the CoM may be from those of the numbers written."""
    m, (x, y, z), moments = body
    hm, (hx, hy, hz), halves = half
    of_moments = 0.5 * (halves[0] + halves[1] + halves[2])
    noise = 1e-12 * (sum(map(abs, moments)) + m * (x * x + y * y + z * z))
    return (
        noise + of_moments + 2.0 * m * abs(x) * hx + x * x * hm,
        noise + of_moments + 2.0 * m * abs(y) * hy + y * y * hm,
        noise + of_moments + 2.0 * m * abs(z) * hz + z * z * hm,
        noise + halves[3] + m * (abs(x) * hy + abs(y) * hx) + abs(x * y) * hm,
        noise + halves[4] + m * (abs(x) * hz + abs(z) * hx) + abs(x * z) * hm,
        noise + halves[5] + m * (abs(y) * hz + abs(z) * hy) + abs(y * z) * hm,
    )
