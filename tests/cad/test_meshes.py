"""Meshes: exact for polyhedra, the same from text and binary, and refused where they are open."""

import struct
from decimal import Decimal
from itertools import pairwise

import pytest

from kindsl.robots.cad.mesh import mesh_properties
from kindsl.robots.cad.shape import BOX, ShapeError, shape_properties

Point = tuple[float, float, float]
FACES = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))
ONE = Decimal(1)


def box(size: Point = (0.5, 0.25, 2.0), corner: Point = (0.0, 0.0, 0.0)) -> list[list[Point]]:
    """Return the triangles of a box from a corner on."""
    steps = [(i, j, k) for k in (0, 1) for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))]
    points: list[Point] = []
    for i, j, k in steps:
        points.append((corner[0] + i * size[0], corner[1] + j * size[1], corner[2] + k * size[2]))
    return [
        [points[face[0]], points[a], points[b]] for face in FACES for a, b in pairwise(face[1:])
    ]


def as_text(triangles: list[list[Point]]) -> bytes:
    lines = ["solid part"]
    for triangle in triangles:
        lines += ["facet normal 0 0 0", "outer loop"]
        lines += [f"vertex {x!r} {y!r} {z!r}" for x, y, z in triangle]
        lines += ["endloop", "endfacet"]
    return "\n".join((*lines, "endsolid part")).encode()


def as_binary(triangles: list[list[Point]]) -> bytes:
    head = b"solid".ljust(80) + struct.pack("<I", len(triangles))
    records = (
        struct.pack("<12fH", 0.0, 0.0, 0.0, *(x for point in triangle for x in point), 0)
        for triangle in triangles
    )
    return head + b"".join(records)


def refusal(content: bytes) -> str:
    with pytest.raises(ShapeError) as error:
        mesh_properties(content, mass=ONE)
    return str(error.value)


@pytest.mark.parametrize("write", [as_text, as_binary])
def test_a_box_is_exact(write: object) -> None:
    content = as_text(box()) if write is as_text else as_binary(box())
    found = mesh_properties(content, mass=Decimal(3))
    assert (found.mass, found.com) == ("3.0", ("0.25", "0.125", "1.0"))
    assert found.moments == ("4.0625", "4.25", "0.3125", "0.09375", "0.75", "0.375")


def test_a_centred_box_is_the_shape() -> None:
    found = mesh_properties(as_text(box((1.0, 2.0, 4.0), (-0.5, -1.0, -2.0))), mass=Decimal(12))
    shape = shape_properties(BOX, [Decimal(1), Decimal(2), Decimal(4)], mass=Decimal(12))
    assert found.moments == shape.moments


def test_a_hole_is_taken_off_and_order_does_not_matter() -> None:
    hole = [triangle[::-1] for triangle in box((0.25, 0.125, 1.0), (0.125, 0.0625, 0.5))]
    found = mesh_properties(as_binary(hole + box()), density=ONE)
    assert found.mass == str(0.25 - 0.03125)


def test_a_mesh_inside_out_is_the_same_body() -> None:
    found = mesh_properties(as_text([triangle[::-1] for triangle in box()]), mass=ONE)
    right = mesh_properties(as_text(box()), mass=ONE)
    assert found.moments == right.moments and "inwards" in found.notes[0]


def test_a_mesh_in_millimetres_is_doubted() -> None:
    text = as_text(box((40.0, 30.0, 20.0)))
    (note,) = mesh_properties(text, ONE).notes
    assert note == "the mesh is 40 m in size: is that in millimetres?"
    assert mesh_properties(text, ONE, scale=Decimal("0.001")).notes == ()


def test_a_scale_changes_the_unit() -> None:
    big = mesh_properties(as_text(box((500.0, 250.0, 2000.0))), mass=ONE, scale=Decimal("0.001"))
    assert big.moments == mesh_properties(as_text(box()), mass=ONE).moments


def test_an_open_mesh_is_refused_with_where() -> None:
    assert "3 edges have triangles on one side, the first is from (0, 0, 0)" in refusal(
        as_text(box()[1:])
    )


def test_corners_that_rounding_keeps_apart_are_one() -> None:
    first, *rest = box()
    apart = [[(x + 3e-9, y, z) for x, y, z in first], *rest]
    found = mesh_properties(as_text(apart), mass=Decimal(3))
    right = mesh_properties(as_text(box()), mass=Decimal(3))
    for text, expected in zip(found.moments, right.moments, strict=True):
        assert abs(float(text) - float(expected)) < 1e-7
    assert "taken for one" in found.notes[0]
    assert "not closed" in refusal(as_text([[(x + 1e-4, y, z) for x, y, z in first], *rest]))


def test_a_triangle_turned_round_is_refused() -> None:
    first, *rest = box()
    assert "not closed" in refusal(as_text([first[::-1], *rest]))


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (b"", "not an STL file"),
        (b"solid empty\nendsolid", "no triangles"),
        (b"solid x\nvertex 1 2 x\nendsolid", "not a number"),
        (b"solid x\nvertex 1 2 nan\nvertex 1 2 3\nvertex 1 2 4", "not finite"),
        (as_binary(box())[:-1], "no triangles"),
        (as_binary(box())[:-1].replace(b"solid", b"SOLAR"), "not an STL file"),
        (as_text([[(0.0, 0.0, 0.0)] * 3]), "no volume"),
    ],
)
def test_files_that_hold_no_body(content: bytes, said: str) -> None:
    assert said in refusal(content)
