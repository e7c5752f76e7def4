"""How far the numbers of an inertia may be from what is written.

A number stands for all that round to it. Two kinds of writers must be believed: the one who keeps
as many decimals everywhere, and the one who keeps as many significant digits; both may drop zeros
at the end. So of a group of numbers written together, the finest last digit and the greatest
count of significant digits are taken, and each number is as exact as the coarser of the two allows.

The groups are the vector and the six moments, for what is to be *proved* of the numbers; and the
whole section, for what is *likely* of them: `CoM = (0.0, 0.0, 0.1)` beside `Ix=0.012` is mostly 100
mm, and not anything between 50 and 150.
"""

from collections.abc import Callable, Mapping, Sequence
from math import floor, log10

from kindsl.rigid.body import MassDistribution
from kindsl.rules.number_writing import significant_digits
from kindsl.semantics.declarations import MOMENTS, Inertia
from kindsl.semantics.expressions import Expression, half_unit

Widths = Callable[[Inertia, Mapping[str, float]], MassDistribution]

_FEWEST_DIGITS = 2
_GREATEST_WHOLE = 1e15


def half_widths(inertia: Inertia, values: Mapping[str, float]) -> MassDistribution:
    """Return how far each number of a complete inertia may be from what is written, at most."""
    mass, com, moments = _groups(inertia)
    return MassDistribution(
        _own_half(mass, values),
        tuple(_halves(com, com, values)),  # type: ignore[arg-type]
        tuple(_halves(moments, moments, values)),  # type: ignore[arg-type]
    )


def likely_half_widths(inertia: Inertia, values: Mapping[str, float]) -> MassDistribution:
    """Return the same if all numbers were written in the same manner."""
    mass, com, moments = _groups(inertia)
    halves = _halves([mass, *com, *moments], [*com, *moments], values)
    return MassDistribution(halves[0], tuple(halves[1:4]), tuple(halves[4:]))  # type: ignore[arg-type]


def _groups(inertia: Inertia) -> tuple[Expression, Sequence[Expression], Sequence[Expression]]:
    assert inertia.mass is not None and inertia.com is not None
    return inertia.mass, inertia.com.components, [inertia.moments[name] for name in MOMENTS]


def _halves(
    group: Sequence[Expression], manner: Sequence[Expression], values: Mapping[str, float]
) -> list[float]:
    """Return the half-widths of a group that is written in the manner of some numbers."""
    numbers = [value for value in manner if value.literal]
    finest = min((half_unit(value.text) for value in numbers), default=float("inf"))
    digits = max(map(_believed_digits, numbers), default=0)
    return [_half(value, finest, max(digits, _FEWEST_DIGITS), values) for value in group]


def _half(value: Expression, finest: float, digits: int, values: Mapping[str, float]) -> float:
    own = _own_half(value, values)
    if value.literal is None:
        return own
    if value.literal == 0.0:
        return min(finest, half_unit(value.text))
    by_digits = 0.5 * 10.0 ** (floor(log10(abs(value.literal))) - digits + 1)
    return min(own, max(finest, by_digits))


def _own_half(value: Expression, values: Mapping[str, float]) -> float:
    """Return the half-width of a number alone; of `120.0` only the digits before its zeros count."""
    if value.literal is None or not _is_whole(value):
        return value.rounding(values)
    whole, unit = int(abs(value.literal)), 1
    while whole % 10 == 0 and whole >= 100:
        whole, unit = whole // 10, unit * 10
    return 0.5 * unit


def _believed_digits(value: Expression) -> int:
    if not _is_whole(value):
        return significant_digits(value.text)
    return len(str(int(abs(value.literal or 0.0))).rstrip("0"))


def _is_whole(value: Expression) -> bool:
    """Return whether the point stands there only because the language wants it."""
    is_whole = value.literal is not None and 10.0 <= abs(value.literal) < _GREATEST_WHOLE
    return is_whole and value.text.endswith(".0")
