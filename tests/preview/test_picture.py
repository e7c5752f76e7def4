"""Which bodies stand there while someone types."""

import pytest
from tests.preview.robots import ARM, BROKEN_ARM, PARAMETRIC_ARM, skeleton_of

from kindsl.analysis.analysis import analyse
from kindsl.preview.scene.picture import State, picture


def picture_of(text, given=None, last_good=None):
    analysis = analyse(text)
    return picture(analysis.model, {**analysis.context.values, **(given or {})}, last_good)


def test_a_good_document_is_drawn():
    drawn = picture_of(ARM)
    assert (drawn.state, drawn.message) == (State.LIVE, "")
    assert drawn.skeleton.link_names == ("upper", "slider")


@pytest.mark.parametrize(
    "broken",
    [
        pytest.param(BROKEN_ARM, id="syntax"),
        pytest.param(ARM.replace("slider via", "slidr via"), id="undefined link"),
        pytest.param(ARM.replace("via lift", "via lfit"), id="undefined joint"),
        pytest.param(ARM.replace("children {}", "children { upper via lift }"), id="loop"),
        pytest.param(ARM.replace("        slider via lift\n", ""), id="unreachable"),
        pytest.param(ARM.replace("(0.4, 0.0, 0.0)", "(0.4, 0.0)"), id="two components"),
        pytest.param("", id="empty"),
    ],
)
def test_the_last_complete_version_stays(broken):
    last = skeleton_of(ARM)
    drawn = picture_of(broken, last_good=last)
    assert drawn.skeleton is last
    assert drawn.state is State.BROKEN
    assert drawn.message.endswith("the last complete version is shown")


def test_what_there_is_is_shown_where_nothing_was_before():
    drawn = picture_of(ARM.replace("children {}", "children { upper via lift }"))
    assert drawn.skeleton.link_names == ("upper", "slider")
    assert "what there is of it is shown" in drawn.message


def test_fragments_without_values_count_as_zero():
    text = ARM.replace("(0.4, 0.0, 0.0)", "(0.4, 0.0)").replace("mass = 1.0", "mass = 1.0/0.0")
    drawn = picture_of(text)
    assert _places(drawn) == [(0.0, 0.0, 0.5), (0.4, 0.0, 0.0)]
    assert [body.mass for body in drawn.skeleton.masses] == [0.0, 2.0, 0.0]


def test_nothing_can_be_shown_of_nothing():
    drawn = picture_of("")
    assert drawn.skeleton is None
    assert drawn.message.endswith("nothing can be shown yet")


def test_an_unbound_length_is_told_and_counts_as_zero():
    drawn = picture_of(PARAMETRIC_ARM)
    assert drawn.state is State.UNBOUND
    assert "'reach'" in drawn.message
    assert _places(drawn)[1] == (0.0, 0.0, 0.0)


def test_a_value_binds_it():
    drawn = picture_of(PARAMETRIC_ARM, {"reach": 0.7})
    assert drawn.state is State.LIVE
    assert _places(drawn)[1] == (0.7, 0.0, 0.0)


def test_an_unbound_mass_is_told_but_the_picture_is_good():
    drawn = picture_of(ARM.replace("mass = 1.0", "mass = payload"))
    assert drawn.state is State.LIVE
    assert "'payload'" in drawn.message


def _places(drawn):
    return [pose.translation for pose in drawn.skeleton.placements]
