"""Numbers of one file that are the other's, rounded to fewer digits."""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from math import floor, log10
from typing import NamedTuple

from kindsl.robots.comparison.matching import bodies_by_name
from kindsl.robots.comparison.quantities import INERTIA, POSE, TURNS
from kindsl.robots.comparison.side import ComparedSide
from kindsl.robots.comparison.written import WrittenInertia, WrittenNumber, WrittenPose
from kindsl.robots.mechanism.linkage import BodyPart, Linkage

_FLOAT = 2e-7
# Beside half a unit of the last of three digits: rounding to fewer moves a number by over 0.5 %,
# as much as somebody who changes it.
_THREE_DIGITS = 200.0
# One digit is that of any number.
_TWO_DIGITS = 20.0
# Of the halves of last digits: nobody who corrects a number by hand adds two digits to it.
_FINER = 99.0
# An angle less than this is what a program leaves of zero, radians.
NO_ANGLE = 1e-6
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


class Unrounded(NamedTuple):
    """A robot with the numbers of another, where they differ by digits.

    Attributes:
        skeleton: Its bodies.
        names: What these numbers are: `mass of 'upper'`.
    """

    skeleton: Linkage
    names: list[str]


def unrounded(ours: ComparedSide, theirs: ComparedSide) -> Unrounded:
    """Return our robot with their numbers where these have other digits."""
    bodies = bodies_by_name(ours.skeleton, theirs.skeleton)
    digits, names = digits_of_rounding(ours, theirs, bodies), list[str]()

    def values(form: Form, other: Form) -> tuple[float, ...]:
        quantities = INERTIA if isinstance(form, WrittenInertia) else POSE
        found = list(form.values)
        for k, (here, there) in enumerate(zip(form.numbers, other.numbers, strict=True)):
            own, its = form.values[k], other.values[k]
            if own != its and _is_alike(here, there, quantities[k] in TURNS, digits):
                found[k] = its
                names.append(f"{quantities[k]} of '{form.owner}'")
        return tuple(found)

    def part_of(part: BodyPart, body: int) -> BodyPart:
        written, other = ours.frames.get(part.name), theirs.frames.get(part.name)
        if not part.is_link and written is not None and other is not None:
            return part._replace(pose=written.pose(values(written, other)))
        if not part.is_link or part.mass is None:
            return part
        for form, its in zip(ours.inertias[body], theirs.inertias[bodies[body]], strict=False):
            return part._replace(mass=form.body(values(form, its)))
        return part

    made = []
    for body, each in enumerate(ours.skeleton.bodies):
        if body in bodies:
            each = each._replace(parts=tuple(part_of(part, body) for part in each.parts))
        if body and body in bodies:
            joint = ours.joints[body - 1]
            each = each._replace(
                placement=joint.pose(values(joint, theirs.joints[bodies[body] - 1]))
            )
        made.append(each)
    return Unrounded(replace(ours.skeleton, bodies=tuple(made)), names)


def _is_alike(
    here: WrittenNumber | None, there: WrittenNumber | None, is_turn: bool, digits: Digits | None
) -> bool:
    """Return whether two numbers are one, written with other digits."""
    if here is None or there is None:
        return False
    apart = abs(here.value - there.value)
    if is_rounded(here, there, "rad" if is_turn else "") or (is_turn and apart <= NO_ANGLE):
        return True
    coarse, fine = sorted((here, there), key=lambda number: -number.half)
    is_within = digits is not None and apart <= digits.half(coarse.value) * (1.0 + _FLOAT)
    return is_within and _is_rounding(coarse, fine)


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
