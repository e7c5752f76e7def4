"""How far a number may be from what is written: alone, in its group, and in its whole section."""

from decimal import ROUND_DOWN, ROUND_HALF_EVEN, ROUND_HALF_UP, Decimal
from math import pi

import pytest
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st
from tests.support.bodies import document_of_bodies

from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.diagnosis.digits import (
    WrittenDigits,
    all_written_as,
    bounds_by_digits,
    likely_half_widths,
    numbers_written,
    rewritten_number,
)
from kindsl.language.semantics.declarations import Inertia
from kindsl.mechanics.rigid.body import MassDistribution

SECTION = "inertia_params { mass = %s CoM = (%s, %s, %s) Ix=%s Iy=%s Iz=%s Ixy=%s Ixz=%s Iyz=%s }"


def section(text: str) -> Inertia:
    """Return the section with these ten numbers; behind the first may be a semicolon."""
    first, _, others = text.partition(";") if ";" in text else text.partition(" ")
    model = analyse(document_of_bodies([SECTION % (first, *others.split())])).model
    inertia = model.links[0].inertia
    assert inertia is not None
    return inertia


def ten(body: MassDistribution) -> list[float]:
    return [body.mass, *body.com, *body.moments]


def proving(text: str, **known: tuple[float, float]) -> list[tuple[float, float]]:
    """Return the bounds of all ten numbers."""
    bounds = bounds_by_digits(section(text), known)
    assert bounds is not None
    pairs = zip(ten(bounds.middle), ten(bounds.half), strict=True)
    return [(middle - half, middle + half) for middle, half in pairs]


def likely(text: str) -> list[float]:
    return ten(likely_half_widths(numbers_written(section(text), {})))


@pytest.mark.parametrize(
    ("number", "low", "high"),
    [
        # Rounded, it is within half a unit of the last digit; cut off, a whole unit greater.
        ("2.0", 1.95, 2.1),
        ("2.50", 2.495, 2.51),
        ("0.0025", 0.00245, 0.0026),
        ("-2.5", -2.6, -2.45),
        ("+2.5", 2.45, 2.6),
        ("2.5e3", 2450.0, 2600.0),
        ("2.5E-3", 0.00245, 0.0026),
        (".5", 0.45, 0.6),
        ("0.0", -0.1, 0.1),
        ("-0.000", -0.001, 0.001),
        ("9.0", 8.95, 9.1),
        ("10.0", 9.5, 11.0),  # a whole number with the point that the language wants
        ("-12.0", -13.0, -11.5),
        ("12.5", 12.45, 12.6),
        ("12.00", 11.995, 12.01),
        ("100.0", 95.0, 110.0),  # of 100 the two digits 1 and 0
        ("1200.0", 1150.0, 1300.0),
        ("1203.0", 1202.5, 1204.0),
        ("2000000000000000.0", 1999999999999999.95, 2000000000000000.1),
    ],
)
def test_a_number_stands_for_all_that_are_written_so(number: str, low: float, high: float) -> None:
    assert all_written_as(number) == pytest.approx((low, high))


@settings(deadline=None)
@given(
    st.floats(-1e4, 1e4),
    st.integers(0, 12),
    st.sampled_from((ROUND_HALF_EVEN, ROUND_HALF_UP, ROUND_DOWN)),
    st.booleans(),
)
@example(12.5, 0, ROUND_HALF_EVEN, False)
def test_a_number_is_within_its_bounds_however_it_was_shortened(
    value: float, digits: int, rounding: str, is_bare: bool
) -> None:
    text = f"{Decimal(value).quantize(Decimal(1).scaleb(-digits), rounding=rounding):f}"
    text = text if "." in text else f"{text}.0"
    text = repr(float(text)) if is_bare else text
    # Below ten a zero behind the point is a digit: nobody writes `2.0` of 1.5 m in whole metres.
    assume(digits or abs(float(text)) >= 10.0)
    low, high = all_written_as(text)
    assert low - 1e-9 <= value <= high + 1e-9


def test_what_is_proved_believes_each_number_alone() -> None:
    """The others' digits tell nothing of it."""
    found = proving("2.0 0.1 0.125 0.0 0.012345 0.012345678901 0.0123 0.0 0.00 0.000")
    wanted = [
        (1.95, 2.1), (0.05, 0.2), (0.1245, 0.126), (-0.1, 0.1),
        (0.0123445, 0.012346), (0.0123456789005, 0.012345678902), (0.01225, 0.0124),
        (-0.1, 0.1), (-0.01, 0.01), (-0.001, 0.001),
    ]  # fmt: skip
    for bounds, expected in zip(found, wanted, strict=True):
        assert bounds == pytest.approx(expected, abs=1e-15)


@pytest.mark.parametrize(
    ("mass", "low", "high"),
    [
        ("0.50*2.0", 0.495 * 1.95, 0.51 * 2.1),
        ("2.0*load", 1.95 * 3.0, 2.1 * 4.0),
        ("2.0 load", 1.95 * 3.0, 2.1 * 4.0),
        ("-load/2.0", -4.0 / 1.95, -3.0 / 2.1),
        ("load", 3.0, 4.0),
        ("load[9.0]", 3.0, 4.0),
        ("other[9.0]", 8.95, 9.1),
        ("<k=2.5>", 2.45, 2.6),
        ("PI", pi, pi),
        ("PI/2.0", pi / 2.1, pi / 1.95),
        ("2.0 PI", 1.95 * pi, 2.1 * pi),
    ],
)
def test_numbers_in_an_expression_are_known_as_they_are_written(
    mass: str, low: float, high: float
) -> None:
    found = proving(f"{mass}; 0.0 0.0 0.0 0.1 0.1 0.1 0.0 0.0 0.0", load=(3.0, 4.0))
    assert found[0] == pytest.approx((low, high))


@pytest.mark.parametrize("mass", ["unbound", "1.0/0.0", "1.0/0.04"])
def test_nothing_is_known_of_what_has_no_bounds(mass: str) -> None:
    """0.04 may be small, but is not zero; 0.0 may be."""
    inertia = section(f"{mass} 0.0 0.0 0.0 0.1 0.1 0.1 0.0 0.0 0.0")
    assert (bounds_by_digits(inertia, {}) is None) == (mass != "1.0/0.04")


def test_likely_all_but_the_mass_are_written_in_one_manner() -> None:
    """`0.1` beside `Ix=0.012` is 100 mm; the mass has two digits as the others have."""
    found = likely("2.0 0.0 0.0 0.1 0.012 0.012 0.002 0.0 0.0 0.0")
    assert found == pytest.approx([0.05, *[0.0005] * 2, 0.005, *[0.0005] * 6])


def test_the_mass_tells_nothing_of_the_others_but_they_of_it() -> None:
    found = likely("0.12345 0.0 0.0 0.1 0.1 0.1 0.1 0.0 0.0 0.0")
    assert found == pytest.approx([0.000005, *[0.05] * 9])
    found = likely("0.1 0.125 0.0 0.0 0.1 0.1 0.1 0.0 0.0 0.0")
    assert found == pytest.approx([*[0.0005] * 4, *[0.05] * 6])


def test_moments_of_two_digits_are_not_as_exact_as_a_com_of_five() -> None:
    found = likely("1.401 -0.052319 0.0 0.0067681 0.00093 0.013 0.012 0.0 0.0 0.0")
    assert found[1:4] == pytest.approx([5e-7, 5e-8, 5e-8])
    assert found[4:] == pytest.approx([5e-6, 5e-4, 5e-4, *[5e-6] * 3])


def test_a_value_that_is_no_number_is_known_as_its_operands_are() -> None:
    """A product of 0.50, which is known to 0.005, and 2.0, which is known to 0.05."""
    inertia = section("0.50*2.0 0.0 0.0 0.0 0.123 0.123 0.123 0.0 0.0 0.0")
    written = numbers_written(inertia, {})[0]
    assert written.literal is None
    assert written.rounding == pytest.approx(0.5 * 0.05 + 2.0 * 0.005)
    assert likely_half_widths(numbers_written(inertia, {})).mass == pytest.approx(0.035)


def test_a_parameter_is_exact_and_says_nothing_of_other_numbers() -> None:
    inertia = section("2.0 0.0 0.0 0.0 load 0.1 0.1 0.0 0.0 0.0")
    found = ten(likely_half_widths(numbers_written(inertia, {"load": 0.12345})))
    assert found[4:] == pytest.approx((0.0, 0.05, 0.05, 0.05, 0.05, 0.05))


def test_nobody_drops_the_zeros_of_a_number_of_four_digits() -> None:
    found = likely("2.0 0.0 0.0 0.1 0.012 0.0125 0.01254 0.0 0.0 0.012345678")
    assert found[4:7] == pytest.approx([5e-10, 5e-10, 5e-6])


def test_numbers_are_in_the_order_of_a_mass_distribution() -> None:
    written = numbers_written(section("1.0 2.0 3.0 4.0 5.0 6.0 7.0 8.0 9.0 0.5"), {})
    assert [number.literal for number in written] == [
        1.0,
        2.0,
        3.0,
        4.0,
        5.0,
        6.0,
        7.0,
        8.0,
        9.0,
        0.5,
    ]
    assert [number.text for number in written][:2] == ["1.0", "2.0"]


def test_a_number_that_is_to_be_written_is_known_to_half_its_last_digit() -> None:
    assert rewritten_number("0.0250") == WrittenDigits("0.0250", 0.025, pytest.approx(0.00005))
