"""Powers of ten in words and titles are those that put the numbers right."""

from fractions import Fraction

import pytest

from kindsl.rigid.body import MassDistribution
from kindsl.rules.inertia.slips import Hypothesis, Slip
from kindsl.rules.inertia.told import clause, title
from kindsl.rules.inertia.wording import sum_below, with_unit

BODY = MassDistribution(1.0, (0.0, 0.0, 0.0), (1.0, 1.0, 1.0, 0.0, 0.0, 0.0))
RAISED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")
POWERS = [power for power in range(-12, 13) if power]


def scaled(slip: Slip, power: int, unit: str = "") -> Hypothesis:
    return Hypothesis((slip,), BODY, BODY, 1.0, power=power, unit=unit)


@pytest.mark.parametrize("power", POWERS)
def test_a_title_names_the_power(power: int) -> None:
    told = title(scaled(Slip.SCALE, power))
    assert told.startswith("Multiply the moments by 10")
    assert int(told.removeprefix("Multiply the moments by 10").translate(RAISED)) == power


@pytest.mark.parametrize("power", POWERS)
@pytest.mark.parametrize(("slip", "what"), [(Slip.SCALE, "moments"), (Slip.MASS, "mass")])
def test_a_clause_names_the_factor(slip: Slip, what: str, power: int) -> None:
    told = clause(scaled(slip, power))
    if slip is Slip.MASS and power == -3:
        assert told == "the mass were in g"
        return
    head, number = told.rsplit(" ", 1)
    factor = Fraction(int(number)) if "multiplied" in told else 1 / Fraction(int(number))
    assert head in (f"the {what} were multiplied by", f"the {what} were divided by")
    assert factor == Fraction(10) ** power and int(number) > 1


def test_a_unit_is_named_instead() -> None:
    of_unit = scaled(Slip.SCALE, -9, "g·mm²")
    assert clause(of_unit) == "the moments were in g·mm²"
    assert title(of_unit) == "Convert the moments to kg·m²"


@pytest.mark.parametrize(
    ("value", "told"),
    [
        (-0.1652, "-0.165 m"),
        (1234.5, "1230 m"),
        (9999.0, "10 000 m"),
        (40049.0, "40 000 m"),
        (-2.5e6, "-2 500 000 m"),
        (6.5e-11, "6.5e-11 m"),
        (999.4e6, "999 000 000 m"),
        (1e9, "1e+09 m"),
        (1.5e9, "1.5e+09 m"),
        (1e12, "1e+12 m"),
    ],
)
def test_large_quantities_are_written_out(value: float, told: str) -> None:
    assert with_unit(value, "m") == told


@pytest.mark.parametrize(
    ("left", "right", "told"),
    [
        ((0.1, 0.2), 0.31, "0.1 + 0.2 < 0.31"),
        ((0.12345, 0.2), 0.5, "0.123 + 0.2 < 0.5"),
        ((0.1, 0.2), 0.30001, "0.1 + 0.2 < 0.30001"),
        ((0.1, 0.15), 0.2501, "0.1 + 0.15 < 0.2501"),
        ((-0.4, 0.1), -0.2, "-0.4 + 0.1 < -0.2"),
        # What is left of zero after rounding: a million-millionth of the sum, at most.
        ((1e-18, 0.1), 0.2, "0 + 0.1 < 0.2"),
        ((1e-12, 0.5), 1.0, "0 + 0.5 < 1"),
        ((1e-10, 500.0), 1000.0, "0 + 500 < 1e+03"),
        ((2e-9, 500.0), 1000.0, "2e-09 + 500 < 1e+03"),
        # Sixteen digits at most, whatever they show.
        ((1.0 / 3.0,), 1.0 / 3.0, "0.3333333333333333 < 0.3333333333333333"),
    ],
)
def test_a_sum_is_told_with_as_many_digits_as_show_that_it_is_below(
    left: tuple[float, ...], right: float, told: str
) -> None:
    assert sum_below(left, right) == told
    assert sum_below(left, right, "<=") == told.replace("<", "<=")
