from math import pi

import pytest

from kindsl.frontends.features.wording import angle, number, quantity, vector
from kindsl.language.semantics.declarations import ValueKind


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (0.0, "0"),
        (-0.0, "0"),
        (2.0, "2"),
        (-1.23456, "-1.235"),
        (1e-20, "1e-20"),
        (-1e-20, "-1e-20"),
        (123456.0, "1.235e+05"),
    ],
)
def test_numbers_have_four_digits(value, text):
    assert number(value) == text


@pytest.mark.parametrize(
    ("values", "text"),
    [
        ((1.0, -6e-17, 0.0), "(1, 0, 0)"),
        ((1.0, 2e-12, 0.0), "(1, 2e-12, 0)"),
        ((-2.0, 1.5e-12, 0.0), "(-2, 0, 0)"),
        ((1e-14, 0.0, 0.0), "(1e-14, 0, 0)"),
        ((9e-16, 0.0, 0.0), "(0, 0, 0)"),
        ((-1e-3, 2e-15, 0.0), "(-0.001, 2e-15, 0)"),
        ((1e-12, 1.0, -1e-12), "(1e-12, 1, -1e-12)"),
    ],
)
def test_what_rounding_leaves_beside_larger_numbers_is_zero(values, text):
    assert vector(values) == text


def test_quantities_have_units():
    assert angle(-pi / 3.0) == "-60°"
    assert quantity(pi / 2.0, ValueKind.ANGLE) == "1.571 rad = 90°"
    assert quantity(0.5, ValueKind.LENGTH) == "0.5 m"
    assert quantity(0.5, ValueKind.LENGTH, "kg") == "0.5 m"
    assert quantity(0.5, ValueKind.DYNAMICS, "kg") == "0.5 kg"
    assert quantity(0.5, ValueKind.DYNAMICS) == "0.5"
