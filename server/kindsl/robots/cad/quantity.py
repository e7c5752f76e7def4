"""A printed number with its unit: its value in SI units, exactly, and how far it may be rounded."""

from decimal import Context, Decimal, Inexact, localcontext
from fractions import Fraction
from typing import NamedTuple

_MOST_DIGITS = 28
_ROUNDED_DIGITS = 17


class Quantity(NamedTuple):
    """A number of a report.

    Attributes:
        name: The report's name for it, as `Ixy`.
        printed: The number as printed, with a decimal point.
        half: Half a unit of its last digit, before the unit's factor.
        factor: SI units in its unit.
    """

    name: str
    printed: Decimal
    half: Fraction
    factor: Fraction = Fraction(1)

    @property
    def value(self) -> Fraction:
        """The value in SI units."""
        return Fraction(self.printed) * self.factor

    @property
    def error(self) -> Fraction:
        """The greatest distance of the value from the one before rounding, in SI units."""
        return self.half * self.factor

    @property
    def bounds(self) -> "Rounded":
        """The value with its error."""
        return Rounded(self.value, self.error)

    @property
    def n_digits(self) -> int:
        """The number of significant digits, none of zero."""
        return len(self.printed.as_tuple().digits) if self.printed else 0

    def text(self, sign: int = 1) -> str:
        """Return the value as the document takes it, its digits kept, exactly if that is short."""
        power = _power_of_ten(self.factor)
        if power is not None:
            return positional(sign * self.printed.scaleb(power))
        return decimal_text(sign * self.value)


class Rounded(NamedTuple):
    """A value that is known up to an error."""

    value: Fraction
    error: Fraction

    def __add__(self, other: "Rounded") -> "Rounded":  # type: ignore[override]
        """Return the sum."""
        return Rounded(self.value + other.value, self.error + other.error)

    def __sub__(self, other: "Rounded") -> "Rounded":
        """Return the difference."""
        return Rounded(self.value - other.value, self.error + other.error)

    def __mul__(self, other: "Rounded") -> "Rounded":  # type: ignore[override]
        """Return the product."""
        error = abs(self.value) * other.error + abs(other.value) * self.error
        return Rounded(self.value * other.value, error + self.error * other.error)

    def times(self, sign: int) -> "Rounded":
        """Return the value with a sign."""
        return Rounded(sign * self.value, self.error)

    def agrees_with(self, other: "Rounded") -> bool:
        """Return whether both may be the same number."""
        difference = abs(self.value - other.value)
        return difference <= (self.error + other.error) * Fraction(1_000_001, 1_000_000)

    def text(self, sign: int = 1) -> str:
        """Return a computed value with the digits that its error leaves."""
        if not self.error:
            return decimal_text(sign * self.value)
        power = 0
        while Fraction(10) ** power > 2 * self.error:
            power -= 1
        return positional(Decimal(round(sign * self.value * 10**-power)).scaleb(power))


def decimal_text(value: Fraction) -> str:
    """Return a value exactly if that takes 28 digits at most, else with 17."""
    for digits in (_MOST_DIGITS, _ROUNDED_DIGITS):
        with localcontext(Context(prec=digits)) as context:
            number = Decimal(value.numerator) / Decimal(value.denominator)
            if not context.flags[Inexact]:
                break
    return positional(number.normalize())


def _power_of_ten(factor: Fraction) -> int | None:
    whole = max(factor.numerator, factor.denominator)
    power = len(str(whole)) - 1
    if min(factor.numerator, factor.denominator) != 1 or whole != 10**power:
        return None
    return power if factor.numerator == whole else -power


def positional(number: Decimal) -> str:
    """Return a number without exponent and with a point; zero as `0.0`."""
    if not number:
        return "0.0"
    text = format(number, "f")
    return text if "." in text else f"{text}.0"
