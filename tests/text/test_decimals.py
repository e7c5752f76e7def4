import re
from decimal import Decimal
from fractions import Fraction

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kindsl.language.text.decimals import (
    exact_decimal,
    fixed_decimal,
    rounded_decimal,
    significant_decimal,
)

finite = st.floats(allow_nan=False, allow_infinity=False)
sizes = st.floats(1e-9, 1e9) | st.floats(-1e9, -1e-9)
quick = settings(deadline=None, max_examples=300)


def _is_plain(text: str) -> bool:
    """Return whether both generators take it, and no digit in it is idle."""
    return re.fullmatch(r"-?\d+\.(\d*[1-9]|0)", text) is not None and text != "-0.0"


@quick
@given(finite)
def test_exact_numbers_are_read_again(value: float) -> None:
    text = exact_decimal(value)
    assert _is_plain(text)
    assert float(text) == value


@quick
@given(finite, st.integers(1, 15))
def test_all_writings_are_plain(value: float, digits: int) -> None:
    assert _is_plain(significant_decimal(value, digits))
    assert _is_plain(fixed_decimal(value, digits))
    assert _is_plain(rounded_decimal(value, 1.0))


@quick
@given(sizes, st.integers(1, 12))
def test_significant_digits_are_kept(value: float, digits: int) -> None:
    text = significant_decimal(value, digits)
    assert float(text) == pytest.approx(value, rel=0.51 * 10.0 ** (1 - digits))
    places = max(1, digits - Decimal(value).adjusted() - 1)
    assert len(text.partition(".")[2]) <= places


@quick
@given(sizes, st.integers(1, 15))
def test_decimals_are_counted_from_the_point(value: float, decimals: int) -> None:
    text = fixed_decimal(value, decimals)
    assert abs(Fraction(text) - Fraction(value)) <= Fraction(1, 2 * 10**decimals)
    assert len(text.partition(".")[2]) <= decimals


@quick
@given(sizes)
def test_computed_numbers_lose_their_dust(value: float) -> None:
    assert float(rounded_decimal(value, abs(value))) == pytest.approx(value, rel=1e-14)
    assert rounded_decimal(value, abs(value) * 2.4e15) != "0.0"
    assert rounded_decimal(value, abs(value) * 2.6e15) == "0.0"


@pytest.mark.parametrize(
    ("value", "text"),
    [(0.1 + 0.2, "0.3"), (-0.0, "0.0"), (1e-7, "0.0000001"), (1e20, "1" + "0" * 20 + ".0")],
)
def test_computed_numbers_are_written_without_noise(value: float, text: str) -> None:
    assert rounded_decimal(value, abs(value)) == text
