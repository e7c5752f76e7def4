"""Units as reports write them: `grams * square millimeters`, `lbmass in^2`, `TONNE / MM^3`."""

import re
from fractions import Fraction
from typing import NamedTuple

Dimension = tuple[int, int, int]
MASS: Dimension = (1, 0, 0)
LENGTH: Dimension = (0, 1, 0)
INERTIA: Dimension = (1, 2, 0)
DENSITY: Dimension = (1, -3, 0)
VOLUME: Dimension = (0, 3, 0)

_POUND = Fraction("0.45359237")
_FOOT = Fraction("0.3048")
_POUND_FORCE = _POUND * Fraction("9.80665")


class Unit(NamedTuple):
    """A unit.

    Attributes:
        factor: How many SI units it is, exactly.
        dimension: Its powers of kilogram, metre and second.
    """

    factor: Fraction
    dimension: Dimension


def _named(names: str, factor: Fraction | str, dimension: Dimension) -> dict[str, Unit]:
    return {name: Unit(Fraction(factor), dimension) for name in names.split()}


_NAMES = {
    **_named("g gr gram grams gramme grammes", "0.001", MASS),
    **_named("kg kgs kilo kilogram kilograms kilogramme kilogrammes", "1", MASS),
    **_named("mg milligram milligrams", "0.000001", MASS),
    **_named("t tonne tonnes metric_ton metric_tons", "1000", MASS),
    **_named("lb lbs lbm pound pounds lbmass lb_m poundmass pound_mass", _POUND, MASS),
    **_named("oz ounce ounces ozm ouncemass", _POUND / 16, MASS),
    **_named("slug slugs", _POUND_FORCE / _FOOT, MASS),
    **_named("slinch slinches blob snail", _POUND_FORCE / _FOOT * 12, MASS),
    **_named("um micron microns micrometer micrometers micrometre micrometres", "0.000001", LENGTH),
    **_named("mm millimeter millimeters millimetre millimetres", "0.001", LENGTH),
    **_named("cm centimeter centimeters centimetre centimetres", "0.01", LENGTH),
    **_named("dm decimeter decimeters decimetre decimetres", "0.1", LENGTH),
    **_named("m meter meters metre metres", "1", LENGTH),
    **_named("in ins inch inches", _FOOT / 12, LENGTH),
    **_named("ft foot feet", _FOOT, LENGTH),
    **_named("yd yard yards", _FOOT * 3, LENGTH),
    **_named("s sec second seconds", "1", (0, 0, 1)),
    **_named("n newton newtons", "1", (1, 1, -2)),
    **_named("lbf lb_f poundforce pound_force", _POUND_FORCE, (1, 1, -2)),
}
_POWERS = {"square": 2, "squared": 2, "sq": 2, "cubic": 3, "cubed": 3, "cu": 3}
_PLAIN = str.maketrans("²³·⋅×µμ", "23***uu")
_PART = re.compile(
    r"(?P<slash>/|\bper\b)|(?P<name>[a-z_]+)(?:\^|\*\*)?(?P<power>(?:-?[1-9])?)(?!\d)"
)
_BETWEEN = re.compile(r"[\s*.()\[\]-]*")


def unit(text: str) -> Unit | None:
    """Return the unit that a text is, None where it is none."""
    plain = text.casefold().translate(_PLAIN).replace("metric ton", "metric_ton")
    factor, powers, position, sign, pending = Fraction(1), [0, 0, 0], 0, 1, 0
    is_empty = True
    while position < len(plain):
        position = _skipped(plain, position)
        if position == len(plain):
            break
        part = _PART.match(plain, position)
        if part is None:
            return None
        position = part.end()
        if part["slash"]:
            sign = -1
        elif part["name"] == "x":
            continue
        elif part["name"] in _POWERS:
            pending = _POWERS[part["name"]]
        elif part["name"] in _NAMES:
            one, power = _NAMES[part["name"]], sign * (pending or int(part["power"] or 1))
            factor *= one.factor**power
            powers = [old + power * new for old, new in zip(powers, one.dimension, strict=True)]
            pending, is_empty = 0, False
        else:
            return None
    return None if is_empty or pending else Unit(factor, (powers[0], powers[1], powers[2]))


def _skipped(text: str, position: int) -> int:
    between = _BETWEEN.match(text, position)
    return between.end() if between is not None else position
