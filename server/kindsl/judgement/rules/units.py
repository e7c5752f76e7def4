"""Units behind numbers: the language reads them as parameters that multiply.

`2.275kg` is the product of 2.275 and a parameter `kg`. Both generators accept it and ask for the
value of `kg` at run time.
"""

from bisect import bisect_left
from typing import NamedTuple

from kindsl.language.semantics.expressions import Values
from kindsl.language.semantics.parameters import Parameter
from kindsl.language.semantics.places import Name, Place
from kindsl.language.syntax.values import in_radians
from kindsl.language.text.decimals import significant_decimal

# What lengths are given in instead of metres: the name, and the factor.
LENGTH_UNITS = {"mm": ("millimetres", 1e-3), "cm": ("centimetres", 1e-2), "in": ("inches", 0.0254)}
_SI = {"kg": 1.0, "m": 1.0, "rad": 1.0, "g": 1e-3, "mm": 1e-3, "cm": 1e-2}
_DEGREES = ("deg", "degrees")
# These may well be the names of a mass or of gravity, unless they touch the number.
_SHORT = ("m", "g")
_DIGITS = 15


class NumberWithUnit(NamedTuple):
    """A number with a unit behind it.

    Attributes:
        place: Of both.
        in_si: The number in metres, kilograms or radians.
    """

    place: Place
    text: str
    number: str
    in_si: str


def numbers_with_unit(parameter: Parameter, values: Values) -> tuple[NumberWithUnit, ...]:
    """Return the numbers behind which a parameter stands as a unit.

    Args:
        parameter: Nothing is returned unless all its places are behind numbers.
        values: Of the bound parameters; one that has a value is no slip.
    """
    name = str(parameter.name)
    if name in values or name not in (*_SI, *_DEGREES):
        return ()
    found = [number for use in parameter.uses if (number := _found(use.name)) is not None]
    return tuple(found) if len(found) == len(parameter.uses) else ()


def is_unit(name: Name, values: Values) -> bool:
    """Return whether a parameter without a value stands as the unit of the number before it."""
    return name not in values and name in (*_SI, *_DEGREES) and _found(name) is not None


def _found(unit: Name) -> NumberWithUnit | None:
    tokens = unit.island.tokens
    index = bisect_left(tokens, unit.start, key=lambda token: token.start)
    number = tokens[index - 1]
    if number.kind != "FLOAT":
        return None
    if unit in _SHORT and number.end < unit.start:
        return None
    place = Place(unit.island, number.start, unit.end)
    written = unit.island.text[number.start : unit.end]
    return NumberWithUnit(place, written, number.text, _in_si(number.text, str(unit)))


def _in_si(number: str, unit: str) -> str:
    if unit in _DEGREES:
        return in_radians(number) if float(number) else number
    factor = _SI[unit]
    return number if factor == 1.0 else significant_decimal(float(number) * factor, _DIGITS)
