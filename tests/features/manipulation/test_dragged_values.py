"""What a drag writes, form by form."""

from math import pi

import pytest

from kindsl.frontends.features.manipulation.gesture import Refusal
from kindsl.frontends.features.manipulation.set_component import ComponentChange, set_component
from kindsl.frontends.features.manipulation.things import Thing
from kindsl.frontends.features.manipulation.value_text import fraction_of_pi, number_text
from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.semantics.parameters import Binding

ROBOT = """\
Robot r {{ RobotBase base {{ children {{ a via j }} }}
link a {{ id = 1 children {{}} frames {{ {frames} }} }}
r_joint j {{ ref_frame {{ translation = ({x}, 0.5, 0.0) rotation = ({rx}, 0.0, 0.0) }} }} }}
"""
J = Thing("joint", "j")
FRAME = "{} {{ translation = ({}, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) }}"


def robot(x: str = "0.0", rx: str = "0.0", frames: str = "") -> Analysis:
    return analyse(ROBOT.format(x=x, rx=rx, frames=frames))


@pytest.mark.parametrize(
    ("value", "step"),
    [
        (float("nan"), None),
        (float("inf"), 0.1),
        (0.5, 0.0),
        (0.5, -0.1),
        (0.5, float("inf")),
        (0.5, float("nan")),
    ],
)
def test_no_number_is_refused(value: float, step: float | None) -> None:
    assert set_component(robot(), J, "x", value, step) == Refusal(
        "a component takes a finite number"
    )


@pytest.mark.parametrize(
    ("old", "value", "is_written"),
    [
        ("0.5", 0.5, False),
        ("0.5", 0.5 + 4e-13, False),
        ("0.5", 0.5 + 2e-9, True),
        ("5000.0", 5000.0 + 4e-9, False),
        ("5000.0", 5000.0 + 6e-9, True),
    ],
)
def test_a_value_that_is_there_already_is_not_written(
    old: str, value: float, is_written: bool
) -> None:
    change = set_component(robot(old), J, "x", value)
    assert isinstance(change, ComponentChange)
    assert bool(change.edits) == is_written
    if not is_written:
        assert (change.text, change.value) == (old, float(old))


@pytest.mark.parametrize(
    ("value", "old", "text"),
    [
        (0.5, "0.250", "0.500"),
        (0.5, "0.25", "0.50"),
        (0.5, "1.", "0.5"),
        (0.5, "x.25", "0.50"),
        (0.5, "2e-1.5e0", "0.5"),
        (3.0, "2", "3.0"),
        (0.5, "0.123456789012", "0.5000000000"),
        (1e-11, "0.5", "0.0"),
        (-1e-11, "0.5", "0.0"),
        (-2e-10, "0.5", "-0.0000000002"),
        (123456.25, "0.5", "123456.25"),
    ],
)
def test_a_number_keeps_its_decimals(value: float, old: str, text: str) -> None:
    assert number_text(value, old) == (text, float(text))


@pytest.mark.parametrize(
    ("old", "degrees", "new"),
    [("0.0", 45, "PI/4.0"), ("2.0*PI", 90, "PI/2.0"), ("2.0 PI", 90, "PI/2.0"),
     ("-PI", 90, "PI/2.0"), ("0.50", 90, "1.5707963268"), ("1.0/2.0", 90, "1.5707963268")],
)  # fmt: skip
def test_an_angle_is_a_fraction_of_pi_where_it_was_one(old: str, degrees: int, new: str) -> None:
    change = set_component(robot(rx=old), J, "rx", pi * degrees / 180.0)
    assert isinstance(change, ComponentChange)
    assert change.text == new


def test_a_length_is_no_fraction_of_pi() -> None:
    change = set_component(robot(), J, "x", pi / 2.0)
    assert isinstance(change, ComponentChange)
    assert change.text == "1.5707963268"


@pytest.mark.parametrize(
    ("value", "text"),
    [(pi / 1.234, "PI/1.234"), (pi / 1.2345, None), (pi / 359.0, "PI/359.0"), (1e-12, None),
     (9e-13, "0.0"),
     (pi / 2.0 + 1e-13, "PI/2.0"), (pi / 2.0 + 1e-11, None), (-pi, "-PI"), (pi / 0.4, "PI/0.4")],
)  # fmt: skip
def test_a_fraction_of_pi_is_exact_and_short(value: float, text: str | None) -> None:
    found = fraction_of_pi(value)
    assert (found and found.text) == text
    assert found is None or abs(found.value - value) < 1e-12


def bound(x: str, minimum: float | None, maximum: float | None) -> Analysis:
    settings = Settings(bindings={"x": Binding(1.0, minimum, maximum)})
    return analyse(ROBOT.format(x=x, rx="0.0", frames=""), settings)


@pytest.mark.parametrize(
    ("minimum", "maximum", "value", "is_taken"),
    [
        (0.5, None, 0.5, True),
        (0.5, None, 0.4999, False),
        (0.5, None, 50.0, True),
        (None, 0.5, 0.5, True),
        (None, 0.5, 0.5001, False),
        (None, 0.5, -50.0, True),
        (None, None, 50.0, True),
    ],
)
def test_a_bound_parameter_stays_in_its_bounds(
    minimum: float | None, maximum: float | None, value: float, is_taken: bool
) -> None:
    change = set_component(bound("-2.0*x", minimum, maximum), J, "x", -2.0 * value)
    if is_taken:
        assert change == ComponentChange(
            "Set x of joint 'j'", change.text, -2.0 * value, bindings=(("x", value),)
        )
    else:
        assert change == Refusal(f"parameter 'x' would be out of bounds at {value}")


def test_a_typed_value_wins_over_a_binding_and_a_default() -> None:
    """What the preview's own field holds is changed there, and no file."""
    for analysis in (bound("2.0*x", 0.0, 1.0), robot("2.0*x[1.0]")):
        change = set_component(analysis, J, "x", 5.0, typed={"x": 1.0})
        assert change == ComponentChange("Set x of joint 'j'", "2.5", 5.0, preview=(("x", 2.5),))


def test_only_defaults_of_the_value_in_force_are_rewritten() -> None:
    analysis = robot("x[1.0]", frames=FRAME.format("f", "-x[1.0]") + FRAME.format("g", "x[2.0]"))
    text = analysis.edited(set_component(analysis, J, "x", 0.5).edits).text
    assert "(x[0.5], 0.5" in text and "(x[2.0]" in text and "(-x[0.5]" in text
    analysis = robot("<k=1.0>", frames=FRAME.format("f", "<k=2.0>"))
    text = analysis.edited(set_component(analysis, J, "x", 0.5).edits).text
    assert "(<k=0.5>, 0.5" in text and "(<k=2.0>" in text


def test_a_constant_is_written_where_it_is_defined() -> None:
    analysis = robot("2.0*<k>", frames=FRAME.format("e", "<l=1.0>") + FRAME.format("f", "<k=1.0>"))
    change = set_component(analysis, J, "x", 3.0)
    assert (change.text, change.value) == ("1.5", 3.0)
    assert "(<k=1.5>," in analysis.edited(change.edits).text
    assert set_component(robot("<k>"), J, "x", 3.0) == Refusal("constant 'k' is not defined")


def test_what_cannot_be_solved_is_refused() -> None:
    refused = Refusal("'0.0*x' cannot be solved for one name")
    assert set_component(robot("0.0*x"), J, "x", 3.0) == refused


def test_a_product_with_a_minus_is_solved_like_one_with_a_star() -> None:
    """What `2.0 -x` means for robcogen, the one generator that takes it."""
    change = set_component(robot("2.0 -x"), J, "x", 3.0)
    assert change == ComponentChange("Set x of joint 'j'", "-1.5", 3.0, preview=(("x", -1.5),))


def test_a_new_form_of_the_same_text_edits_nothing() -> None:
    """The value changes by less than is written."""
    change = set_component(robot("0.5"), J, "x", 0.5 + 2e-12)
    assert change == ComponentChange("Set x of joint 'j'", "0.5", 0.5)
