"""The text of a new value: in the author's notation, with as many digits, for both generators."""

from math import isclose, pi
from typing import NamedTuple

from kindsl.language.semantics.expressions import Expression
from kindsl.language.text.decimals import significant_decimal

MOST_DECIMALS = 10
_DIGITS = 15
_PI_KINDS = frozenset(("pi", "juxtaposed_pi"))
_EXACT = 1e-12
_MOST_DIVISOR = 360.0


class ValueText(NamedTuple):
    """A value as text, and what that text is read as."""

    text: str
    value: float


def angle_text(value: float, old: Expression) -> ValueText:
    """Return an angle in radians: a fraction of PI where the old one was one or zero."""
    if old.literal == 0.0 or any(part.kind in _PI_KINDS for part in old.node.walk()):
        return fraction_of_pi(value) or number_text(value, "")
    return number_text(value, old.text)


def exact_angle(value: float) -> str:
    """Return an angle in radians to the last digit: a fraction of PI where it is one."""
    fraction = fraction_of_pi(value)
    return fraction.text if fraction is not None else significant_decimal(value, _DIGITS)


def fraction_of_pi(value: float) -> ValueText | None:
    """Return `PI/2.0` and the like where an angle is exactly that, else None."""
    if abs(value) < _EXACT:
        return ValueText("0.0", 0.0)
    divisor = round(pi / abs(value), 3)
    if not 0.0 < divisor <= _MOST_DIVISOR or not isclose(pi / divisor, abs(value), rel_tol=_EXACT):
        return None
    text = "PI" if divisor == 1.0 else f"PI/{divisor!r}"
    return ValueText(text, pi / divisor) if value > 0.0 else ValueText(f"-{text}", -pi / divisor)


def number_text(value: float, old: str) -> ValueText:
    """Return a number with as many decimals as the old one, or as many more as it takes.

    Zero is `0.0`; no number gets more than ten decimals.
    """
    whole, _, decimals = f"{value:.{MOST_DECIMALS}f}".partition(".")
    if not float(f"{whole}.{decimals}"):
        return ValueText("0.0", 0.0)
    written = old.partition(".")[2]
    least = min(len(written) if written.isdecimal() else 1, MOST_DECIMALS)
    text = f"{whole}.{decimals.rstrip('0').ljust(least, '0')}"
    return ValueText(text, float(text))
