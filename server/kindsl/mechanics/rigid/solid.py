"""The uniform solid that has exactly a body's mass, centre of mass and inertia.

It is a superquadric: a sphere where the second moments are equal, a cylinder or disc where two are,
else a rounded box, one passing into the other. Its exponents come from how unequal the radii of
gyration are, its semi-axes from the second moments of the unit superquadric.

Source: Kindlmann 2004, Superquadric tensor glyphs; Jaklic, Solina 2003, Moments of superellipsoids.
"""

from collections.abc import Sequence
from functools import lru_cache
from math import atan2, copysign, cos, exp, lgamma, sin, sqrt
from typing import NamedTuple

from kindsl.mechanics.rigid.body import (
    Eigenpair,
    MassDistribution,
    eigensystem,
    second_moments_about_com,
)
from kindsl.mechanics.rigid.pose import Vector3, cross, dot

# A second moment may be negative by this share of the largest, which rounding explains.
TOLERANCE = 0.02
_SHARPNESS = 3
_LEAST_EXPONENT = 0.12
_LEAST_SHARE = 1e-4  # of the largest second moment: no body is drawn thinner
_MOST_KNOWN = 1 << 12


class Solid(NamedTuple):
    """A superquadric of uniform density.

    Attributes:
        center: Its middle, the centre of mass, in the body's axes, metres.
        axes: Right-handed unit vectors in the body's axes; the last is the pole.
        semi_axes: Along these, metres.
        gyration: Radii of gyration along these, metres.
        exponents: Along meridians and along parallels, 1 for round and near 0 for square.
        density: kg/m^3.
        is_possible: Whether a rigid body has this inertia; if not, the solid is drawn from the
            magnitudes of the second moments.
    """

    center: Vector3
    axes: tuple[Vector3, Vector3, Vector3]
    semi_axes: Vector3
    gyration: Vector3
    exponents: tuple[float, float]
    density: float
    is_possible: bool

    def support(self, direction: Vector3) -> Vector3:
        """Return the farthest point in a direction, in the body's axes."""
        (a, b, c), (e1, e2) = self.semi_axes, self.exponents
        along = [dot(direction, axis) for axis in self.axes]
        x, y, z = (n * half for n, half in zip(along, self.semi_axes, strict=True))
        across = 2.0 - e2
        turn = atan2(_power(y, 1.0 / across), _power(x, 1.0 / across))
        co, si = cos(turn), sin(turn)
        reach = abs(x) / abs(co) ** across if abs(co) > abs(si) else abs(y) / abs(si) ** across
        rise = atan2(_power(z, 1.0 / (2.0 - e1)), reach ** (1.0 / (2.0 - e1)))
        ring = cos(rise) ** e1
        local = (a * ring * _power(co, e2), b * ring * _power(si, e2), c * _power(sin(rise), e1))
        return _combined(self.center, local, self.axes)

    @property
    def reach(self) -> float:
        """Its longest semi-axis, metres."""
        return max(self.semi_axes)


@lru_cache(maxsize=_MOST_KNOWN)
def equivalent_solid(body: MassDistribution) -> Solid | None:
    """Return the solid of a body, None for one without mass or extent."""
    small, middle, large = eigensystem(second_moments_about_com(body))
    scale = max(abs(small.value), abs(large.value))
    if body.mass <= 0.0 or scale <= 0.0:
        return None
    is_possible = small.value >= -TOLERANCE * scale
    pairs = [pair._replace(value=abs(pair.value)) for pair in (large, middle, small)]
    if is_possible:
        pairs[2] = small._replace(value=max(small.value, 0.0))
    pairs.sort(key=lambda pair: -pair.value)
    gyration = [sqrt(max(p.value, _LEAST_SHARE * scale) / body.mass) for p in pairs]
    return _superquadric(body, pairs, gyration, is_possible=is_possible)


def _superquadric(
    body: MassDistribution,
    pairs: Sequence[Eigenpair],
    gyration: Sequence[float],
    *,
    is_possible: bool,
) -> Solid:
    """Return the solid with these radii of gyration along the axes, descending."""
    first, second, third = gyration
    total = first + second + third
    linear, planar = (first - second) / total, 2.0 * (second - third) / total
    is_rod = linear >= planar
    order = (1, 2, 0) if is_rod else (0, 1, 2)
    along, around = (linear, planar) if is_rod else (planar, linear)
    e1, e2 = (max((1.0 - share) ** _SHARPNESS, _LEAST_EXPONENT) for share in (along, around))
    volume, across, pole = _unit_moments(e1, e2)
    i, j, k = (gyration[axis] for axis in order)
    a, b, c = i / sqrt(across), j / sqrt(across), k / sqrt(pole)
    x, y = pairs[order[0]].axis, pairs[order[1]].axis
    return Solid(
        center=body.com,
        axes=(x, y, cross(x, y)),
        semi_axes=(a, b, c),
        gyration=(i, j, k),
        exponents=(e1, e2),
        density=body.mass / (volume * a * b * c),
        is_possible=is_possible,
    )


def _unit_moments(e1: float, e2: float) -> Vector3:
    """Return of the unit superquadric the volume, and the means of x^2 (= y^2) and of z^2."""
    volume = 2.0 * e1 * e2 * _beta(e1 / 2 + 1, e1) * _beta(e2 / 2, e2 / 2)
    across = 0.5 * e1 * e2 * _beta(1.5 * e2, 0.5 * e2) * _beta(0.5 * e1, 2.0 * e1 + 1)
    pole = 2.0 * e1 * e2 * _beta(0.5 * e2, 0.5 * e2 + 1) * _beta(1.5 * e1, e1 + 1)
    return volume, across / volume, pole / volume


def _beta(a: float, b: float) -> float:
    return exp(lgamma(a) + lgamma(b) - lgamma(a + b))


def _power(value: float, exponent: float) -> float:
    return copysign(abs(value) ** exponent, value)


def _combined(start: Vector3, numbers: Vector3, axes: Sequence[Vector3]) -> Vector3:
    x, y, z = (
        start[i] + sum(number * axis[i] for number, axis in zip(numbers, axes, strict=True))
        for i in range(3)
    )
    return x, y, z
