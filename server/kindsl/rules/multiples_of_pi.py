"""Angles as fractions of pi that both generators read."""

from math import pi

_DIVISORS = ("", "2.0", "4.0", "3.0", "6.0", "1.5", "0.5", "8.0", "12.0")


def as_fraction_of_pi(angle: float, tolerance: float) -> str | None:
    """Return `PI/2.0` and the like for an angle that close to it in radians, else None."""
    for divisor in _DIVISORS:
        value = pi / float(divisor or 1.0)
        if abs(abs(angle) - value) <= tolerance:
            sign = "-" if angle < 0.0 else ""
            return f"{sign}PI/{divisor}" if divisor else f"{sign}PI"
    return None
