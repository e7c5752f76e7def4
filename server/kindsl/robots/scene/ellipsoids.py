"""The solid ellipsoid that has a link's mass and inertia."""

from functools import lru_cache
from math import sqrt
from typing import NamedTuple

from kindsl.mechanics.rigid.body import (
    MassDistribution,
    eigensystem,
    moments_of,
    second_moments_about_com,
)
from kindsl.mechanics.rigid.pose import Vector3, cross, scaled
from kindsl.mechanics.rigid.solid import TOLERANCE

# As in Drake: an axis is never drawn thinner than this share of the largest.
THINNEST = 0.01
_MOST_KNOWN = 1 << 12


class InertiaEllipsoid(NamedTuple):
    """The ellipsoid of a body.

    Attributes:
        semi_axes: Right-handed, ascending, each a vector in the body's axes, metres; None for a
            body without mass or extent.
        about_com: Inertia tensor about the centre of mass, body axes, row by row, kg m^2.
        is_consistent: Whether a rigid body with such an inertia exists.
    """

    semi_axes: tuple[Vector3, Vector3, Vector3] | None
    about_com: tuple[float, ...]
    is_consistent: bool


@lru_cache(maxsize=_MOST_KNOWN)
def inertia_ellipsoid(body: MassDistribution) -> InertiaEllipsoid:
    """Return the solid ellipsoid of the same mass and inertia.

    A solid ellipsoid's second moment along a semi-axis `a` is `m a^2 / 5`.
    """
    second_moments = second_moments_about_com(body)
    Ix, Iy, Iz, Ixy, Ixz, Iyz = moments_of(second_moments)
    about_com = (Ix, -Ixy, -Ixz, -Ixy, Iy, -Iyz, -Ixz, -Iyz, Iz)
    least, middle, largest = eigensystem(second_moments)
    is_consistent = body.mass >= 0.0 and least.value >= -TOLERANCE * abs(largest.value)
    if body.mass <= 0.0 or largest.value <= 0.0:
        return InertiaEllipsoid(None, about_com, is_consistent)
    thinnest = THINNEST * THINNEST * largest.value
    lengths = [
        sqrt(5.0 * max(pair.value, thinnest) / body.mass) for pair in (least, middle, largest)
    ]
    axes = (least.axis, middle.axis, cross(least.axis, middle.axis))
    a, b, c = (scaled(axis, length) for axis, length in zip(axes, lengths, strict=True))
    return InertiaEllipsoid((a, b, c), about_com, is_consistent)
