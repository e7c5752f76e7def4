"""Which bodies stand there while someone types."""

import pytest
from tests.preview.robots import ARM, BROKEN_ARM, PARAMETRIC_ARM

from kindsl.judgement.analysis.analysis import analyse
from kindsl.robots.mechanism.total_mass import Weight
from kindsl.robots.scene.picture import PictureState, picture


def picture_of(text, given=None, last=None):
    analysis = analyse(text)
    return picture(analysis.model, {**analysis.context.values, **(given or {})}, last)


def test_a_good_document_is_drawn():
    drawn = picture_of(ARM)
    assert (drawn.state, drawn.message) == (PictureState.LIVE, "")
    assert drawn.skeleton.link_names == ("upper", "slider")


@pytest.mark.parametrize(
    "broken",
    [
        pytest.param(BROKEN_ARM, id="syntax"),
        pytest.param(ARM.replace("slider via", "slidr via"), id="undefined link"),
        pytest.param(ARM.replace("via lift", "via lfit"), id="undefined joint"),
        pytest.param(ARM.replace("children {}", "children { upper via lift }"), id="loop"),
        pytest.param(ARM.replace("        slider via lift\n", ""), id="unreachable"),
        pytest.param("", id="empty"),
    ],
)
def test_the_last_complete_version_stays(broken):
    last = picture_of(ARM)
    drawn = picture_of(broken, last=last)
    assert drawn.skeleton is last.skeleton
    assert drawn.state is PictureState.BROKEN
    assert drawn.is_former
    assert drawn.weight == last.weight == Weight(3.0)
    assert drawn.message.endswith("the last complete version is shown")


def test_a_pair_that_lacks_a_name_is_told_by_the_other():
    drawn = picture_of(BROKEN_ARM, last=picture_of(ARM))
    assert drawn.message == "Link 'slider' has no joint: the last complete version is shown"


def test_what_there_is_is_shown_where_nothing_was_before():
    drawn = picture_of(ARM.replace("children {}", "children { upper via lift }"))
    assert drawn.skeleton.link_names == ("upper", "slider")
    assert drawn.message.endswith("showing the rest")


def test_fragments_without_values_count_as_zero():
    text = ARM.replace("(0.4, 0.0, 0.0)", "(0.4, 0.0)").replace("mass = 1.0", "mass = 1.0/0.0")
    drawn = picture_of(text)
    assert _places(drawn) == [(0.0, 0.0, 0.5), (0.4, 0.0, 0.0)]
    assert [body.mass for body in drawn.skeleton.masses] == [0.0, 2.0, 0.0]


@pytest.mark.parametrize("mass", ["", "x", "1.0 -", "1,5"])
def test_a_mass_that_cannot_be_read_leaves_the_total_open(mass):
    drawn = picture_of(ARM.replace("mass = 1.0", f"mass = {mass}"), last=picture_of(ARM))
    assert not drawn.is_former
    assert (drawn.weight.known, drawn.weight.is_whole) == (2.0, False)
    assert set(drawn.unknown) == {"slider"}


def test_a_former_version_has_the_mass_that_it_had():
    last = picture_of(ARM.replace("mass = 1.0", "mass = x"))
    drawn = picture_of(BROKEN_ARM, last=last)
    assert drawn.is_former
    assert (drawn.weight, drawn.unknown) == (last.weight, last.unknown)
    assert not drawn.weight.is_whole
    assert not picture_of(BROKEN_ARM).is_former


def test_nothing_can_be_shown_of_nothing():
    drawn = picture_of("")
    assert drawn.skeleton is None
    assert drawn.message.endswith("nothing can be shown yet")


@pytest.mark.parametrize(
    "edited",
    [
        pytest.param(ARM.replace("mass = 1.0", "mass = 9"), id="KD005"),
        pytest.param(ARM.replace("mass = 1.0", "mass = (4.0 + 5.0)"), id="KD006"),
        pytest.param(ARM.replace("mass = 1.0", "mass = 9.0 9.0"), id="KD001"),
        pytest.param(
            ARM.replace("        mass = 1.0\n", "").replace(
                "CoM = (0.0, 0.0, 0.1)", "CoM = (0.0, 0.0, 0.1)\n mass = 9.0"
            ),
            id="KD007",
        ),
    ],
)
def test_a_defect_of_form_does_not_stop_the_picture(edited):
    drawn = picture_of(edited, last=picture_of(ARM))
    assert drawn.state is PictureState.LIVE
    assert drawn.skeleton.masses[2].mass == 9.0


@pytest.mark.parametrize("vector", ["(0.4, 0.0)", "(, 0.0, 0.0)", "(0.4, 0.0, 1.0/0.0)"])
def test_a_pose_that_is_not_whole_stays_where_it_was(vector):
    text = ARM.replace("(0.4, 0.0, 0.0)", vector).replace("(0.0, 0.0, 0.5)", "(0.0, 0.0, 0.7)")
    drawn = picture_of(text, last=picture_of(ARM))
    assert drawn.state is PictureState.LIVE
    assert _places(drawn) == [(0.0, 0.0, 0.7), (0.4, 0.0, 0.0)]
    assert drawn.message == "The pose of joint 'lift' is incomplete: drawn as far as known"


def test_what_is_too_large_to_be_measured_is_not_drawn():
    """The size of the robot would overflow."""
    drawn = picture_of(ARM.replace("(0.4, 0.0, 0.0)", "(1e308, 1e308, 0.0)"))
    assert drawn.skeleton is None
    assert drawn.message.startswith("Pose of joint 'lift' holds a value that is beyond 1e100")
    assert picture_of(ARM.replace("0.4, 0.0, 0.0", "1e90, 0.0, 0.0")).state is PictureState.LIVE


def test_a_length_without_a_value_is_the_robots_typical_one():
    drawn = picture_of(PARAMETRIC_ARM)
    assert drawn.state is PictureState.GUESSED
    assert drawn.message == "1 parameter has no value: drawn at a guess"
    assert _places(drawn)[1] == (0.5, 0.0, 0.0)
    assert (drawn.guesses.joints, drawn.guesses.frames) == ({"lift"}, frozenset())
    alone = picture_of(PARAMETRIC_ARM.replace("(0.0, 0.0, 0.5)", "(0.0, 0.0, height)"))
    assert _places(alone) == [(0.0, 0.0, 0.3), (0.3, 0.0, 0.0)]


def test_an_angle_without_a_value_is_zero():
    drawn = picture_of(ARM.replace("(-PI/2.0, 0.0, 0.0)", "(tilt, 0.0, 0.0)"))
    assert drawn.guesses.values == {"tilt": 0.0}


def test_a_value_binds_it():
    drawn = picture_of(PARAMETRIC_ARM, {"reach": 0.7})
    assert drawn.state is PictureState.LIVE
    assert _places(drawn)[1] == (0.7, 0.0, 0.0)


def test_a_mass_without_a_value_is_left_out():
    drawn = picture_of(ARM.replace("mass = 1.0", "mass = payload"))
    assert drawn.message == "1 parameter has no value: left out of masses and inertia"
    assert drawn.skeleton.masses[2].mass == 0.0
    assert drawn.guesses.values == {}


def _places(drawn):
    return [pose.translation for pose in drawn.skeleton.placements]
