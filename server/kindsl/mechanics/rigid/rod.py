"""A slender body beside the way from its frame's origin to another place of its link."""

from math import hypot, sqrt
from typing import NamedTuple

from kindsl.mechanics.rigid.body import MassDistribution, Symmetric, eigensystem
from kindsl.mechanics.rigid.pose import Vector3, dot

_SLENDER = 4.0  # largest by middle second moment
_BESIDE = 0.2  # of the way's length
# Of a rod whose CoM is a sixth of its length beyond an end, twice as much would lie on the way if
# it were turned round there; of less, as of an arm with a counterweight, a sign says little.
_BEYOND = 1.0 / 6.0
_IMPOSSIBLE, _NEGLIGIBLE = 0.01, 1e-9


class Rod(NamedTuple):
    """A slender body, and how it lies to a way.

    Attributes:
        length: Of a uniform rod with its largest second moment, m.
        way: Length of the way, m.
        slender: Largest by middle second moment.
        cosine: Of the angle between them.
        ahead: Share of the way at which the CoM is.
        beside: Distance of the CoM from the way's line, m.
    """

    length: float
    way: float
    slender: float
    cosine: float
    ahead: float
    beside: float

    @property
    def is_between(self) -> bool:
        """True if the CoM is between the ends of the way, or hardly beyond."""
        beyond = _BEYOND * self.length / self.way
        return -beyond <= self.ahead <= 1.0 + beyond

    @property
    def is_beside(self) -> bool:
        """True if the CoM is away from the way."""
        return self.beside > _BESIDE * self.way

    def is_as_long(self, limits: tuple[float, float]) -> bool:
        """Return whether it is about as long as the way."""
        return limits[0] < self.length / self.way < limits[1]


def rod_beside(body: MassDistribution, second_moments: Symmetric, end: Vector3) -> Rod | None:
    """Return a body as a rod, None where it is stout or impossible.

    Args:
        body: With a positive mass.
        second_moments: Its own, about the CoM.
        end: Of the way, not the origin, where it begins; m.
    """
    if _is_plainly_stout(second_moments):
        return None
    small, middle, large = eigensystem(second_moments)
    slender = large.value / max(middle.value, _NEGLIGIBLE * large.value, 1e-300)
    if small.value < -_IMPOSSIBLE * large.value or slender <= _SLENDER:
        return None
    way = hypot(*end)
    length, ahead = sqrt(12.0 * large.value / body.mass), dot(body.com, end) / way
    beside = sqrt(max(dot(body.com, body.com) - ahead * ahead, 0.0))
    return Rod(length, way, slender, abs(dot(large.axis, end)) / way, ahead / way, beside)


def _is_plainly_stout(second_moments: Symmetric) -> bool:
    """Return whether the largest second moment is less than four times the next, and all positive.

    With `x <= y` and `4 y <= z`, `(x + y + z)^2` is `4 (x y + x z + y z)` at least.
    """
    xx, yy, zz, xy, xz, yz = second_moments
    minors = xx * yy + xx * zz + yy * zz - xy * xy - xz * xz - yz * yz
    return (xx + yy + zz) ** 2 < _SLENDER * minors
