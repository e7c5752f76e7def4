"""Numbers as the document takes them: decimal, with a point, never with an exponent."""

from math import floor, log10

_EXACT = 15


def exact_decimal(value: float) -> str:
    """Return the shortest decimal number that is read as the same value."""
    text = repr(value + 0.0)
    return plain_decimal(text) if "e" in text else _short(text)


def plain_decimal(number: str) -> str:
    """Return a decimal number, as `1.50e-3`, without exponent: the same value exactly."""
    # Only what is written with an exponent is worth the time to load this.
    from decimal import Decimal

    return _short(f"{Decimal(number):f}")


def significant_decimal(value: float, digits: int) -> str:
    """Return a finite number with so many significant digits, and at least one decimal."""
    return fixed_decimal(value, digits_after_point(value, digits))


def digits_after_point(value: float, digits: int) -> int:
    """Return how many decimals a number with so many significant digits has, at least one."""
    return max(1, digits - 1 - floor(log10(abs(value)))) if value else 1


def significant_digits(text: str) -> int:
    """Return how many digits a number has from the first that is not zero, at least one."""
    mantissa = text.lower().partition("e")[0]
    return max(1, len("".join(filter(str.isdigit, mantissa)).lstrip("0")))


def rounded_decimal(value: float, scale: float) -> str:
    """Return a computed number with 15 digits.

    Args:
        scale: Size of the numbers that it was computed from; what is dust beside it becomes zero.
    """
    return significant_decimal(value, _EXACT) if abs(value) > 4e-16 * scale else "0.0"


def fixed_decimal(value: float, decimals: int) -> str:
    """Return a number rounded to so many decimals, at least one, without trailing zeros."""
    return _short(f"{value:z.{decimals}f}")


def _short(text: str) -> str:
    whole, point, decimals = text.partition(".")
    return f"{whole}{point or '.'}{decimals.rstrip('0') or '0'}"
