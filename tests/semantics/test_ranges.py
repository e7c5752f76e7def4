"""Bounds and degrees of values, against the values themselves and against polynomials."""

from itertools import product
from typing import NamedTuple

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from tests.semantics.placed import expression

from kindsl.language.semantics.ranges import Interval, bounds_of, degrees_of

Monomials = frozenset[tuple[int, int]]

K = 0.75


class Written(NamedTuple):
    """A value as text, and the monomials of its polynomial in x and y; None if it is none."""

    text: str
    monomials: Monomials | None


_ONE, _X, _Y = frozenset({(0, 0)}), frozenset({(1, 0)}), frozenset({(0, 1)})
NUMBERS = [Written(text, _ONE) for text in ("2.0", "0.5", "3", "PI", "2.0 PI", "<k>", "<c=1.5>")]
USES = [Written(text, _X) for text in ("x", "2.0 x", "x[7.0]", "^x")] + [Written("y", _Y)]


def one_operand(inner: Written) -> st.SearchStrategy[Written]:
    signs = st.sampled_from(("", "-", "+"))
    return signs.map(lambda sign: Written(f"{sign}({inner.text})", inner.monomials))


def two_operands(operands: tuple[Written, Written]) -> st.SearchStrategy[Written]:
    left, right = operands
    text = f"({left.text})%s({right.text})"
    quotient = left.monomials if right.monomials == _ONE else None
    made = [Written(text % "/", quotient)]
    if left.monomials is None or right.monomials is None:
        made += [Written(text % sign, None) for sign in "+-*"]
    else:
        made += [Written(text % sign, left.monomials | right.monomials) for sign in "+-"]
        made += [Written(text % "*", product_of(left.monomials, right.monomials))]
    return st.sampled_from(made)


def product_of(left: Monomials, right: Monomials) -> Monomials:
    return frozenset((a + c, b + d) for (a, b), (c, d) in product(left, right))


written = st.recursive(
    st.sampled_from([*NUMBERS, *USES]),
    lambda inner: inner.flatmap(one_operand) | st.tuples(inner, inner).flatmap(two_operands),
    max_leaves=5,
)
numbers = st.floats(-4.0, 4.0).map(lambda value: round(value, 2))
intervals = st.tuples(numbers, numbers).map(lambda ends: (min(ends), max(ends)))
steady = settings(deadline=None, derandomize=True, max_examples=80)


def value(text: str, x: float, y: float) -> float | None:
    return expression(text).value({"x": x, "y": y, "<k>": K})


def bounds(text: str, x: Interval, y: Interval) -> Interval | None:
    return bounds_of(expression(text), {"x": x, "y": y, "<k>": (K, K)})


@steady
@given(written, numbers, numbers)
def test_bounds_at_a_point_are_the_value_there(what: Written, x: float, y: float) -> None:
    expected = value(what.text, x, y)
    found = bounds(what.text, (x, x), (y, y))
    if expected is None:
        assert found is None
    else:
        assert found == pytest.approx((expected, expected), rel=1e-9, abs=1e-9)


@steady
@given(written, intervals, intervals)
def test_bounds_are_reached_where_each_name_is_used_once(
    what: Written, x: Interval, y: Interval
) -> None:
    assume(what.text.count("x") <= 1 and what.text.count("y") <= 1)
    found = bounds(what.text, x, y)
    if found is not None:
        corners = [value(what.text, *corner) for corner in product(x, y)]
        known = [corner for corner in corners if corner is not None]
        assert len(known) == 4
        assert found == pytest.approx((min(known), max(known)), rel=1e-9, abs=1e-9)


@steady
@given(written, intervals, intervals, st.floats(0.0, 1.0), st.floats(0.0, 1.0))
def test_bounds_hold_inside(
    what: Written, x: Interval, y: Interval, right: float, up: float
) -> None:
    found = bounds(what.text, x, y)
    if found is not None:
        inside = value(what.text, *(a + t * (b - a) for (a, b), t in ((x, right), (y, up))))
        assert inside is not None
        near = 1e-9 * (1.0 + abs(inside))
        assert found[0] - near <= inside <= found[1] + near


def test_a_product_that_looks_like_a_difference_is_bounded_as_robcogen_reads_it() -> None:
    assert value("2.0 - x", 1.5, 0.0) == -3.0
    assert bounds("2.0 - x", (1.0, 2.0), (0.0, 0.0)) == (-4.0, -2.0)


@pytest.mark.parametrize("text", ["x", "2.0 x", "-x", "x*2.0", "1.0/x", "<k>", "x + 1.0"])
def test_nothing_bounds_what_is_not_known(text: str) -> None:
    assert bounds_of(expression(text), {"y": (0.0, 1.0)}) is None


def test_nothing_is_known_of_what_is_too_long_to_be_read() -> None:
    """Else a range in `kindsl.toml` makes such a document an internal error."""
    long = expression("2.0*" * 3000 + "x")
    assert bounds_of(long, {"x": (0.0, 1.0)}) is None
    assert degrees_of(long, frozenset("x")) is None


def test_what_has_no_name_is_what_stands_in_it() -> None:
    assert bounds("PI[x]*2.0", (0.5, 1.0), (0.0, 0.0)) == (1.0, 2.0)
    assert degrees_of(expression("PI[x]*x"), frozenset("x")) == {"x": 2}


@pytest.mark.parametrize("divisor", [(-1.0, 1.0), (0.0, 1.0), (-1.0, 0.0)])
def test_nothing_bounds_a_quotient_by_what_may_be_zero(divisor: Interval) -> None:
    assert bounds("1.0/x", divisor, (0.0, 0.0)) is None


@steady
@given(written)
def test_degrees_are_those_of_the_polynomial(what: Written) -> None:
    degrees = degrees_of(expression(what.text), frozenset("xy"))
    if what.monomials is None:
        assert degrees is None
    else:
        assert degrees is not None
        expected = tuple(map(max, zip(*what.monomials, strict=True)))
        assert (degrees.get("x", 0), degrees.get("y", 0)) == expected


@steady
@given(written)
def test_other_names_are_numbers(what: Written) -> None:
    degrees = degrees_of(expression(what.text.replace("/", "*")), frozenset("x"))
    alone = degrees_of(expression(what.text.replace("/", "*").replace("y", "3")), frozenset("xy"))
    assert degrees == alone
    assert degrees is not None and set(degrees) <= {"x"}
