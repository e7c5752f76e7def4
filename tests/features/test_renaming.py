import pytest
from tests.features.samples import ARM, PARAMETRIC
from tests.support.cursor import at_cursor

from kindsl.frontends.features.manipulation.gesture import Refusal
from kindsl.frontends.features.navigation import linked_ranges
from kindsl.frontends.features.rename import Renaming, rename, rename_range
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.semantics.parameters import Binding
from kindsl.language.text.edits import apply_edits


def renamed(marked, name, settings=None):
    analysis, offset = at_cursor(marked, settings)
    renaming = rename(analysis, offset, name)
    assert isinstance(renaming, Renaming), renaming
    return apply_edits(analysis.text, renaming.edits)


def test_a_link_is_renamed_at_its_block_and_at_its_parent():
    text = renamed(ARM.replace("link upper", "link upp$0er"), "thigh")
    assert text == ARM.replace("upper", "thigh")


def test_a_parameter_is_renamed_in_every_value():
    text = renamed(PARAMETRIC.replace("width/2.0", "wid$0th/2.0"), "stroke")
    assert text == PARAMETRIC.replace("width", "stroke")


def test_a_constant_a_frame_a_joint_the_robot():
    assert "<d=0.05>" in renamed(PARAMETRIC.replace("*<off", "*<$0off"), "d")
    assert "ref_frame = hand" in renamed(PARAMETRIC.replace("grip {", "gr$0ip {"), "hand")
    assert "via knee" in renamed(ARM.replace("p_joint el", "p_joint el$0"), "knee")
    assert renamed(ARM.replace("Robot Arm", "Robot $0Arm"), "Leg").startswith("Robot Leg")


def test_comments_are_left_alone():
    text = ARM.replace("link upper {", "link upp$0er { // upper")
    assert "link thigh { // upper" in renamed(text, "thigh")


def test_a_bound_parameter_is_to_be_renamed_in_the_configuration_too():
    settings = Settings(bindings={"reach": Binding(0.5, origin="kindsl.toml")})
    renaming = rename(*at_cursor(ARM.replace("reach", "re$0ach"), settings), "length")
    assert isinstance(renaming, Renaming)
    assert renaming.bound_parameter == "reach"


def test_of_two_links_with_one_name_the_second_is_renamed_alone():
    text = ARM.replace("link lower", "link up$0per")
    assert renamed(text, "lower") == ARM


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("lower", "a link named 'lower' exists already"),
        ("base", "a base named 'base' exists already"),
        ("elbow", "a joint named 'elbow' exists already"),
        ("tip", "a frame named 'tip' exists already, on link 'lower'"),
        ("Arm", "the robot is named 'Arm'"),
        ("mass", "'mass' is a keyword"),
        ("Pi", "'Pi' means the number pi"),
        (
            "2nd",
            "'2nd' is not a valid name: use letters, digits and '_', not starting with a digit",
        ),
        ("", "'' is not a valid name: use letters, digits and '_', not starting with a digit"),
    ],
)
def test_clashes_and_keywords_are_refused(name, message):
    assert rename(*at_cursor(ARM.replace("link upper", "link upp$0er")), name) == Refusal(message)


def test_a_parameter_takes_no_name_of_another():
    marked = PARAMETRIC.replace("m[1.5]", "$0m[1.5]")
    assert rename(*at_cursor(marked), "tilt") == Refusal("a parameter named 'tilt' exists already")
    settings = Settings(bindings={"spare": Binding(1.0, origin="kindsl.toml")})
    refusal = rename(*at_cursor(marked, settings), "spare")
    assert refusal == Refusal("'spare' already has a value in kindsl.toml")


def test_targets_have_their_say():
    marked = ARM.replace("reach", "re$0ach")
    assert isinstance(rename(*at_cursor(marked), "pitch"), Renaming)
    refusal = rename(*at_cursor(marked, Settings(frozenset({"robcogen2"}))), "pitch")
    assert refusal == Refusal("'pitch' begins with 'pi', where robcogen2 stops reading")
    refusal = rename(*at_cursor(marked, Settings(frozenset({"robcogen"}))), "größe")
    assert isinstance(refusal, Refusal)


def test_keywords_have_no_name():
    marked = ARM.replace("mass", "ma$0ss", 1)
    assert rename_range(*at_cursor(marked)) is None
    assert rename(*at_cursor(marked), "weight") is None


def test_places_of_a_name_are_linked_at_its_declaration_only():
    assert len(linked_ranges(*at_cursor(ARM.replace("link upper", "link up$0per")))) == 2
    assert linked_ranges(*at_cursor(ARM.replace("upper via", "up$0per via"))) == ()
    assert linked_ranges(*at_cursor(ARM.replace("reach", "re$0ach"))) == ()


def test_an_escaped_name_is_renamed_with_its_escape():
    text = ARM.replace("upper via", "^link via").replace("link upper", "link ^li$0nk")
    assert renamed(text, "thigh") == ARM.replace("upper", "thigh")
