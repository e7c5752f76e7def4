"""Shapes against what is written in every table, and against meshes of them."""

from decimal import Decimal
from math import pi

import pytest

from kindsl.robots.cad.properties import MassProperties
from kindsl.robots.cad.shape import (
    BOX,
    CAPSULE,
    CYLINDER,
    HOLLOW_CYLINDER,
    SPHERE,
    ShapeError,
    ShapeKind,
    shape_called,
    shape_properties,
)


def made(kind: ShapeKind, sizes: str, **heavy: str) -> MassProperties:
    given = {name: Decimal(value) for name, value in heavy.items()}
    return shape_properties(kind, [Decimal(size) for size in sizes.split()], **given)


def test_a_box_is_exact() -> None:
    found = made(BOX, "0.04 0.04 0.3", density="2700")
    assert found.mass == "1.296"
    assert found.moments[:3] == ("0.0098928", "0.0098928", "0.0003456")


@pytest.mark.parametrize(
    ("kind", "sizes", "volume", "across", "along"),
    [
        (CYLINDER, "0.1 0.5", pi * 0.01 * 0.5, 0.01 / 4 + 0.25 / 12, 0.01 / 2),
        (HOLLOW_CYLINDER, "0.1 0.06 0.5", pi * 0.0064 * 0.5, 0.0136 / 4 + 0.25 / 12, 0.0136 / 2),
        (SPHERE, "0.1", 4 / 3 * pi * 1e-3, 0.4 * 0.01, 0.4 * 0.01),
    ],
)
def test_round_shapes(
    kind: ShapeKind, sizes: str, volume: float, across: float, along: float
) -> None:
    found = made(kind, sizes, density="1000")
    mass = 1000 * volume
    assert float(found.mass) == pytest.approx(mass, rel=5e-9)
    expected = [mass * across, mass * across, mass * along]
    assert [float(text) for text in found.moments[:3]] == pytest.approx(expected, rel=1e-8)


def test_a_capsule_is_a_rod_with_half_a_ball_at_each_end() -> None:
    r, length = 0.1, 0.5
    rod, ball = pi * r * r * length, 4 / 3 * pi * r**3
    offset = length / 2 + 3 / 8 * r
    half_ball = ball / 2 * (0.4 * r * r - (3 / 8 * r) ** 2 + offset**2)
    across = rod * (r * r / 4 + length * length / 12) + 2 * half_ball
    found = made(CAPSULE, "0.1 0.5", density="1")
    assert float(found.moments[0]) == pytest.approx(across, rel=1e-8)
    assert float(found.moments[2]) == pytest.approx(rod * r * r / 2 + ball * 0.4 * r * r, rel=1e-8)


def test_a_size_in_millimetres_is_doubted() -> None:
    found = shape_properties(BOX, [Decimal(40), Decimal(40), Decimal(300)], Decimal(1))
    assert found.notes == ("the box is 300 m in size: is that in millimetres?",)


def test_digits_follow_what_is_given() -> None:
    found = made(SPHERE, "0.12345678901", mass="1.0")
    assert len(found.moments[0].lstrip("0.")) == 13
    assert made(SPHERE, "0.3", density="7").mass == "0.791681349"


@pytest.mark.parametrize(
    ("kind", "sizes", "said"),
    [
        (BOX, "0.1 0 0.1", "the y of the box is 0, which is not positive"),
        (SPHERE, "-1", "radius"),
        (HOLLOW_CYLINDER, "0.1 0.1 1", "not less than the outer"),
    ],
)
def test_sizes_that_no_body_has(kind: ShapeKind, sizes: str, said: str) -> None:
    with pytest.raises(ShapeError, match=said):
        made(kind, sizes, mass="1.0")


def test_a_shape_in_words_is_the_shape() -> None:
    assert shape_called("box(0.1, 0.2, 0.3, mass = 4)") == made(BOX, "0.1 0.2 0.3", mass="4")
    assert shape_called("sphere(0.3,density=7)") == made(SPHERE, "0.3", density="7")


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("sphere(0.3, 0.4, mass = 4)", "a sphere needs radius and 'mass =' or 'density ='"),
        ("sphere(0.3, weight = 4)", "a sphere needs radius and 'mass =' or 'density ='"),
        ("sphere(0.3, mass = four)", "'four' is not a number"),
        ("sphere(wide, mass = 4)", "'wide' is not a number"),
    ],
)
def test_words_that_are_no_shape(text: str, said: str) -> None:
    with pytest.raises(ShapeError, match=said):
        shape_called(text)
