"""Slips of the hand that make a written triple of the one that was meant."""

from collections.abc import Iterator
from enum import IntEnum
from itertools import permutations
from itertools import product as combinations
from math import degrees, pi, radians

from kindsl.rigid.pose import Rotation, Vector3, angles, pose_from

_NEAR = 0.02
_POWERS = (1000.0, 100.0, 10.0, 0.1, 0.01, 0.001)


class SlipOfHand(IntEnum):
    """Slips, the likeliest first."""

    SIGN = 0
    ZEROED = 1
    DROPPED = 2
    SWAPPED = 3
    UNIT = 4
    DEGREES = 5
    QUARTER_TURN = 6
    DIGIT = 7
    ONE_NUMBER = 8
    OTHER = 9


def slip_between(written: Vector3, meant: Vector3, what: str) -> SlipOfHand:
    """Return the slip that makes a written triple of the meant one.

    Args:
        written: As it is.
        meant: As it should be.
        what: `translation`, `com` or `angles`.
    """
    differing = [i for i in range(3) if not _equal(written[i], meant[i])]
    is_angles = what == "angles"
    if not any(abs(x) > 1e-9 for x in written) and any(abs(x) > 1e-4 for x in meant):
        return SlipOfHand.DROPPED if is_angles else SlipOfHand.ZEROED
    if all(_equal(abs(x), abs(y)) for x, y in zip(written, meant, strict=True)):
        return SlipOfHand.SIGN
    sizes = sorted(map(abs, written)), sorted(map(abs, meant))
    if all(map(_equal, *sizes)):
        return SlipOfHand.SWAPPED
    if any(all(_is_scaled(written[i], meant[i], f) for i in differing) for f in _POWERS):
        return SlipOfHand.UNIT
    if is_angles and all(
        abs(written[i] - degrees(meant[i])) <= 0.02 * abs(written[i]) + 1e-6 for i in differing
    ):
        return SlipOfHand.DEGREES
    if len(differing) != 1:
        return SlipOfHand.OTHER
    here, there = written[differing[0]], meant[differing[0]]
    if is_angles and abs((here - there) / (pi / 4) - round((here - there) / (pi / 4))) < 0.01:
        return SlipOfHand.QUARTER_TURN
    if abs(here) < 1e-9:
        return SlipOfHand.ZEROED
    return SlipOfHand.DIGIT if _is_one_digit(here, there) else SlipOfHand.ONE_NUMBER


def angles_near(rotation: Rotation, own: Vector3, twin: Vector3) -> Vector3:
    """Return angles that make a rotation, in as few changes of those written as can be, radians.

    Args:
        rotation: To be made.
        own: The angles as written.
        twin: Those of the twin.
    """
    fitting = [
        (sum(abs(x - y) > 1e-6 for x, y in zip(option, own, strict=True)), order, option)
        for order, option in enumerate(dict.fromkeys(_candidates(own, twin)))
        if _makes(option, rotation)
    ]
    x, y, z = min(fitting)[2] if fitting else angles(rotation, 1e-6)
    return 0.0 + x, 0.0 + y, 0.0 + z


def _candidates(own: Vector3, twin: Vector3) -> Iterator[Vector3]:
    for base in (own, twin):
        for a, b, c in permutations(base):
            for x, y, z in combinations((1.0, -1.0), repeat=3):
                yield x * a, y * b, z * c
    yield radians(own[0]), radians(own[1]), radians(own[2])
    for index in range(3):
        for value in (0.0, pi / 2, -pi / 2, pi, -pi, twin[index], -twin[index], own[index]):
            for base in (own, twin):
                changed = [*base[:index], value, *base[index + 1 :]]
                yield changed[0], changed[1], changed[2]


def _makes(option: Vector3, rotation: Rotation) -> bool:
    if max(map(abs, option)) > 7.0:
        return False
    made = pose_from((0.0, 0.0, 0.0), option).rotation
    rows = zip(made, rotation, strict=True)
    return all(abs(x - y) < _NEAR for row in rows for x, y in zip(*row, strict=True))


def _equal(here: float, there: float) -> bool:
    return abs(here - there) <= 1e-4 + 0.003 * abs(there)


def _is_scaled(here: float, there: float, power: float) -> bool:
    return abs(abs(here) - power * abs(there)) <= 1e-4 * power + 0.003 * abs(power * there)


def _is_one_digit(here: float, there: float) -> bool:
    """Return whether one digit differs, is missing, or two neighbours are swapped."""
    one, other = sorted((f"{abs(x):.9f}".rstrip("0") for x in (here, there)), key=len)
    if len(one) == len(other):
        at = [i for i in range(len(one)) if one[i] != other[i]]
        is_swap = len(at) == 2 and at[1] == at[0] + 1
        return len(at) <= 1 or (
            is_swap and {*one[at[0] : at[1] + 1]} == {*other[at[0] : at[1] + 1]}
        )
    gaps = range(len(other))
    return len(other) - len(one) == 1 and any(other[:i] + other[i + 1 :] == one for i in gaps)
