"""How mistakes and quantities are put into words: powers of ten are those that fix the numbers."""

from fractions import Fraction
from math import pi
from typing import Any

import pytest

from kindsl.judgement.diagnosis.evidence import MassShape
from kindsl.judgement.diagnosis.judge import Cause
from kindsl.judgement.diagnosis.slips import Hypothesis, Slip
from kindsl.judgement.rules.inertia.told import (
    clause,
    is_plausible,
    likely_cause,
    rivals,
    shared_cause,
    title,
)
from kindsl.language.text.quantities import sum_below, with_unit
from kindsl.mechanics.rigid.body import MassDistribution, eigensystem
from kindsl.mechanics.rigid.pose import Vector3

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
    head, number = told.rsplit(" ", 1)
    factor = Fraction(int(number)) if "multiplied" in told else 1 / Fraction(int(number))
    assert head in (f"the {what} were multiplied by", f"the {what} were divided by")
    assert factor == Fraction(10) ** power and int(number) > 1


def test_a_unit_is_named_instead() -> None:
    of_unit = scaled(Slip.SCALE, -9, "g·mm²")
    assert clause(of_unit) == "the moments were in g·mm²"
    assert title(of_unit) == "Convert the moments to kg·m²"
    in_grams = scaled(Slip.MASS, -3, "g")
    assert clause(in_grams) == "the mass were in g"
    assert title(in_grams) == "Convert the mass to kg"
    assert title(scaled(Slip.MASS, -1)) == "Multiply the mass by 10⁻¹"


def of(*slips: Slip, names: tuple[str, ...] = (), **given: Any) -> Hypothesis:
    return Hypothesis(slips, BODY, BODY, 1.0, names, **given)


@pytest.mark.parametrize(
    ("h", "what", "step"),
    [
        (
            of(Slip.REFERENCE),
            "the moments were taken about the CoM rather than the frame origin",
            "Shift the moments to the frame origin",
        ),
        (of(Slip.SIGNS, names=("Ixy",)), "the sign of Ixy were changed", "Change sign of Ixy"),
        (
            of(Slip.SIGNS_THERE, names=("Ixy", "Iyz")),
            "the signs of Ixy and Iyz were changed about the CoM",
            "Change sign of Ixy, Iyz about the CoM",
        ),
        (
            of(Slip.COM_SIGN, names=("the x of the CoM",)),
            "the sign of the x of the CoM were changed",
            "Change sign of the x of the CoM",
        ),
        (
            of(Slip.REFERENCE, Slip.SIGNS, names=("Ixy", "Iyz")),
            "the moments were taken about the CoM rather than the frame origin"
            " and the signs of Ixy and Iyz were changed",
            "Shift the moments to the frame origin and change sign of Ixy, Iyz",
        ),
    ],
)
def test_slips_are_told_in_words(h: Hypothesis, what: str, step: str) -> None:
    assert clause(h) == what
    assert title(h) == step


@pytest.mark.parametrize(
    ("h", "what", "step"),
    [
        (of(Slip.SWAP, names=("Ix", "Iz")), "Ix and Iz were swapped", "Swap Ix and Iz"),
        (
            of(Slip.COM_ORDER, names=("x", "z of the CoM")),
            "x and z of the CoM were swapped",
            "Swap x and z of the CoM",
        ),
        (
            of(Slip.ROWS),
            "the moments were in the order xx xy xz yy yz zz",
            "Put the moments in order",
        ),
        (
            of(Slip.AXES, names=("y, z and x",)),
            "the moments were about the axes y, z and x",
            "Turn the moments to the link's axes",
        ),
        (
            of(Slip.TWICE),
            "the moments were shifted to the frame origin once, not twice",
            "Shift the moments back once",
        ),
        (of(Slip.COM_UNIT, unit="cm"), "the CoM were in cm", "Convert the CoM to m"),
        (of(Slip.MOMENT, names=("Iy",), power=-1), "Iy were divided by 10", "Multiply Iy by 10⁻¹"),
        (
            of(Slip.PLACEHOLDER, names=("0.001",)),
            "is a placeholder: Ix, Iy and Iz are all 0.001",
            "",
        ),
        (
            of(Slip.COPY, names=("hand", "moments")),
            "has the moments of 'hand', which is another part",
            "",
        ),
    ],
)
def test_what_stands_in_another_place_is_named(h: Hypothesis, what: str, step: str) -> None:
    assert clause(h) == what
    assert title(h) == step


def ball(com: Vector3, *reasons: str, slip: Slip = Slip.REFERENCE, tilt: float = 0.0) -> Cause:
    """Return what explains a ball of 1 m and 1000 kg/m³; a fifth of `m r r` in each direction."""
    mass = 1000.0 * 4.0 / 3.0 * pi
    matrix = (mass / 5.0, mass / 5.0, mass / 5.0, tilt, 0.0, 0.0)
    h = of(slip, names=("Ixy",))._replace(body=BODY._replace(mass=mass, com=com))
    shape = MassShape(matrix, (0.0,) * 6, eigensystem(matrix))
    return Cause(h, shape, reasons, 0.0, 0.0, probability=0.9)


REFERENCE = "the moments were taken about the CoM rather than the frame origin"
ALONG = ", principal axes along the link's"


@pytest.mark.parametrize(
    ("com", "tilt", "along"),
    [
        ((0.0, 0.0, 0.0), 0.0, ""),
        ((0.1, 0.0, 0.0), 0.0, ""),  # about this point too the products are zero
        ((0.1, 0.2, 0.0), 0.0, ALONG),
        ((0.1, 0.0, 0.2), 0.0, ALONG),
        ((0.0, 0.1, 0.2), 0.0, ALONG),
        ((0.0, 0.1, 0.2), 9.0, ""),
    ],
)
def test_axes_along_the_links_speak_for_a_cause_where_the_com_lies_off_them(
    com: Vector3, tilt: float, along: str
) -> None:
    told = likely_cause("inertia of 'arm'", [ball(com, "long", tilt=tilt)], " at m = 2")
    assert told == (
        f"inertia of 'arm' would be consistent if {REFERENCE} at m = 2"
        f" (density 1000 kg/m³{along}, long)"
    )
    assert rivals([ball(com, "long")]) == []


def test_of_several_causes_what_speaks_for_all_of_them_is_left_out() -> None:
    com = (0.0, 0.0, 0.0)
    one, two = ball(com, "long", "near"), ball(com, "near", "equal", slip=Slip.SIGNS)
    causes = [one._replace(probability=0.5), two, ball(com, "near")]
    assert likely_cause("inertia of 'arm'", causes, " at m = 2") == (
        f"inertia of 'arm' would most likely be consistent if {REFERENCE} at m = 2"
        " (density 1000 kg/m³, long)"
    )
    assert rivals(causes) == [
        "or if the sign of Ixy were changed (density 1000 kg/m³, equal)",
        f"or if {REFERENCE} (density 1000 kg/m³)",
    ]


@pytest.mark.parametrize(
    ("probability", "verb"),
    [
        (0.9, "would be"),
        (0.899, "would most likely be"),
        (0.5, "would most likely be"),
        (0.499, "might be"),
    ],
)
def test_words_are_as_sure_as_the_cause_is(probability: float, verb: str) -> None:
    cause = ball((0.0, 0.0, 0.0))._replace(probability=probability)
    assert f"inertia of 'arm' {verb} consistent if {REFERENCE}" in likely_cause(
        "inertia of 'arm'", [cause]
    )


def test_that_a_body_is_long_does_not_make_it_plausible() -> None:
    light = ball((0.0, 0.0, 0.0), "long towards its next joint")
    light = light._replace(hypothesis=light.hypothesis._replace(body=BODY._replace(mass=9.0)))
    assert not is_plausible(light)
    assert is_plausible(light._replace(log_likelihood=3.0))  # by what its counterparts say


def test_what_leaves_no_trace_is_told_without_reasons() -> None:
    placeholder = ball((0.0, 0.0, 0.0), slip=Slip.PLACEHOLDER)
    told = "is a placeholder: Ix, Iy and Iz are all Ixy"
    assert likely_cause("inertia of 'arm'", [placeholder]) == f"inertia of 'arm' {told}"
    assert rivals([ball((0.0, 0.0, 0.0)), placeholder]) == [f"or it {told}"]


@pytest.mark.parametrize(
    ("h", "what"),
    [
        (of(Slip.REFERENCE), REFERENCE),
        (of(Slip.SIGNS, names=("Ixy",)), "the signs of the products were changed"),
        (of(Slip.SIGNS, names=("Ixy",), is_partial=True), "the sign of Ixy were changed"),
        (of(Slip.COM_SIGN, names=("the x",), is_partial=True), "the sign of the x were changed"),
    ],
)
def test_what_all_links_show_is_told_without_their_names(h: Hypothesis, what: str) -> None:
    cause = ball((0.0, 0.0, 0.0))._replace(hypothesis=h)
    expected = f"inertias of all 4 moving links would be consistent if {what}"
    assert shared_cause(4, cause) == expected


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
