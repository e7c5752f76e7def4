"""How far a value may be from the written one, where each number is off by half a unit."""

from typing import NamedTuple

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.semantics.placed import expression

from kindsl.language.semantics.expressions import half_unit

BOUND = {"x": 1.75}
STEP = 1e-3


class Written(NamedTuple):
    """A value with a place for each of its numbers, and these as written."""

    template: str
    numbers: tuple[str, ...]


leaves = st.sampled_from(
    [Written("{}", (text,)) for text in ("2.5", "0.125", "30.0", "7.25", "12", "1.5e1")]
    + [Written(text, ("2.5",)) for text in ("{} x", "{} PI")]
    + [Written(text, ()) for text in ("x", "PI")]
)


def one_operand(inner: Written) -> st.SearchStrategy[Written]:
    return st.sampled_from(("", "-", "+")).map(
        lambda sign: Written(f"{sign}({inner.template})", inner.numbers)
    )


def two_operands(left: Written, sign: str, right: Written) -> Written:
    return Written(f"({left.template}){sign}({right.template})", left.numbers + right.numbers)


def larger(inner: st.SearchStrategy[Written]) -> st.SearchStrategy[Written]:
    return st.one_of(
        inner.flatmap(one_operand),
        st.builds(two_operands, inner, st.sampled_from("+-*"), inner),
        st.builds(two_operands, inner, st.just("/"), leaves),
    )


def value(what: Written, moved: int, by: float) -> float:
    numbers = [
        repr(float(text) + by * half_unit(text)) if place == moved else text
        for place, text in enumerate(what.numbers)
    ]
    found = expression(what.template.format(*numbers)).value(BOUND)
    assert found is not None
    return found


@settings(deadline=None, derandomize=True, max_examples=60)
@given(st.recursive(leaves, larger, max_leaves=5))
def test_rounding_is_what_half_units_make_of_the_value(what: Written) -> None:
    found = expression(what.template.format(*what.numbers)).rounding(BOUND)
    expected = sum(
        abs(value(what, place, STEP) - value(what, place, -STEP)) / (2.0 * STEP)
        for place in range(len(what.numbers))
    )
    assert found == pytest.approx(expected, rel=1e-3, abs=1e-9)


def test_a_quotient_by_zero_has_no_rounding() -> None:
    assert expression("1.0/0.0").rounding({}) == 0.0


@pytest.mark.parametrize(("n_decimals", "power"), [(1, -1), (299, -299), (300, -300), (305, -300)])
def test_no_number_is_exact_beyond_three_hundred_decimals(n_decimals: int, power: int) -> None:
    found = half_unit(f"0.{'1' * n_decimals}")
    assert found == pytest.approx(0.5 * 10.0**power, rel=1e-12, abs=0.0)
