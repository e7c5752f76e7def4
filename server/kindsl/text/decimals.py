"""Numbers as the document takes them: decimal, with a point, never with an exponent."""

from decimal import Decimal


def exact_decimal(value: float) -> str:
    """Return the shortest decimal number that is read as the same value."""
    return _pointed(f"{Decimal(repr(value)):f}")


def rounded_decimal(value: float, scale: float) -> str:
    """Return a computed number with 15 digits.

    Args:
        value: The number.
        scale: Size of the numbers that it was computed from; what is dust beside it becomes zero.
    """
    if abs(value) <= 4e-16 * scale:
        return "0.0"
    return _pointed(f"{Decimal(f'{value:.15g}'):f}")


def _pointed(text: str) -> str:
    whole, point, decimals = text.partition(".")
    return f"{whole}{point or '.'}{decimals.rstrip('0') or '0'}"
