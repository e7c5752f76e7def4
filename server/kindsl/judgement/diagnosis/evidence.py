"""The evidence that ten numbers are those of a robot's link, against that they are anything.

All is a logarithm of a ratio: how much likelier a quantity is of a link that somebody published
than of numbers of which nothing is known. Density, proportions, size, place and mass are looked up
in the tables of `fitted`, which `benchmarks/fit_judge.py` writes. Links lie along their axes far
more often than chance would have it, so products about the CoM that vanish within the rounding are
strong evidence. It is written as a density over the six second moments about the CoM, so that
hypotheses that move or scale them can be compared.

With eigenvalues `a b c` the second moments' volume element is `|a-b| |b-c| |a-c| da db dc` times
that of the rotations, whose whole is `2 pi^2` because an axis has no direction.
"""

from collections.abc import Iterator
from math import exp, hypot, inf, log, pi, sqrt
from operator import mul
from typing import NamedTuple

from kindsl.judgement.diagnosis.fitted import LIES, TABLES, TRUST
from kindsl.judgement.diagnosis.judgements import spread_along
from kindsl.mechanics.rigid.body import (
    Eigenpairs,
    MassDistribution,
    Symmetric,
    eigensystem,
    second_moments_about_com,
)
from kindsl.mechanics.rigid.pose import Vector3, dot

# Of products, by the gap beside them, where a body lies nearly along the axes.
_TILT = 0.2
# Errors within which a product is zero, and the least of that by the greatest second moment.
_SURE, _ZERO = 2.0, 1e-3
# What is less apart than this share of the greatest second moment is taken to be so far apart.
_LEAST_APART = 0.02
# From here on a body has a long axis.
ELONGATED = 2.5
# In kg/m³: of plastic and light metal, hollow as links are.
_USUAL_DENSITY = 1500.0
# In m: a CoM within it is at the origin.
_NEXT_TO_ORIGIN = 1e-4
# What is nothing of a length, a mass or a moment.
_NOTHING = 1e-30


class MassShape(NamedTuple):
    """The second moments of a body about its CoM.

    Attributes:
        matrix: As given, kg·m².
        errors: How far each may be from that.
        pairs: Eigenvalues and axes, ascending.
    """

    matrix: Symmetric
    errors: Symmetric
    pairs: Eigenpairs

    @property
    def values(self) -> Vector3:
        """The eigenvalues, none less than the digits tell."""
        least = max(*self.errors[:3], _NOTHING)
        a, b, c = (max(pair.value, least) for pair in self.pairs)
        return a, b, c

    @property
    def is_thin(self) -> bool:
        """True if the digits do not tell how thick the body is."""
        return self.pairs[0].value <= max(self.errors[:3])


def shape_of(body: MassDistribution, half: MassDistribution) -> MassShape | None:
    """Return the second moments about the CoM, None where one is negative beyond the digits."""
    matrix = second_moments_about_com(body)
    errors = errors_of(body, half)
    if any(matrix[i] < -errors[i] for i in range(3)):
        return None
    return MassShape(matrix, errors, eigensystem(matrix))


def density(mass: float, shape: MassShape) -> float:
    """Return the density of the equivalent ellipsoid, kg/m³, no thinner than the digits tell."""
    volume = 4.0 / 3.0 * pi
    for value in shape.values:
        volume *= sqrt(5.0 * value / mass)
    return mass / volume if volume else inf


def vanishing_products(shape: MassShape) -> tuple[bool, bool, bool]:
    """Return which products about the CoM are zero within the digits."""
    xy, xz, yz = (abs(shape.matrix[i]) <= _SURE * shape.errors[i] for i in (3, 4, 5))
    return xy, xz, yz


def of_matter(
    body: MassDistribution, shape: MassShape, end: Vector3 | None, other_mass: float
) -> float:
    """Return how much likelier a body is than any numbers, by all but its counterparts.

    Up to a constant that all hypotheses about one link share.

    Args:
        body: With a positive mass.
        shape: Its second moments about the CoM.
        end: Where the link ends, as seen from its origin, m; None if that is not known.
        other_mass: Of the robot's links, kg; zero if that is not known.
    """
    quantities = quantities_of(body, shape, end, other_mass)
    return sum(TABLES[name].at(value) for name, value in quantities) + TRUST * of_spread(shape)


def of_spread(shape: MassShape) -> float:
    """Return the logarithm of the density of second moments, all sizes being equally likely."""
    a, b, c = shape.values
    return log(sum(map(mul, LIES, ways_to_lie(shape)))) - log(a * b * c)


def quantities_of(
    body: MassDistribution, shape: MassShape, end: Vector3 | None, other_mass: float
) -> Iterator[tuple[str, float]]:
    """Yield the quantities of a body that have a table; arguments are those of `of_matter`."""
    a, b, c = shape.values
    seeming = density(body.mass, shape)
    if 0.0 < seeming < inf:
        # A body thinner than its digits tell may be denser than it seems.
        yield "density", log(max(seeming, _USUAL_DENSITY) if shape.is_thin else seeming)
    yield "thickness", log(a / c)
    yield "width", log(b / c)
    distance, gyration = _distance(body), sqrt((a + b + c) / body.mass)
    yield "gyration", log(gyration)
    yield from quantities_of_place(body, end, other_mass)
    if end is not None:
        yield "size", log(gyration / hypot(*end))
        if c > ELONGATED * b:
            yield "direction", abs(dot(shape.pairs[2].axis, end)) / hypot(*end)
    if distance:
        along = max(spread_along(shape.matrix, body.com) / distance**2, _LEAST_APART * c)
        yield "place", log(distance / sqrt(along / body.mass))


def quantities_of_place(
    body: MassDistribution, end: Vector3 | None, other_mass: float
) -> Iterator[tuple[str, float]]:
    """Yield the quantities of a mass and its centre alone, which no moments change."""
    if other_mass > 0.0:
        yield "mass", log(body.mass / other_mass)
    distance = _distance(body)
    if distance:
        yield "distance", log(distance)
    if end is not None and distance:
        yield "reach", log(distance / hypot(*end))
        yield "side", dot(body.com, end) / (distance * hypot(*end))


def of_mass(mass: float, other_mass: float) -> float:
    """Return the part of `of_matter` that a mass beside those of the other links has."""
    return TABLES["mass"].at(log(mass / other_mass)) if other_mass > 0.0 else 0.0


def of_place(body: MassDistribution, end: Vector3 | None, other_mass: float) -> float:
    """Return the part of `of_matter` that a mass and its centre alone have."""
    quantities = quantities_of_place(body, end, other_mass)
    return sum(TABLES[name].at(value) for name, value in quantities)


def _distance(body: MassDistribution) -> float:
    distance = hypot(*body.com)
    return distance if distance >= _NEXT_TO_ORIGIN else 0.0


def of_anything(moments: Symmetric) -> float:
    """Return the same of six moments of which nothing is known.

    A product that is written as zero says as much as it does of a body along its axes.
    """
    size = max(_NOTHING, *map(abs, moments))
    widths = [size if moment else 2.0 * _ZERO * size for moment in moments[3:]]
    return -3.0 * log(size) - sum(map(log, widths))


def ways_to_lie(shape: MassShape) -> tuple[float, float, float, float]:
    """Return the densities of the products and of the differences on the diagonal.

    Of a body along its axes, of one that is turned about one of them, of one that is tilted a
    little, and of one that lies anyhow.
    """
    a, b, c = shape.values
    error = max(shape.errors[:3])
    least = max(error, _LEAST_APART * c)
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
    return aligned, turned, tilted, anyhow


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
