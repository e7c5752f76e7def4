"""Agreement of a report's numbers, for each sign that its products may have.

With the CoM `c`, the tensor `I` at the output coordinate system and `L` at the CoM hold
`Ixx - Lxx = m (y² + z²)` and `Ixy - Lxy = s m x y`; `s` is +1 where the products are the
language's, `Σ m x y`, and -1 where they are the entries of a tensor.
"""

from collections.abc import Iterator
from fractions import Fraction
from math import hypot
from typing import NamedTuple

from kindsl.mechanics.rigid.body import Symmetric, eigensystem
from kindsl.robots.cad.quantity import Quantity, Rounded
from kindsl.robots.cad.report import PAIRS, Entry

_AXES = "xyz"
_SLACK = 1e-9

Tensor = dict[Entry, Rounded]


class Numbers(NamedTuple):
    """The numbers of a report, each once.

    Attributes:
        mass: kg.
        center: Centre of mass, m.
        about_com: The tensor at the CoM as printed, None where it is not.
        about_origin: The one at the output coordinate system.
        principal: Principal moments, none or three.
        axes: Principal axes by the index of the moment.
    """

    mass: Quantity
    center: tuple[Quantity, ...]
    about_com: dict[Entry, Quantity] | None
    about_origin: dict[Entry, Quantity] | None
    principal: tuple[Quantity, ...]
    axes: dict[int, tuple[Quantity, ...]]


def moved(numbers: Numbers, entry: Entry, sign: int) -> Rounded:
    """Return what a tensor's entry has more at the output coordinate system than at the CoM."""
    row, column = entry
    mass, c = numbers.mass.bounds, [one.bounds for one in numbers.center]
    if row != column:
        return (mass * c[row] * c[column]).times(sign)
    return mass * _sum(c[index] * c[index] for index in range(3) if index != row)


def disagreements(numbers: Numbers, sign: int) -> Iterator[str]:
    """Yield what does not agree within the digits if the products have that sign."""
    yield from _between_tensors(numbers, sign)
    about_com = _about_com(numbers, sign)
    if numbers.principal:
        yield from _with_principal(numbers, about_com, sign)
    yield from _impossible(about_com, sign)


def _between_tensors(numbers: Numbers, sign: int) -> Iterator[str]:
    if numbers.about_com is None or numbers.about_origin is None:
        return
    for entry in PAIRS:
        one, other = numbers.about_origin[entry], numbers.about_com[entry]
        difference, arm = one.bounds - other.bounds, moved(numbers, entry, sign)
        if not difference.agrees_with(arm):
            yield (
                f"{one.name} at the origin less {other.name} at the CoM is "
                f"{_text(difference.value)} kg·m², "
                f"but {_arm(entry, sign)} is {_text(arm.value)} kg·m²"
            )


def _arm(entry: Entry, sign: int) -> str:
    row, column = entry
    if row != column:
        return f"{'-' if sign < 0 else ''}m {_AXES[row]} {_AXES[column]}"
    first, second = (axis for index, axis in enumerate(_AXES) if index != row)
    return f"m ({first}² + {second}²)"


def _about_com(numbers: Numbers, sign: int) -> Tensor:
    if numbers.about_com is not None:
        return {entry: numbers.about_com[entry].bounds for entry in PAIRS}
    assert numbers.about_origin is not None
    return {
        entry: numbers.about_origin[entry].bounds - moved(numbers, entry, sign) for entry in PAIRS
    }


def _with_principal(numbers: Numbers, tensor: Tensor, sign: int) -> Iterator[str]:
    printed = sorted(numbers.principal, key=lambda one: one.value)
    found = [pair.value for pair in eigensystem(_matrix(tensor, sign))]
    reach = _norm_of_errors(tensor)
    for one, value in zip(printed, found, strict=True):
        allowed = reach + float(one.error) + _SLACK * abs(found[2])
        if abs(float(one.value) - value) > allowed:
            yield (
                f"the principal moment {one.name} is {_text(one.value)} kg·m², "
                f"but that of the tensor is {value:.6g} kg·m²"
            )
            return
    for index, axis in numbers.axes.items():
        yield from _with_axis(numbers.principal[index], axis, tensor, sign)


def _with_axis(
    moment: Quantity, axis: tuple[Quantity, ...], tensor: Tensor, sign: int
) -> Iterator[str]:
    """Yield where the tensor times a principal axis is not its moment times the axis."""
    v = [one.bounds for one in axis]
    for row in range(3):
        entries = [_entry(tensor, row, column, sign) for column in range(3)]
        found = _sum(entry * part for entry, part in zip(entries, v, strict=True))
        expected = moment.bounds * v[row]
        if not found.agrees_with(expected):
            yield (
                f"{_AXES[row]} of the tensor times the axis of {moment.name} is "
                f"{_text(found.value)} kg·m², but {_text(expected.value)} kg·m² by {moment.name}"
            )
            return


def _impossible(tensor: Tensor, sign: int) -> Iterator[str]:
    xx, yy, zz, *products = (float(tensor[entry].value) for entry in PAIRS)
    half = 0.5 * (xx + yy + zz)
    xy, xz, yz = (sign * product for product in products)
    least = eigensystem((half - xx, half - yy, half - zz, xy, xz, yz))[0].value
    # The error of S = tr(I)/2 1 - I is at most 3/2 on the diagonal of what I's is.
    if least < -2.0 * _norm_of_errors(tensor) - _SLACK * half:
        yield (
            f"no body has these moments: the greatest principal moment exceeds the sum of the "
            f"others by {-2.0 * least:.3g} kg·m²"
        )


def _matrix(tensor: Tensor, sign: int) -> Symmetric:
    xx, yy, zz, xy, xz, yz = (float(tensor[entry].value) for entry in PAIRS)
    return xx, yy, zz, -sign * xy, -sign * xz, -sign * yz


def _entry(tensor: Tensor, row: int, column: int, sign: int) -> Rounded:
    entry = tensor[min(row, column), max(row, column)]
    return entry if row == column else entry.times(-sign)


def _norm_of_errors(tensor: Tensor) -> float:
    """Return a bound of how far the errors may move an eigenvalue: their Frobenius norm."""
    errors = [float(tensor[entry].error) for entry in PAIRS]
    return hypot(*errors, *errors[3:])


def _sum(terms: Iterator[Rounded]) -> Rounded:
    return sum(terms, Rounded(Fraction(0), Fraction(0)))


def _text(value: Fraction) -> str:
    return f"{float(value):.9g}"
