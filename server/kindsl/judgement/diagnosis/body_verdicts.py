"""Doubts about the shape of a body, said once for rules, hovers and reports.

`body_verdicts(name, body, children, frames)` takes plain floats in the link frame and returns a
`BodyVerdict` for each thing that is doubtful, the gravest first: its `kind` (a `BodyDoubt`, which
is the word for it: `too light`, `too dense`, `apart`, `too long`, `across`, `behind`), the
`number` that says so, the `code` of the rule that reports it, and a `sentence` with the body's
name. Of a fixed base do not ask: its inertia does not matter.

Thresholds are two or three times beyond the 584 possible bodies of 68 published robots. There,
densities are 17 to 10 100 kg/m³, placeholders apart. The CoM is at most 0.34 times as far from the
link as would be `apart`, the radius of gyration at most 0.41 times what would be `too long`. Only
UR5's arms are `across` (a real defect), only an arm of TIAGo dual and a clavicle are `behind`.
"""

from collections.abc import Sequence
from enum import StrEnum
from functools import lru_cache
from math import dist, hypot, sqrt
from typing import NamedTuple

from kindsl.language.text.quantities import with_unit
from kindsl.mechanics.rigid.body import (
    MassDistribution,
    Symmetric,
    eigensystem,
    is_clearly_positive,
    second_moments_about_com,
)
from kindsl.mechanics.rigid.matter import (
    GREATEST_DENSITY,
    LEAST_DENSITY,
    density_of,
    is_plainly_dense_as_matter,
)
from kindsl.mechanics.rigid.pose import Vector3, nearest_on_way
from kindsl.mechanics.rigid.rod import Rod, rod_beside

GREATEST_LENGTH = 10.0  # m: beyond that units are wrong, and nothing is judged
# Of a crane's lattice, 0.2 to 1 kg/m³ of the cube over its length; of what was typed in
# millimetres it is below 0.005.
_LATTICE, _RADIUS = 0.02, 0.1
DOUBTFUL_LENGTH = 5.0  # m: longer than any link of a robot, so wrong where more speaks for it

_SHORTEST, _SHORTEST_ROD = 0.02, 0.05
_GYRATIONS, _WIDE = 3.0, 5.0
_SLENDER_ACROSS = 8.0
_AS_LONG_ACROSS, _AS_LONG_BEHIND = (0.7, 1.5), (0.5, 1.5)
_OBLIQUE, _SQUARE, _PARALLEL = 0.5, 0.2, 0.8  # cosines
_NEAR_END = 0.2  # of the link's length
_NEGLIGIBLE = 1e-9
_MOST_KNOWN = 1 << 12


class BodyDoubt(StrEnum):
    """A possible defect of a body, in a word or two."""

    TOO_LIGHT = "too light"
    TOO_DENSE = "too dense"
    APART = "apart"
    TOO_LONG = "too long"
    ACROSS = "across"
    BEHIND = "behind"


# What only a known length tells: that of a rail is none from its joint to where its slide stands.
OF_LENGTH = frozenset((BodyDoubt.TOO_LONG, BodyDoubt.ACROSS, BodyDoubt.BEHIND))


class BodyVerdict(NamedTuple):
    """One thing that is doubtful.

    Attributes:
        kind: The doubt.
        number: Its measure: kg/m³ of a density, else metres; where it is negative, the CoM is
            behind the link's own joint.
        code: The rule that reports it.
        sentence: With the body's name in quotes, without final period.
    """

    kind: BodyDoubt
    number: float
    code: str
    sentence: str


@lru_cache(maxsize=_MOST_KNOWN)
def body_verdicts(
    name: str,
    body: MassDistribution,
    children: tuple[Vector3, ...],
    frames: tuple[Vector3, ...] = (),
) -> tuple[BodyVerdict, ...]:
    """Return what is doubtful about a body, nothing of one without mass.

    Args:
        name: Of the link.
        body: In the link frame, whose origin is the supporting joint's.
        children: Origins of the children's joints in the link frame, m.
        frames: Origins of its named frames, the same.
    """
    if body.mass <= 0.0:
        return ()
    ends, points = children or frames, [p for p in (*children, *frames) if any(p)]
    is_way = len(ends) == 1 and _is_way(ends[0])
    second_moments = second_moments_about_com(body)
    apart = min([dist(body.com, nearest_on_way(body.com, point)) for point in points], default=0.0)
    rod = rod_beside(body, second_moments, ends[0]) if is_way else None
    is_matter = is_clearly_positive(second_moments)
    is_matter = is_matter and is_plainly_dense_as_matter(body.mass, second_moments)
    density = None if is_matter else density_verdict(name, body)
    place = _place_verdict(name, body, second_moments, points, apart)
    if density is not None and place is not None and place.kind is BodyDoubt.TOO_LONG:
        place = None  # The moments are reported once.
    lie = _rod_verdict(name, rod) if rod is not None else None
    return tuple(verdict for verdict in (density, place, lie) if verdict is not None)


def density_verdict(name: str, body: MassDistribution) -> BodyVerdict | None:
    """Return the verdict on a body's density, None where it is plausible or the body impossible.

    Args:
        name: Of the link.
        body: With a positive mass, in any frame.
    """
    second_moments = second_moments_about_com(body)
    pairs = eigensystem(second_moments)
    is_possible = pairs[0].value > _NEGLIGIBLE * sum(pair.value for pair in pairs) > 0.0
    density = density_of(body.mass, pairs)
    if not is_possible or LEAST_DENSITY <= density <= GREATEST_DENSITY:
        return None
    kind = BodyDoubt.TOO_LIGHT if density < LEAST_DENSITY else BodyDoubt.TOO_DENSE
    told = f"inertia of '{name}' implies a density of {with_unit(density, 'kg/m³')}"
    told += f"; its radius of gyration is {with_unit(_gyration(body, second_moments), 'm')}"
    return BodyVerdict(kind, density, "KD311", told)


def lies_along(body: MassDistribution, end: Vector3) -> bool:
    """Return whether a body is a rod along the way to an end of its link."""
    rod = rod_beside(body, second_moments_about_com(body), end) if _is_way(end) else None
    return rod is not None and rod.cosine >= _PARALLEL and rod.is_between and not rod.is_beside


def _place_verdict(
    name: str,
    body: MassDistribution,
    second_moments: Symmetric,
    points: Sequence[Vector3],
    apart: float,
) -> BodyVerdict | None:
    """Return whether the mass is where the link is, `apart` from it in metres."""
    length = max([hypot(*point) for point in points], default=0.0)
    is_shape = sum(second_moments[:3]) >= -_NEGLIGIBLE * max(body.moments)
    if not _SHORTEST < length < GREATEST_LENGTH or not is_shape:
        return None
    com, radius = body.com, _gyration(body, second_moments)
    if max(map(abs, com)) > GREATEST_LENGTH:
        return None
    its_length = f"{with_unit(length, 'm')} long"
    if apart > length + _GYRATIONS * radius:
        told = f"CoM of '{name}' lies {with_unit(apart, 'm')} from a link {its_length}"
        return BodyVerdict(BodyDoubt.APART, apart, "KD309", told)
    if radius > _WIDE * (length + hypot(*com)):
        told = f"radius of gyration of '{name}' is {with_unit(radius, 'm')}"
        return BodyVerdict(BodyDoubt.TOO_LONG, radius, "KD309", f"{told}, the link is {its_length}")
    return None


def _is_way(end: Vector3) -> bool:
    return _SHORTEST_ROD < hypot(*end) < GREATEST_LENGTH


def _rod_verdict(name: str, rod: Rod) -> BodyVerdict | None:
    """Return how a rod lies to the way from the link's joint to its only end."""
    if rod.slender > _SLENDER_ACROSS and rod.is_as_long(_AS_LONG_ACROSS):
        is_square = rod.cosine <= _SQUARE and _NEAR_END < rod.ahead < 1.0 - _NEAR_END
        if is_square or (rod.cosine <= _OBLIQUE and rod.is_beside):
            return _across(name, rod)
    if rod.cosine >= _PARALLEL and rod.is_as_long(_AS_LONG_BEHIND) and not rod.is_between:
        return _behind(name, rod)
    return None


def _across(name: str, rod: Rod) -> BodyVerdict:
    told = f"inertia of '{name}' describes a rod {with_unit(rod.length, 'm')} long across the link"
    told += f", which is {with_unit(rod.way, 'm')} long"
    if rod.is_beside:
        told += f"; its CoM lies {with_unit(rod.beside, 'm')} beside it"
    return BodyVerdict(BodyDoubt.ACROSS, rod.length, "KD313", told)


def _behind(name: str, rod: Rod) -> BodyVerdict:
    """Return the verdict on a CoM that is not between the joints."""
    ahead = rod.ahead * rod.way
    if ahead < 0.0:
        told = f"{with_unit(-ahead, 'm')} behind its joint, though the next one is "
        told += f"{with_unit(rod.way, 'm')} ahead"
    else:
        told = f"{with_unit(ahead - rod.way, 'm')} beyond its next joint"
    return BodyVerdict(BodyDoubt.BEHIND, ahead, "KD511", f"CoM of '{name}' lies {told}")


def _gyration(body: MassDistribution, second_moments: Symmetric) -> float:
    return sqrt(max(sum(second_moments[:3]), 0.0) / body.mass)


def is_as_large(body: MassDistribution, length: float) -> bool:
    """Return whether a body's mass and moments are those of one that has this length, m."""
    radius = sqrt(max(*body.moments[:3], 0.0) / body.mass) if body.mass > 0.0 else 0.0
    return radius >= _RADIUS * length and body.mass >= _LATTICE * length**3
