"""Numbers with a unit behind them, and what they are in metres, kilograms and radians."""

import pytest
from tests.support.examples import inertia, joint, link, robot

from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.rules.units import NumberWithUnit, numbers_with_unit


def found(unit: str, text: str, *values: str) -> tuple[NumberWithUnit, ...]:
    """Return the numbers that a document has with a unit; some names have values."""
    (parameter,) = (p for p in analyse(text).model.parameters if p.name == unit)
    return numbers_with_unit(parameter, dict.fromkeys(values, 1.0))


def moved_by(*xs: str) -> str:
    joints = [
        joint(f"j{n}").replace("(0.0, 0.0, 0.3)", f"({x}, 0.0, 0.3)") for n, x in enumerate(xs)
    ]
    links = [link(f"a{n}", n + 1) for n in range(len(xs))]
    return robot(*links, *joints, base=" ".join(f"a{n} via j{n}" for n in range(len(xs))))


@pytest.mark.parametrize(
    ("unit", "number", "in_si"),
    [
        ("m", "0.250", "0.250"),
        ("mm", "425.0", "0.425"),
        ("mm", "-0.5", "-0.0005"),
        ("cm", "12.5", "0.125"),
        ("mm", "1.2345678901234567", "0.00123456789012346"),
        ("rad", "1.50", "1.50"),
        ("deg", "90.0", "PI/2.0"),
        ("deg", "-45.0", "-PI/4.0"),
        ("degrees", "180.0", "PI"),
        ("deg", "0.0", "0.0"),
        ("deg", "0.00", "0.00"),
    ],
)
def test_a_number_is_told_in_si(unit: str, number: str, in_si: str) -> None:
    text = moved_by(f"{number}{unit}")
    ((place, written, alone, told),) = found(unit, text)
    assert (written, alone, told) == (f"{number}{unit}", number, in_si)
    assert place.island.text[place.start : place.end] == f"{number}{unit}"


@pytest.mark.parametrize(("unit", "in_si"), [("kg", "2.50"), ("g", "0.0025")])
def test_a_mass_is_told_in_kilograms(unit: str, in_si: str) -> None:
    body = link("a", 1, inertia=inertia(f"2.50{unit}", "0.0", "0.1", "0.1", "0.1"))
    ((_, _, _, told),) = found(unit, robot(body, base="a via j", joints="j"))
    assert told == in_si


@pytest.mark.parametrize(
    ("unit", "x", "is_unit"),
    [
        ("mm", "425.0mm", True),
        ("mm", "425.0 mm", True),
        ("m", "0.4m", True),
        ("m", "0.4 m", False),  # that may be a parameter of that name
        ("mm", "mm", False),
        ("mm", "0.4*mm", False),
        ("inch", "0.4inch", False),
    ],
)
def test_a_name_right_behind_a_number_is_a_unit(unit: str, x: str, is_unit: bool) -> None:
    assert bool(found(unit, moved_by(x))) == is_unit


def test_a_name_that_stands_elsewhere_too_is_no_unit() -> None:
    assert len(found("mm", moved_by("425.0mm", "30.0mm"))) == 2
    assert found("mm", moved_by("425.0mm", "mm")) == ()
    assert found("mm", moved_by("mm", "425.0mm")) == ()


def test_a_name_with_a_value_is_no_unit() -> None:
    assert found("mm", moved_by("425.0mm"), "mm") == ()
    assert len(found("mm", moved_by("425.0mm"), "cm")) == 1
