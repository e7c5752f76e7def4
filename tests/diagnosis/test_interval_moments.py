"""Bounds of second moments over intervals are reached, so that nothing is halved for nothing."""

from itertools import product

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kindsl.judgement.diagnosis.over_ranges import _second_moments
from kindsl.language.semantics.ranges import Interval
from kindsl.mechanics.rigid.body import MassDistribution, second_moments_about_com

places = st.floats(-2.0, 2.0)
intervals = st.tuples(places, places).map(lambda ends: (min(ends), max(ends)))
positive = st.tuples(st.floats(0.1, 5.0), st.floats(0.0, 2.0)).map(lambda p: (p[0], p[0] + p[1]))


@settings(max_examples=60, deadline=None, derandomize=True)
@given(positive, *[intervals] * 3, st.tuples(*[intervals] * 6))
def test_bounds_of_second_moments_are_reached(
    mass: Interval, x: Interval, y: Interval, z: Interval, moments: tuple[Interval, ...]
) -> None:
    found = _second_moments(mass, [x, y, z], list(moments))
    coms = [sorted({*axis, *([0.0] if axis[0] < 0.0 < axis[1] else [])}) for axis in (x, y, z)]
    for place, bounds in enumerate(found):
        reached = [
            second_moments_about_com(MassDistribution(m, com, chosen))[place]
            for m in mass
            for com in product(*coms)
            for chosen in _extremes(moments, place)
        ]
        assert bounds == pytest.approx((min(reached), max(reached)), abs=1e-12)


def _extremes(moments: tuple[Interval, ...], place: int) -> list[tuple[float, ...]]:
    """The moments at which the second moment in a place is smallest and greatest."""
    first, last = [0] * 6, [1] * 6
    if place < 3:
        first[place], last[place] = 1, 0
    return [tuple(m[end] for m, end in zip(moments, ends, strict=True)) for ends in (first, last)]
