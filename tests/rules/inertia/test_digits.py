"""How far a number may be from what is written: alone, in its group, and in its whole section."""

from math import inf

import pytest
from tests.support.bodies import document_of_bodies

from kindsl.analysis.analysis import analyse
from kindsl.rigid.body import MassDistribution
from kindsl.rules.inertia.digits import (
    Written,
    half_widths,
    likely_half_widths,
    numbers_written,
    rewritten_number,
)
from kindsl.semantics.declarations import Inertia

SECTION = "inertia_params { mass = %s CoM = (%s, %s, %s) Ix=%s Iy=%s Iz=%s Ixy=%s Ixz=%s Iyz=%s }"


def section(text: str) -> Inertia:
    """Return the section with these ten numbers."""
    model = analyse(document_of_bodies([SECTION % tuple(text.split())])).model
    inertia = model.links[0].inertia
    assert inertia is not None
    return inertia


def ten(body: MassDistribution) -> list[float]:
    return [body.mass, *body.com, *body.moments]


def proving(text: str) -> list[float]:
    return ten(half_widths(section(text), {}))


def likely(text: str) -> list[float]:
    return ten(likely_half_widths(numbers_written(section(text), {})))


@pytest.mark.parametrize(
    ("mass", "half"),
    [
        ("2.0", 0.05),
        ("2.50", 0.005),
        ("0.0025", 0.00005),
        ("-2.5", 0.05),
        ("2.5e3", 50.0),
        ("9.0", 0.05),
        ("10.0", 0.5),  # a whole number with the point that the language wants
        ("12.0", 0.5),
        ("-12.0", 0.5),
        ("12.5", 0.05),
        ("12.00", 0.005),
        ("100.0", 5.0),  # of 100 the two digits 1 and 0
        ("120.0", 5.0),
        ("1200.0", 50.0),
        ("1203.0", 0.5),
        ("1000000.0", 50000.0),
        ("2000000000000000.0", 0.05),
    ],
)
def test_a_mass_stands_for_all_that_round_to_it(mass: str, half: float) -> None:
    found = proving(f"{mass} 0.0 0.0 0.0 0.10 0.10 0.10 0.0 0.0 0.0")
    assert found[0] == pytest.approx(half)


@pytest.mark.parametrize(
    ("com", "halves"),
    [
        # As many decimals everywhere, or zeros dropped: the finest last digit.
        ("0.1 0.125 0.25", (0.0005, 0.0005, 0.0005)),
        ("0.1 0.2 0.3", (0.05, 0.05, 0.05)),
        ("0.1 0.02 0.3", (0.005, 0.005, 0.005)),  # two digits are believed at least
        ("0.10 0.2 0.3", (0.005, 0.005, 0.005)),
        # As many significant digits everywhere: the coarser of the two.
        ("0.00123 0.0456 1.23", (0.000005, 0.00005, 0.005)),
        ("0.00123 0.0456 1.2", (0.000005, 0.00005, 0.005)),
        # A zero is as exact as the finest number, or as it is written if that is finer.
        ("0.125 0.0 0.25", (0.0005, 0.0005, 0.0005)),
        ("0.125 0.0000 0.25", (0.0005, 0.00005, 0.0005)),
        ("0.0 0.0 0.0", (0.05, 0.05, 0.05)),
        ("0.00 0.0 0.0", (0.005, 0.05, 0.05)),
        # Of whole numbers the zeros at the end are no digits.
        ("1200.0 0.0 125.0", (5.0, 0.05, 0.5)),
        ("-0.1 0.125 -0.25", (0.0005, 0.0005, 0.0005)),
    ],
)
def test_numbers_of_a_vector_are_written_in_one_manner(com: str, halves: tuple[float, ...]) -> None:
    found = proving(f"2.00 {com} 0.1 0.1 0.1 0.0 0.0 0.0")
    assert found[1:4] == pytest.approx(halves)


@pytest.mark.parametrize(
    ("moments", "halves"),
    [
        ("0.1 0.12 0.123 0.0 0.0 0.0", (0.0005,) * 6),
        ("0.12 0.0123 0.123 0.0 0.00123 -0.0123", (5e-4, 5e-5, 5e-4, 5e-6, 5e-6, 5e-5)),
        ("0.5 0.5 0.5 0.0 0.0 0.0", (0.05,) * 6),
    ],
)
def test_moments_are_written_in_one_manner_whatever_the_com_is(
    moments: str, halves: tuple[float, ...]
) -> None:
    for com in ("0.0 0.0 0.0", "0.12345 0.1 0.2", "0.1 0.2 0.3"):
        assert proving(f"2.0 {com} {moments}")[4:] == pytest.approx(halves)


def test_likely_all_but_the_mass_are_written_in_one_manner() -> None:
    """`0.1` beside `Ix=0.012` is 100 mm; the mass has two digits as the others have."""
    found = likely("2.0 0.0 0.0 0.1 0.012 0.012 0.002 0.0 0.0 0.0")
    assert found == pytest.approx([0.05, *[0.0005] * 2, 0.005, *[0.0005] * 6])


def test_the_mass_tells_nothing_of_the_others_but_they_of_it() -> None:
    found = likely("0.12345 0.0 0.0 0.1 0.1 0.1 0.1 0.0 0.0 0.0")
    assert found == pytest.approx([0.000005, *[0.05] * 9])
    found = likely("0.1 0.125 0.0 0.0 0.1 0.1 0.1 0.0 0.0 0.0")
    assert found == pytest.approx([0.0005] * 10)


def test_a_value_that_is_no_number_is_known_as_its_operands_are() -> None:
    """A product of 0.50, which is known to 0.005, and 2.0, which is known to 0.05."""
    inertia = section("0.50*2.0 0.0 0.0 0.0 0.123 0.123 0.123 0.0 0.0 0.0")
    written = numbers_written(inertia, {})[0]
    assert written.literal is None
    assert written.rounding == pytest.approx(0.5 * 0.05 + 2.0 * 0.005)
    assert half_widths(inertia, {}).mass == pytest.approx(0.035)
    assert likely_half_widths(numbers_written(inertia, {})).mass == pytest.approx(0.035)


def test_a_parameter_is_exact_and_says_nothing_of_other_numbers() -> None:
    moments = "load 0.1 0.1 0.0 0.0 0.0"
    inertia = section(f"2.0 0.0 0.0 0.0 {moments}")
    assert ten(half_widths(inertia, {"load": 0.12345}))[4:] == pytest.approx(
        (0.0, 0.05, 0.05, 0.05, 0.05, 0.05)
    )


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
    assert rewritten_number("0.0250") == Written("0.0250", 0.025, pytest.approx(0.00005))


def test_of_parameters_alone_nothing_is_known_but_that_zeros_are_zeros() -> None:
    inertia = section("2.0 x x 0.0 0.1 0.1 0.1 0.0 0.0 0.0")
    assert half_widths(inertia, {"x": 0.5}).com == (0.0, 0.0, 0.05)
    assert inf not in ten(half_widths(inertia, {"x": 0.5}))
