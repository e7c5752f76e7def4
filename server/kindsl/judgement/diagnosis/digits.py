"""The distance that numbers of an inertia may have from their digits.

What is to be *proved* believes nothing of a writer but his digits: each number, by itself, stands
for all that are rounded to it or cut off to it. That holds for the numbers in an expression and for
the values of parameters, too.

What is *likely* looks at the whole section, of moments at the moments, which may be from another
source than the centre of mass and have fewer digits. Two kinds of writers are believed: the one who
keeps as many decimals everywhere, and the one who keeps as many significant digits; both may drop
zeros at the end. So the finest last digit and the greatest count of significant digits are taken,
and each number is as exact as the coarser of the two allows: `CoM = (0.0, 0.0, 0.1)` beside
`Ix=0.012` is mostly 100 mm, and not anything between 50 and 150. A number of many digits is no
round one, and has dropped no zeros.
"""

from collections.abc import Iterator, Mapping, Sequence
from math import floor, inf, log10
from typing import NamedTuple

from kindsl.language.semantics.declarations import Inertia
from kindsl.language.semantics.expressions import Expression, Values, half_unit
from kindsl.language.semantics.ranges import Interval, bounds_of
from kindsl.language.semantics.unknown import inertia_expressions
from kindsl.language.text.decimals import significant_digits
from kindsl.mechanics.rigid.body import MassDistribution

_FEWEST_DIGITS = 2
_MOST_OF_A_ROUND_NUMBER = 3
_GREATEST_WHOLE = 1e15


class WrittenDigits(NamedTuple):
    """A number as written.

    Attributes:
        literal: Its value if it is a plain decimal number, else None.
        rounding: Half a unit of its last digit, or how far the value of anything else may be from
            what is written.
    """

    text: str
    literal: float | None
    rounding: float


class Bounds(NamedTuple):
    """All bodies whose numbers are within intervals.

    Attributes:
        middle: Of each interval.
        half: Half of the width of each.
    """

    middle: MassDistribution
    half: MassDistribution


def bounds_by_digits(inertia: Inertia, known: Mapping[str, Interval]) -> Bounds | None:
    """Return within which bounds the numbers of a complete inertia are, whoever wrote them.

    Args:
        inertia: Complete.
        known: Bounds of parameters by name, and of constants by `<name>`.
    """
    found = [bounds_of(value, known, all_written_as) for value in inertia_expressions(inertia)]
    bounds = [each for each in found if each is not None]
    if len(bounds) < len(found):
        return None
    middle = MassDistribution.of(0.5 * (low + high) for low, high in bounds)
    return Bounds(middle, MassDistribution.of(0.5 * (high - low) for low, high in bounds))


def all_written_as(text: str) -> Interval:
    """Return bounds of all numbers that are written so when they are rounded, or cut off."""
    value, half = float(text), _own_half(text)
    if value == 0.0:
        return -2.0 * half, 2.0 * half
    near, far = abs(value) - half, abs(value) + 2.0 * half
    return (near, far) if value > 0.0 else (-far, -near)


def likely_half_widths(numbers: Sequence[WrittenDigits]) -> MassDistribution:
    """Return how far ten numbers are likely to be from their digits."""
    groups = (numbers[:4], numbers[1:]), (numbers[4:], numbers[4:])
    return MassDistribution.of(half for group, like in groups for half in _halves(group, like))


def _halves(numbers: Sequence[WrittenDigits], like: Sequence[WrittenDigits]) -> Iterator[float]:
    """Yield how far numbers are likely to be, written in the manner of others."""
    manner = [number for number in like if number.literal]
    finest = min((number.rounding for number in manner), default=inf)
    digits = max([_FEWEST_DIGITS, *map(_believed_digits, manner)])
    return (_half(number, finest, digits) for number in numbers)


def numbers_written(inertia: Inertia, values: Values) -> list[WrittenDigits]:
    """Return the ten numbers of a complete inertia: mass, centre of mass, moments."""
    return [_digits_of(value, values) for value in inertia_expressions(inertia)]


def rewritten_number(text: str) -> WrittenDigits:
    """Return a plain number that is to be written."""
    return WrittenDigits(text, float(text), half_unit(text))


def _digits_of(value: Expression, values: Values) -> WrittenDigits:
    text, literal = value.text, value.literal
    rounding = value.rounding(values) if literal is None else half_unit(text)
    return WrittenDigits(text, literal, rounding)


def _half(number: WrittenDigits, finest: float, digits: int) -> float:
    if number.literal is None:
        return number.rounding
    if number.literal == 0.0:
        return min(finest, number.rounding)
    own = _own_half(number.text)
    if _believed_digits(number) > _MOST_OF_A_ROUND_NUMBER:
        return own
    by_digits = 0.5 * 10.0 ** (floor(log10(abs(number.literal))) - digits + 1)
    return min(own, max(finest, by_digits))


def _own_half(text: str) -> float:
    """Return half a unit of the last digit; of `120.0` the digits before its zeros count."""
    whole, unit = _whole(text), 1
    if whole is None:
        return half_unit(text)
    while whole % 10 == 0 and whole >= 100:
        whole, unit = whole // 10, unit * 10
    return 0.5 * unit


def _believed_digits(number: WrittenDigits) -> int:
    whole = _whole(number.text)
    return significant_digits(number.text) if whole is None else len(str(whole).rstrip("0"))


def _whole(text: str) -> int | None:
    """Return the size of a number whose point is there only because the language wants it."""
    size = abs(float(text)) if text.endswith(".0") else 0.0
    return int(size) if 10.0 <= size < _GREATEST_WHOLE else None
