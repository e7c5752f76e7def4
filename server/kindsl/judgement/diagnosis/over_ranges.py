"""Possibility of an inertia everywhere in its parameters' ranges, with proof.

The pseudo-inertia, which has `m`, `m c` and the second moments for entries, is positive definite
for possible bodies alone, and its smallest eigenvalue is a concave function of these entries. Where
each entry is affine in each parameter alone, that eigenvalue is concave along each parameter, so
that it is smallest at a corner: the corners decide. Elsewhere the ranges are halved until interval
bounds prove each part, or a number of steps is used up.

Source: Wensing, Kim, Slotine 2018; Moore, Kearfott, Cloud 2009, Introduction to interval analysis.
"""

from collections.abc import Iterator, Mapping
from enum import Enum
from itertools import product
from typing import NamedTuple

from kindsl.judgement.diagnosis.digits import likely_half_widths, numbers_written
from kindsl.judgement.diagnosis.judgements import IMPOSSIBLE, verdict_of
from kindsl.language.semantics.declarations import Inertia
from kindsl.language.semantics.expressions import Values
from kindsl.language.semantics.numbers import mass_distribution
from kindsl.language.semantics.ranges import (
    Interval,
    bounds_of,
    degrees_of,
    difference_of,
    product_degrees,
    product_of,
    sum_of,
)
from kindsl.language.semantics.unknown import inertia_expressions
from kindsl.mechanics.rigid.body import eigensystem, second_moments_about_com

_MOST_AT_CORNERS = 12
_MOST_PARTS = 2000

Ranges = Mapping[str, Interval]


class Conclusion(Enum):
    """The conclusion on an inertia over ranges."""

    POSSIBLE = "possible everywhere"
    IMPOSSIBLE = "impossible somewhere"
    UNDECIDED = "not decided"


class Proof(NamedTuple):
    """The result of a proof, and the places where the inertia is impossible."""

    outcome: Conclusion
    where: Values | None = None


def is_possible(inertia: Inertia, values: Values) -> bool:
    """Return whether some body has the numbers within their digits; True where one is unbound."""
    body = mass_distribution(inertia, values)
    if body is None:
        return True
    if body.mass <= 0.0:
        return False
    half = likely_half_widths(numbers_written(inertia, values))
    return verdict_of(body, half, eigensystem(second_moments_about_com(body))) not in IMPOSSIBLE


def over_ranges(inertia: Inertia, ranges: Ranges, values: Values) -> Proof:
    """Return whether an inertia is possible in all of its ranges.

    Args:
        inertia: Complete.
        ranges: Least and greatest value of each parameter that varies.
        values: Of all parameters by name, and of constants by `<name>`.
    """
    if len(ranges) <= _MOST_AT_CORNERS:
        wrong = next(
            (c for c in _corners(ranges) if not is_possible(inertia, {**values, **c})), None
        )
        if wrong is not None:
            return Proof(Conclusion.IMPOSSIBLE, {name: wrong[name] for name in ranges})
        if _is_affine(inertia, frozenset(ranges)):
            return Proof(Conclusion.POSSIBLE)
    return _by_halving(inertia, ranges, values)


def _corners(ranges: Ranges) -> Iterator[Values]:
    for corner in product(*ranges.values()):
        yield dict(zip(ranges, corner, strict=True))


def _is_affine(inertia: Inertia, names: frozenset[str]) -> bool:
    """Return whether mass, first and second moments are affine in each parameter alone."""
    found = [degrees_of(value, names) for value in inertia_expressions(inertia)]
    written = [degrees for degrees in found if degrees is not None]
    if len(written) < len(found):
        return False
    mass, *others = written
    known = [mass, *(product_degrees(mass, degrees) for degrees in others[:3]), *others[3:]]
    return all(d <= 1 for degrees in known for d in degrees.values())


def _by_halving(inertia: Inertia, ranges: Ranges, values: Values) -> Proof:
    pending = [dict(ranges)]
    for _ in range(_MOST_PARTS):
        if not pending:
            return Proof(Conclusion.POSSIBLE)
        part = pending.pop()
        middle = {name: 0.5 * (low + high) for name, (low, high) in part.items()}
        if not is_possible(inertia, {**values, **middle}):
            return Proof(Conclusion.IMPOSSIBLE, middle)
        if not _is_proved(inertia, part, values):
            pending += _halves(part, ranges)
    return Proof(Conclusion.UNDECIDED)


def _halves(part: dict[str, Interval], ranges: Ranges) -> list[dict[str, Interval]]:
    def share(name: str) -> float:
        whole = ranges[name][1] - ranges[name][0]
        return (part[name][1] - part[name][0]) / whole if whole else 0.0

    name = max(part, key=share)
    low, high = part[name]
    middle = 0.5 * (low + high)
    return [{**part, name: (low, middle)}, {**part, name: (middle, high)}]


def _is_proved(inertia: Inertia, part: Ranges, values: Values) -> bool:
    """Return whether interval bounds prove an inertia possible in a part of the ranges."""
    known = {**{name: (value, value) for name, value in values.items()}, **part}
    bounds = [bounds_of(value, known) for value in inertia_expressions(inertia)]
    found = [bound for bound in bounds if bound is not None]
    if len(found) < 10 or found[0][0] <= 0.0:
        return False
    mass, com, moments = found[0], found[1:4], found[4:]
    entries = _second_moments(mass, com, moments)
    middle = tuple(0.5 * (low + high) for low, high in entries)
    xx, yy, zz, xy, xz, yz = (0.5 * (high - low) for low, high in entries)
    # No eigenvalue moves by more than the greatest row sum of the radii.
    spread = max(xx + xy + xz, xy + yy + yz, xz + yz + zz)
    return eigensystem(middle)[0].value >= spread  # type: ignore[arg-type]


def _second_moments(mass: Interval, com: list[Interval], moments: list[Interval]) -> list[Interval]:
    """Return bounds of the six second moments about the CoM."""
    (ix, iy, iz), products = moments[:3], moments[3:]
    diagonal = [
        difference_of(sum_of(iy, iz), ix),
        difference_of(sum_of(ix, iz), iy),
        difference_of(sum_of(ix, iy), iz),
    ]
    found = []
    for half, c in zip(diagonal, com, strict=True):
        found.append(difference_of((0.5 * half[0], 0.5 * half[1]), product_of(mass, _square(c))))
    for moment, (i, j) in zip(products, ((0, 1), (0, 2), (1, 2)), strict=True):
        found.append(difference_of(moment, product_of(mass, product_of(com[i], com[j]))))
    return found


def _square(a: Interval) -> Interval:
    squares = a[0] * a[0], a[1] * a[1]
    return (0.0 if a[0] <= 0.0 <= a[1] else min(squares)), max(squares)
