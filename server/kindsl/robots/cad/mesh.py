"""Closed triangle meshes (STL) to mass properties, exactly, by signed tetrahedra.

Source: Tonon 2004, Explicit exact formulas for the 3-D tetrahedron inertia tensor.
"""

import re
import struct
from collections import Counter
from collections.abc import Iterable, Sequence
from decimal import Decimal
from fractions import Fraction
from itertools import product
from math import frexp, isfinite

from kindsl.robots.cad.properties import MassProperties
from kindsl.robots.cad.shape import ShapeError, implausible, require_positive, rounded

_DIGITS = 15
_HEADER, _RECORD = 84, 50
_MANTISSA_BITS = 24
# Corners are one if they differ by the last bits of single precision, or by this, in metres.
_SINGLE_BITS = 22
_CLOSE = Fraction(1, 10**8)
_VERTEX = re.compile(rb"vertex\s+(\S+)\s+(\S+)\s+(\S+)")

Point = tuple[int, int, int]
Triangle = tuple[Point, Point, Point]


def mesh_properties(
    content: bytes,
    mass: Decimal | None = None,
    density: Decimal | None = None,
    scale: Decimal = Decimal(1),
) -> MassProperties:
    """Return the mass properties of the body within a mesh, in the mesh's frame.

    Args:
        content: The STL file, text or binary.
        mass: kg; either this or a density.
        density: kg/m³.
        scale: Metres in the mesh's unit.

    Raises:
        ShapeError: It is no STL file, the mesh is not closed, or the mass is not positive.
    """
    require_positive({"mass": mass, "density": density, "scale": scale})
    triangles, unit = _triangles(content)
    unit *= Fraction(scale)
    notes: tuple[str, ...] = ()
    if _open_edges(triangles):
        welded, reach = _welded(triangles, unit)
        _check_closed(_open_edges(welded), unit)
        triangles = welded
        notes = (f"corners less than {float(reach * unit):.1g} m apart are taken for one",)
    axes = zip(*(point for triangle in triangles for point in triangle), strict=True)
    notes += implausible("the mesh", max(max(axis) - min(axis) for axis in axes) * unit)
    return _properties(_integrals(triangles), unit, mass, density, notes)


def _triangles(content: bytes) -> tuple[list[Triangle], Fraction]:
    """Return the triangles in whole units, and the unit."""
    is_binary = len(content) >= _HEADER and len(content) == _binary_length(content)
    if not is_binary and not content.lstrip()[:5].lower() == b"solid":
        raise ShapeError("this is not an STL file")
    points, unit = _binary_points(content) if is_binary else _text_points(content)
    if not points or len(points) % 3:
        raise ShapeError("the STL file has no triangles, or is cut off")
    corners = iter(points)
    return list(zip(corners, corners, corners, strict=True)), unit


def _binary_length(content: bytes) -> int:
    return _HEADER + _RECORD * int(struct.unpack_from("<I", content, 80)[0])


def _binary_points(content: bytes) -> tuple[list[Point], Fraction]:
    numbers: list[float] = []
    for record in struct.iter_unpack("<12f2x", content[_HEADER:]):
        numbers += record[3:]
    if not all(map(isfinite, numbers)):
        raise ShapeError("the STL file has a coordinate that is not finite")
    least = min((frexp(number)[1] for number in numbers if number), default=0) - _MANTISSA_BITS
    unit = Fraction(2) ** least
    whole = [int(Fraction(number) / unit) for number in numbers]
    return _points(whole), unit


def _text_points(content: bytes) -> tuple[list[Point], Fraction]:
    try:
        numbers = [Decimal(word.decode()) for found in _VERTEX.findall(content) for word in found]
    except (ArithmeticError, UnicodeDecodeError):
        raise ShapeError("the STL file has a coordinate that is not a number") from None
    if not all(number.is_finite() for number in numbers):
        raise ShapeError("the STL file has a coordinate that is not finite")
    least = min((int(number.as_tuple().exponent) for number in numbers if number), default=0)
    unit = Fraction(10) ** least
    return _points([int(Fraction(number) / unit) for number in numbers]), unit


def _points(numbers: Sequence[int]) -> list[Point]:
    each = iter(numbers)
    return list(zip(each, each, each, strict=False))


def _open_edges(triangles: Iterable[Triangle]) -> list[tuple[Point, Point]]:
    """Return the edges with unequal numbers of triangles on both sides."""
    edges: Counter[tuple[Point, Point]] = Counter()
    for a, b, c in triangles:
        for start, end in ((a, b), (b, c), (c, a)):
            if start < end:
                edges[start, end] += 1
            elif end < start:
                edges[end, start] -= 1
    return sorted(edge for edge, count in edges.items() if count)


def _check_closed(open_edges: Sequence[tuple[Point, Point]], unit: Fraction) -> None:
    if open_edges:
        ends = " to ".join(_place(point, unit) for point in open_edges[0])
        count = f"{len(open_edges)} edges have" if len(open_edges) > 1 else "an edge has"
        first = "the first is from" if len(open_edges) > 1 else "it is from"
        raise ShapeError(f"the mesh is not closed: {count} triangles on one side, {first} {ends}")


def _welded(triangles: Sequence[Triangle], unit: Fraction) -> tuple[list[Triangle], int]:
    """Return the triangles with corners made one that rounding keeps apart, and how far that is.

    Modellers write a corner once for each triangle, and not always to the same last digit.
    """
    points = sorted({point for triangle in triangles for point in triangle})
    greatest = max(max(map(abs, point)) for point in points)
    reach = max(greatest >> _SINGLE_BITS, int(_CLOSE / unit))
    if not reach:
        return list(triangles), 0
    cells: dict[Point, list[Point]] = {}
    same: dict[Point, Point] = {}
    for point in points:
        x, y, z = (number // reach for number in point)
        near = (
            other
            for i, j, k in product((x - 1, x, x + 1), (y - 1, y, y + 1), (z - 1, z, z + 1))
            for other in cells.get((i, j, k), ())
            if all(abs(a - b) <= reach for a, b in zip(point, other, strict=True))
        )
        same[point] = next(near, point)
        if same[point] is point:
            cells.setdefault((x, y, z), []).append(point)
    return [(same[a], same[b], same[c]) for a, b, c in triangles], reach


def _place(point: Point, unit: Fraction) -> str:
    return f"({', '.join(f'{float(number * unit):.6g}' for number in point)})"


Integrals = tuple[int, list[int], list[list[int]]]


def _integrals(triangles: Iterable[Triangle]) -> Integrals:
    """Return 6, 24 and 120 times the volume, its first and its second moments about the origin."""
    volume, first = 0, [0, 0, 0]
    second = [[0, 0, 0], [0, 0, 0], [0, 0, 0]]
    for a, b, c in triangles:
        det = (
            a[0] * (b[1] * c[2] - b[2] * c[1])
            + a[1] * (b[2] * c[0] - b[0] * c[2])
            + a[2] * (b[0] * c[1] - b[1] * c[0])
        )
        total = (a[0] + b[0] + c[0], a[1] + b[1] + c[1], a[2] + b[2] + c[2])
        volume += det
        for i in range(3):
            first[i] += det * total[i]
            for j in range(i, 3):
                mixed = a[i] * a[j] + b[i] * b[j] + c[i] * c[j] + total[i] * total[j]
                second[i][j] += det * mixed
    return volume, first, second


def _properties(
    integrals: Integrals,
    unit: Fraction,
    mass: Decimal | None,
    density: Decimal | None,
    notes: tuple[str, ...],
) -> MassProperties:
    whole, first, second = integrals
    if not whole:
        raise ShapeError("the mesh encloses no volume")
    volume = abs(Fraction(whole, 6)) * unit**3
    heavy = Fraction(mass) if mass is not None else Fraction(density or 0) * volume
    com = [rounded(Fraction(one, 4 * whole) * unit, _DIGITS) for one in first]
    spread = [[heavy * Fraction(one, 20 * whole) * unit**2 for one in row] for row in second]
    xx, yy, zz = (spread[i][i] for i in range(3))
    moments = (yy + zz, xx + zz, xx + yy, spread[0][1], spread[0][2], spread[1][2])
    if whole < 0:
        notes = (*notes, "the triangles face inwards: the volume inside is taken")
    a, b, c, d, e, f = (rounded(moment, _DIGITS) for moment in moments)
    place = com[0], com[1], com[2]
    program = "a mesh"
    return MassProperties(program, rounded(heavy, _DIGITS), place, (a, b, c, d, e, f), notes=notes)
