"""Numbers of one file that are the other's, rounded to fewer digits."""

from collections.abc import Iterator, Mapping
from math import floor, log10
from typing import NamedTuple

from kindsl.robots.comparison.side import ComparedSide
from kindsl.robots.comparison.written import WrittenInertia, WrittenNumber, WrittenPose

_FLOAT = 2e-7
# Beside half a unit of the last of three digits: rounding to fewer moves a number by over 0.5 %,
# as much as somebody who changes it.
_THREE_DIGITS = 200.0
# One digit is that of any number.
_TWO_DIGITS = 20.0
# Of the halves of last digits: nobody who corrects a number by hand adds two digits to it.
_FINER = 99.0
# So many numbers that a person changed are not all roundings of the old ones by chance.
_BY_CHANCE = 3

Form = WrittenInertia | WrittenPose


class Digits(NamedTuple):
    """The greatest numbers of digits in a file whose numbers are rounded."""

    significant: int
    decimals: int

    def half(self, value: float) -> float:
        """Return how far a value may be rounded: zeros at its end are not written."""
        lead = floor(log10(abs(value))) if value else -self.decimals
        return 0.5 * 10.0 ** max(lead + 1 - self.significant, -self.decimals)


def is_rounded(here: WrittenNumber | None, there: WrittenNumber | None, unit: str) -> bool:
    """Return whether one file has the other's number, rounded to three digits or more."""
    if here is None or there is None:
        return False
    coarse, fine = sorted((here, there), key=lambda number: -number.half)
    if not _is_rounding(coarse, fine):
        return False
    is_finer = fine.half > 0.0 or unit == "rad"
    is_much_finer = is_finer and coarse.half >= _FINER * fine.half
    return is_much_finer and abs(coarse.value) >= _THREE_DIGITS * coarse.half


def digits_of_rounding(
    ours: ComparedSide, theirs: ComparedSide, bodies: Mapping[int, int]
) -> Digits | None:
    """Return the digits of a file that has numbers of the other, rounded; None if neither has."""
    pairs = [
        pair for body, its in bodies.items() for pair in _number_pairs(ours, theirs, body, its)
    ]
    roundings = [
        (is_ours, coarse)
        for is_ours, coarse, fine in pairs
        if abs(coarse.value - fine.value) > coarse.slack
        and abs(coarse.value) >= _TWO_DIGITS * coarse.half
        and _is_rounding(coarse, fine)
    ]
    if len(roundings) < _BY_CHANCE or len({is_ours for is_ours, _ in roundings}) > 1:
        return None
    found = [
        (-log10(2.0 * coarse.half), floor(log10(abs(coarse.value)))) for _, coarse in roundings
    ]
    return Digits(round(max(d + lead for d, lead in found)) + 1, round(max(d for d, _ in found)))


def _number_pairs(
    ours: ComparedSide, theirs: ComparedSide, body: int, its: int
) -> Iterator[tuple[bool, WrittenNumber, WrittenNumber]]:
    """Yield the numbers of a body that both files write, the one of fewer digits first."""
    parts = zip(ours.inertias[body], theirs.inertias[its], strict=False)
    forms: list[tuple[Form, Form]] = [p for p in parts if p[0].is_about_com == p[1].is_about_com]
    if body:
        forms.append((ours.joints[body - 1], theirs.joints[its - 1]))
    for form, other in forms:
        for here, there in zip(form.numbers, other.numbers, strict=True):
            if here is not None and there is not None:
                is_ours = here.half >= there.half
                yield is_ours, *((here, there) if is_ours else (there, here))


def _is_rounding(coarse: WrittenNumber, fine: WrittenNumber) -> bool:
    is_near = abs(coarse.value - fine.value) <= coarse.half * (1.0 + _FLOAT)
    return is_near and coarse.value != 0.0 and not coarse.is_implied and coarse.half > fine.half
