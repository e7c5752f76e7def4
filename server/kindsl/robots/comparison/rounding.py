"""Numbers of one file that are the other's, rounded to fewer digits."""

from collections.abc import Iterator, Mapping
from math import floor, log10
from typing import NamedTuple

from kindsl.robots.comparison.matching import bodies_by_name
from kindsl.robots.comparison.quantities import INERTIA, POSE, TURNS
from kindsl.robots.comparison.side import ComparedSide
from kindsl.robots.comparison.written import WrittenInertia, WrittenNumber, WrittenPose
from kindsl.robots.mechanism.linkage import Linkage

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
        (is_ours, coarse, abs(coarse.value - fine.value) > coarse.slack)
        for is_ours, coarse, fine in pairs
        if coarse.value != fine.value
        and abs(coarse.value) >= _TWO_DIGITS * coarse.half
        and _is_rounding(coarse, fine)
    ]
    sides = {is_ours for is_ours, _, is_seen in roundings if is_seen}
    found = [
        (-log10(2.0 * coarse.half), floor(log10(abs(coarse.value))))
        for is_ours, coarse, _ in roundings
        if is_ours in sides
    ]
    if len(sides) != 1 or len(found) < _BY_CHANCE:
        return None
    return Digits(round(max(d + lead for d, lead in found)) + 1, round(max(d for d, _ in found)))


def unrounded(ours: ComparedSide, theirs: ComparedSide) -> tuple[Linkage, list[str]]:
    """Return our robot with their numbers where digits alone differ, and what these numbers are.

    Both are documents' robots, matched by name: a body's mass is written in one inertia.
    """
    bodies = bodies_by_name(ours.skeleton, theirs.skeleton)
    digits, names = digits_of_rounding(ours, theirs, bodies), list[str]()

    def values(form: Form, other: Form) -> tuple[float, ...]:
        quantities = INERTIA if isinstance(form, WrittenInertia) else POSE
        columns = zip(
            quantities, form.values, other.values, form.numbers, other.numbers, strict=True
        )
        found = []
        for quantity, own, its, here, there in columns:
            # Angles within the digits of one meant are equal already, however they are written.
            is_other = _is_alike(here, there, quantity in TURNS, digits) or own == its
            found.append(its if is_other else own)
            if is_other and here and there and here.value != there.value:
                names.append(f"{quantity} of '{form.owner}'")
        return tuple(found)

    masses, poses = list(ours.skeleton.masses), list(ours.skeleton.placements)
    for body, its in bodies.items():
        for form, other in zip(ours.inertias[body], theirs.inertias[its], strict=False):
            masses[body] = form.body(values(form, other))
        if body:
            joint = ours.joints[body - 1]
            poses[body - 1] = joint.pose(values(joint, theirs.joints[its - 1]))
    frames = {
        name: frame.pose(values(frame, theirs.frames[name]))
        for name, frame in ours.frames.items()
        if name in theirs.frames
    }
    same = ours.skeleton.with_masses(masses).with_placements(poses).with_frames(frames)
    return (same if ours.skeleton.is_floating else same.without_mass_at_rest()), names


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
    forms = [
        # Moments about other points are other numbers; a mass and its centre are the same.
        (one.numbers, other.numbers[: None if one.is_about_com == other.is_about_com else 4])
        for one, other in zip(ours.inertias[body], theirs.inertias[its], strict=False)
    ]
    if body:
        forms.append((ours.joints[body - 1].numbers, theirs.joints[its - 1].numbers))
    for form, other in forms:
        for here, there in zip(form, other, strict=False):
            if here is not None and there is not None:
                is_ours = here.half >= there.half
                yield is_ours, *((here, there) if is_ours else (there, here))


def _is_rounding(coarse: WrittenNumber, fine: WrittenNumber) -> bool:
    is_near = abs(coarse.value - fine.value) <= coarse.half * (1.0 + _FLOAT)
    return is_near and not coarse.is_implied and coarse.half > fine.half
