"""Moments that move along with a centre of mass: the body stays the same."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.features.samples import ARM

from kindsl.frontends.features.manipulation.carried_moments import carried_moments
from kindsl.frontends.features.manipulation.set_component import ComponentChange, set_component
from kindsl.frontends.features.manipulation.things import Thing
from kindsl.judgement.analysis.analysis import analyse
from kindsl.mechanics.rigid.body import second_moments_about_com
from kindsl.robots.mechanism.link_inertia import written_inertia

MOVES = st.lists(st.tuples(st.sampled_from("xyz"), st.integers(-200, 200)), min_size=1, max_size=4)


def body_of(analysis):
    return written_inertia(analysis.model.body_named["upper"].inertia, {})


@given(MOVES)
@settings(deadline=None, derandomize=True)
def test_the_moments_about_the_com_stay(moves):
    analysis = analyse(ARM)
    before = body_of(analysis)
    for component, value in moves:
        change = set_component(analysis, Thing("com", "upper"), component, value / 100)
        assert isinstance(change, ComponentChange)
        carried = carried_moments(analysis, "upper", component, change.value)
        analysis = analysis.edited(tuple(sorted((*change.edits, *carried))))
    after = body_of(analysis)
    component, value = moves[-1]
    assert after.com["xyz".index(component)] == value / 100
    assert second_moments_about_com(after) == pytest.approx(
        second_moments_about_com(before), abs=1e-12
    )
