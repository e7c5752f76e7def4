"""What may have happened to an inertia that is impossible or implausible.

Hypotheses are tried from the simplest to pairs: products with wrong signs, moments given about the
centre of mass, a factor of a power of ten. The first that makes the body possible and of a
plausible density is named. Signs come before the reference point: a body with wrong signs is often
possible too if it is taken to be given about its CoM, while one that is given about its CoM seldom
becomes possible by other signs (in about 3 of 100 random bodies), and then often a much flatter
one than it is without.
"""

from collections.abc import Iterator
from enum import Enum
from itertools import combinations
from typing import NamedTuple

from kindsl.rigid.body import (
    MassDistribution,
    Symmetric,
    eigensystem,
    is_clearly_positive,
    second_moments_about_com,
    shifted,
)
from kindsl.rules.inertia.judgements import Judgement
from kindsl.rules.inertia.plausibility import (
    density_of,
    is_dense_as_matter,
    is_plainly_dense_as_matter,
)
from kindsl.semantics.declarations import MOMENTS

_PRODUCTS = (3, 4, 5)
_UNITS = (
    (-9, "g·mm²"),
    (-7, "g·cm²"),
    (-6, "kg·mm²"),
    (-4, "kg·cm²"),
    (-3, "g·m²"),
)
_OTHER_POWERS = (-1, 1, -2, 2, 3, 4, 6)
_LEAST_ODD, _GREATEST_ODD = 1.0, 1e5
_BARELY = 0.3


class Slip(Enum):
    """A simple mistake."""

    SIGNS = "signs"
    REFERENCE = "reference"
    SCALE = "scale"


class Cause(NamedTuple):
    """A mistake that explains an inertia, and the numbers without it.

    Attributes:
        slips: What was done wrong, one or two things.
        body: The numbers as they were meant.
        negated: Names of the products whose sign is wrong.
        power: The moments are to be multiplied by ten to this power.
        unit: The unit that explains that, or empty.
    """

    slips: tuple[Slip, ...]
    body: MassDistribution
    negated: tuple[str, ...] = ()
    power: int = 0
    unit: str = ""


def cause_of(found: Judgement) -> Cause | None:
    """Return the simplest mistake that explains an impossible or implausible body, if any does."""
    cause = next((c for c in _hypotheses(found.body) if _is_good(c)), None)
    if cause is not None and cause.slips == (Slip.SIGNS,) and any(found.body.com):
        other = _about_origin(Cause((), found.body))
        if _is_good(other) and _roundness(cause) < _BARELY * _roundness(other):
            return other
    return cause


def _roundness(cause: Cause) -> float:
    """Return the smallest second moment about the CoM by the greatest one."""
    pairs = eigensystem(second_moments_about_com(cause.body))
    return pairs[0].value / pairs[2].value


def _hypotheses(body: MassDistribution) -> Iterator[Cause]:
    signs = list(_with_other_signs(Cause((), body)))
    yield from signs
    has_offset = any(body.com)
    if has_offset:
        yield _about_origin(Cause((), body))
    scales = sorted(_scaled(Cause((), body)), key=_distance_from_plain_units)
    yield from scales
    if has_offset:
        yield from (_about_origin(cause) for cause in signs)
        yield from (_about_origin(cause) for cause in scales)
    for scale in scales:
        yield from _with_other_signs(scale)


def _with_other_signs(cause: Cause) -> Iterator[Cause]:
    """Yield the cause with products negated: all of them first, as in a pasted tensor."""
    present = [index for index in _PRODUCTS if cause.body.moments[index]]
    for count in (len(present), *range(1, len(present))) if present else ():
        for chosen in combinations(present, count):
            moments = tuple(
                -value if index in chosen else value
                for index, value in enumerate(cause.body.moments)
            )
            yield cause._replace(
                slips=(Slip.SIGNS, *cause.slips),
                body=cause.body._replace(moments=moments),  # type: ignore[arg-type]
                negated=tuple(MOMENTS[index] for index in chosen),
            )


def _about_origin(cause: Cause) -> Cause:
    return cause._replace(slips=(Slip.REFERENCE, *cause.slips), body=shifted(cause.body))


def _scaled(cause: Cause) -> Iterator[Cause]:
    for power, unit in (*_UNITS, *((power, "") for power in _OTHER_POWERS)):
        moments: Symmetric = tuple(m * 10.0**power for m in cause.body.moments)  # type: ignore[assignment]
        body = cause.body._replace(moments=moments)
        yield Cause((Slip.SCALE, *cause.slips), body, power=power, unit=unit)


def _distance_from_plain_units(cause: Cause) -> int:
    return 0 if cause.unit else 1


def _is_good(cause: Cause) -> bool:
    """Return whether the body is possible and plausible; a single slip may leave it a bit odd."""
    body = cause.body
    second_moments = second_moments_about_com(body)
    if min(second_moments[:3]) < 0.0:
        return False
    is_positive = is_clearly_positive(second_moments)
    if is_positive and is_plainly_dense_as_matter(body.mass, second_moments):
        return True
    pairs = eigensystem(second_moments)
    if pairs[0].value < 0.0:
        return False
    if cause.slips in ((Slip.SIGNS,), (Slip.REFERENCE,)):
        return _LEAST_ODD < density_of(body.mass, pairs) < _GREATEST_ODD
    return is_dense_as_matter(body.mass, pairs)
