"""How far the numbers of an inertia may be from what is written.

A number stands for all that round to it. Two kinds of writers must be believed: the one who keeps
as many decimals everywhere, and the one who keeps as many significant digits; both may drop zeros
at the end. So of a group of numbers written together, the finest last digit and the greatest
count of significant digits are taken, and each number is as exact as the coarser of the two allows.

The groups are the vector and the six moments, for what is to be *proved* of the numbers; and the
whole section, for what is *likely* of them: `CoM = (0.0, 0.0, 0.1)` beside `Ix=0.012` is mostly 100
mm, and not anything between 50 and 150.
"""

from collections.abc import Mapping, Sequence
from math import floor, log10
from typing import NamedTuple

from kindsl.rigid.body import MassDistribution
from kindsl.rules.number_writing import significant_digits
from kindsl.semantics.declarations import MOMENTS, Inertia
from kindsl.semantics.expressions import Expression, half_unit

_FEWEST_DIGITS = 2
_GREATEST_WHOLE = 1e15


class Written(NamedTuple):
    """A number as written.

    Attributes:
        text: The text.
        literal: Its value if it is a plain decimal number, else None.
        rounding: How far the value of anything else may be from what is written.
    """

    text: str
    literal: float | None
    rounding: float


def half_widths(inertia: Inertia, values: Mapping[str, float]) -> MassDistribution:
    """Return how far each number of a complete inertia may be from what is written, at most."""
    mass, *others = numbers_written(inertia, values)
    com, moments = others[:3], others[3:]
    return MassDistribution(
        _own_half(mass),
        tuple(_halves(com, com)),  # type: ignore[arg-type]
        tuple(_halves(moments, moments)),  # type: ignore[arg-type]
    )


def likely_half_widths(numbers: Sequence[Written]) -> MassDistribution:
    """Return the same if all ten numbers were written in the same manner."""
    halves = _halves(numbers, numbers[1:])
    return MassDistribution(halves[0], tuple(halves[1:4]), tuple(halves[4:]))  # type: ignore[arg-type]


def numbers_written(inertia: Inertia, values: Mapping[str, float]) -> list[Written]:
    """Return the ten numbers of a complete inertia: mass, centre of mass, moments."""
    assert inertia.mass is not None and inertia.com is not None
    moments = (inertia.moments[name] for name in MOMENTS)
    group = (inertia.mass, *inertia.com.components, *moments)
    return [_written(value, values) for value in group]


def rewritten_number(text: str) -> Written:
    """Return a plain number that is to be written."""
    return Written(text, float(text), half_unit(text))


def _written(value: Expression, values: Mapping[str, float]) -> Written:
    return Written(value.text, value.literal, value.rounding(values))


def _halves(group: Sequence[Written], manner: Sequence[Written]) -> list[float]:
    """Return the half-widths of a group that is written in the manner of some numbers."""
    numbers = [number for number in manner if number.literal]
    finest = min((half_unit(number.text) for number in numbers), default=float("inf"))
    digits = max([_FEWEST_DIGITS, *map(_believed_digits, numbers)])
    return [_half(number, finest, digits) for number in group]


def _half(number: Written, finest: float, digits: int) -> float:
    own = _own_half(number)
    if number.literal is None:
        return own
    if number.literal == 0.0:
        return min(finest, half_unit(number.text))
    by_digits = 0.5 * 10.0 ** (floor(log10(abs(number.literal))) - digits + 1)
    return min(own, max(finest, by_digits))


def _own_half(number: Written) -> float:
    """Return the half-width of a number alone; of `120.0` the digits before its zeros count."""
    whole, unit = _whole(number), 1
    if whole is None:
        return number.rounding
    while whole % 10 == 0 and whole >= 100:
        whole, unit = whole // 10, unit * 10
    return 0.5 * unit


def _believed_digits(number: Written) -> int:
    whole = _whole(number)
    return significant_digits(number.text) if whole is None else len(str(whole).rstrip("0"))


def _whole(number: Written) -> int | None:
    """Return the size of a number whose point is there only because the language wants it."""
    if number.literal is None or not number.text.endswith(".0"):
        return None
    size = abs(number.literal)
    return int(size) if 10.0 <= size < _GREATEST_WHOLE else None
