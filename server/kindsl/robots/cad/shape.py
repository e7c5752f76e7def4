"""Homogeneous shapes about their centre, `z` along their axis: mass and moments, exactly."""

from collections.abc import Mapping, Sequence
from decimal import Context, Decimal, InvalidOperation, localcontext
from fractions import Fraction
from typing import NamedTuple

from kindsl.robots.cad.properties import MassProperties
from kindsl.robots.cad.quantity import positional

_FEWEST_DIGITS = 9
_LARGEST = 10
_PI = Fraction("3.14159265358979323846264338327950288419716939937510")

Moments = tuple[Fraction, Fraction, Fraction]


class ShapeError(ValueError):
    """Sizes, a mass or a density that no body has; the message is a sentence."""


class ShapeKind(NamedTuple):
    """A kind of shape with the names of its sizes, metres."""

    name: str
    sizes: tuple[str, ...]


BOX = ShapeKind("box", ("x", "y", "z"))
CYLINDER = ShapeKind("cylinder", ("radius", "length"))
HOLLOW_CYLINDER = ShapeKind("hollow cylinder", ("outer radius", "inner radius", "length"))
SPHERE = ShapeKind("sphere", ("radius",))
CAPSULE = ShapeKind("capsule", ("radius", "length"))
KINDS = (BOX, CYLINDER, HOLLOW_CYLINDER, SPHERE, CAPSULE)


def kind_called(name: str) -> ShapeKind | None:
    """Return the kind of a name, its words separated in any way, None if there is none."""
    words = name.replace("-", " ").replace("_", " ")
    return next((kind for kind in KINDS if kind.name == words), None)


def shape_properties(
    kind: ShapeKind,
    sizes: Sequence[Decimal],
    mass: Decimal | None = None,
    density: Decimal | None = None,
) -> MassProperties:
    """Return the mass properties of a shape about its centre.

    The numbers are exact where that takes few digits, else they have nine significant ones, or two
    more than what is given.

    Args:
        sizes: As `kind.sizes` says, metres.
        mass: kg; either this or a density.
        density: kg/m³.

    Raises:
        ShapeError: Something is not positive, or the inner radius is not the smaller one.
    """
    given = [*sizes, mass if mass is not None else density or Decimal(0)]
    _check(kind, sizes, mass, density)
    volume, per_mass = _geometry(kind, [Fraction(size) for size in sizes])
    heavy = Fraction(mass) if mass is not None else Fraction(density or 0) * volume
    digits = max(_FEWEST_DIGITS, *(len(one.as_tuple().digits) + 2 for one in given))
    texts = [rounded(heavy * moment, digits) for moment in per_mass]
    zero = ("0.0", "0.0", "0.0")
    moments = (texts[0], texts[1], texts[2], *zero)
    notes = implausible(f"the {kind.name}", Fraction(max(sizes)))
    return MassProperties(f"a {kind.name}", rounded(heavy, digits), zero, moments, notes=notes)


def implausible(noun: str, size: Fraction) -> tuple[str, ...]:
    """Return the note on a body that is larger than links of robots are, in metres."""
    note = f"{noun} is {float(size):.3g} m in size: is that in millimetres?"
    return (note,) if size > _LARGEST else ()


def shape_called(text: str) -> MassProperties:
    """Return the mass properties of a shape as a document names it: `box(1, 2, 3, mass = 4)`.

    Raises:
        ShapeError: It has not the sizes that it needs, or no body has them.
    """
    name, _, arguments = text.partition("(")
    kind = kind_called(name.strip())
    assert kind is not None, "what is no shape is not called one"
    *sizes, heavy = (part.strip() for part in arguments.rstrip(" )").split(","))
    what, _, value = (part.strip() for part in heavy.partition("="))
    if len(sizes) != len(kind.sizes) or what not in ("mass", "density"):
        raise ShapeError(f"a {kind.name} needs {', '.join(kind.sizes)} and 'mass =' or 'density ='")
    given = {what: _decimal(value)}
    return shape_properties(kind, [_decimal(size) for size in sizes], **given)


def _decimal(text: str) -> Decimal:
    try:
        return Decimal(text)
    except InvalidOperation:
        raise ShapeError(f"'{text}' is not a number") from None


def rounded(value: Fraction, digits: int) -> str:
    """Return a value with so many significant digits at most, trailing zeros left out."""
    with localcontext(Context(prec=digits)):
        number = (Decimal(value.numerator) / Decimal(value.denominator)).normalize()
    return positional(number + 0)


def require_positive(given: Mapping[str, Decimal | None]) -> None:
    """Raise ShapeError for the first value that is given and not positive."""
    for name, value in given.items():
        if value is not None and not (value.is_finite() and value > 0):
            raise ShapeError(f"the {name} is {value}, which is not positive")


def _check(
    kind: ShapeKind, sizes: Sequence[Decimal], mass: Decimal | None, density: Decimal | None
) -> None:
    given = {**dict(zip(kind.sizes, sizes, strict=True)), "mass": mass, "density": density}
    require_positive({f"{name} of the {kind.name}": value for name, value in given.items()})
    if kind is HOLLOW_CYLINDER and sizes[1] >= sizes[0]:
        radii = f"the inner radius {sizes[1]} is not less than the outer {sizes[0]}"
        raise ShapeError(f"{radii}: this is no {kind.name}")


def _geometry(kind: ShapeKind, sizes: Sequence[Fraction]) -> tuple[Fraction, Moments]:
    if kind is BOX:
        return _box(*sizes)
    if kind is CYLINDER:
        return _hollow_cylinder(sizes[0], Fraction(0), sizes[1])
    if kind is HOLLOW_CYLINDER:
        return _hollow_cylinder(*sizes)
    return _capsule(sizes[0], sizes[1] if kind is CAPSULE else Fraction(0))


def _box(x: Fraction, y: Fraction, z: Fraction) -> tuple[Fraction, Moments]:
    return x * y * z, ((y * y + z * z) / 12, (x * x + z * z) / 12, (x * x + y * y) / 12)


def _hollow_cylinder(
    outer: Fraction, inner: Fraction, length: Fraction
) -> tuple[Fraction, Moments]:
    squares = outer * outer + inner * inner
    across = squares / 4 + length * length / 12
    return _PI * (outer * outer - inner * inner) * length, (across, across, squares / 2)


def _capsule(radius: Fraction, length: Fraction) -> tuple[Fraction, Moments]:
    """Return volume and moments of a cylinder between half balls; a ball if its length is zero."""
    rod, balls = radius * radius * length, radius**3 * 4 / 3
    share = rod / (rod + balls)
    ball = radius * radius * 2 / 5
    along = share * radius * radius / 2 + (1 - share) * ball
    across = share * (radius * radius / 4 + length * length / 12)
    across += (1 - share) * (ball + length * length / 4 + length * radius * 3 / 8)
    return _PI * (rod + balls), (across, across, along)
