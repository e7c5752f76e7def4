"""What the second moments say of a body, in any orientation and unit, as written and rounded."""

from itertools import combinations

from hypothesis import given, settings
from hypothesis import strategies as st

from kindsl.judgement.diagnosis.judgements import Verdict, verdict_of
from kindsl.mechanics.rigid.body import (
    MassDistribution,
    eigensystem,
    moments_of,
    second_moments_about_com,
    seen_from,
)
from kindsl.mechanics.rigid.pose import Vector3, pose_from

steady = settings(max_examples=80, deadline=None, derandomize=True)
extents = st.floats(0.01, 1.0)
small = st.floats(0.05, 0.9)
turns = st.tuples(*[st.floats(-3.0, 3.0)] * 3)
units = st.integers(-20, 20).map(lambda power: 2.0**power)


def body_with(values: Vector3, turned: Vector3, unit: float) -> MassDistribution:
    """A body with these second moments about a CoM away from the origin."""
    a, b, c = (value * unit for value in values)
    about_com = MassDistribution(unit, (0.0, 0.0, 0.0), moments_of((a, b, c, 0.0, 0.0, 0.0)))
    return seen_from(about_com, pose_from((0.1, -0.2, 0.3), turned))


def verdict(body: MassDistribution, half_of_moments: float) -> Verdict:
    half = MassDistribution(0.0, (0.0, 0.0, 0.0), (half_of_moments,) * 6)
    return verdict_of(body, half, eigensystem(second_moments_about_com(body)))


@steady
@given(st.tuples(extents, extents, extents), turns, units)
def test_a_body_with_extent_is_possible(values: Vector3, turned: Vector3, unit: float) -> None:
    body = body_with(values, turned, unit)
    assert verdict(body, 0.0) is Verdict.POSSIBLE
    assert verdict(body, unit) is Verdict.POSSIBLE


@steady
@given(extents, extents, turns, units, st.sampled_from((1e-13, 0.0, -1e-13)))
def test_a_plate_is_singular(
    one: float, other: float, turned: Vector3, unit: float, dust: float
) -> None:
    body = body_with((dust, one, other), turned, unit)
    assert verdict(body, 0.0) is Verdict.SINGULAR


@steady
@given(extents, extents, small, turns, units)
def test_one_moment_greater_than_the_others_together_breaks_the_triangle(
    one: float, other: float, share: float, turned: Vector3, unit: float
) -> None:
    negative = -share * min(one, other)
    body = body_with((negative, one, other), turned, unit)
    assert verdict(body, 0.0) is Verdict.TRIANGLE
    assert verdict(body, 4.0 * unit * -negative) is Verdict.WITHIN_ROUNDING


@steady
@given(extents, extents, small, turns, units)
def test_a_negative_moment_is_indefinite_unless_rounding_may_have_made_it(
    one: float, other: float, share: float, turned: Vector3, unit: float
) -> None:
    values = (-(1.0 + share) * min(one, other), one, other)
    body = body_with(values, turned, unit)
    assert min(a + b for a, b in combinations(values, 2)) < 0.0
    assert verdict(body, 0.0) is Verdict.INDEFINITE
    assert verdict(body, 10.0 * unit) is Verdict.WITHIN_ROUNDING
