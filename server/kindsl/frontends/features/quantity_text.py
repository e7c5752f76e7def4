"""Numbers for people: four significant digits, SI units, angles in degrees too."""

from collections.abc import Iterable
from math import degrees
from typing import assert_never

from kindsl.language.syntax.tables import ValueKind

METRES = "m"
RADIANS = "rad"
KILOGRAMS = "kg"
INERTIA = "kg·m²"


def number(value: float, digits: int = 4) -> str:
    """Return a number with so many significant digits."""
    # Zero is added to take the sign off -0.0.
    return f"{value + 0.0:.{digits}g}"


def vector(values: Iterable[float]) -> str:
    """Return numbers in parentheses; what is small beside the largest by rounding alone is 0."""
    components = tuple(values)
    largest = max(map(abs, components))
    return f"({', '.join(number(_without_dust(v, largest)) for v in components)})"


def angle(value: float) -> str:
    """Return an angle given in radians, in degrees."""
    return f"{number(degrees(value))}°"


def quantity(value: float, kind: ValueKind, unit: str = "") -> str:
    """Return a value with its unit; an angle in radians and degrees.

    Args:
        value: In SI units.
        kind: The class of the place where it stands.
        unit: The unit of a dynamics value, which its class does not tell.
    """
    match kind:
        case ValueKind.ANGLE:
            return f"{number(value)} rad = {angle(value)}"
        case ValueKind.LENGTH:
            return f"{number(value)} {METRES}"
        case ValueKind.DYNAMICS:
            return f"{number(value)} {unit}".rstrip()
        case _:
            assert_never(kind)


def _without_dust(value: float, largest: float) -> float:
    return 0.0 if abs(value) < 1e-12 * max(largest, 1e-3) else value
