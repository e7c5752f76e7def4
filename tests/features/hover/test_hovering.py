import pytest
from tests.features.samples import ARM, BROKEN, PARAMETRIC
from tests.support.cursor import at_cursor

from kindsl.frontends.features.hover.hover import hover
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.semantics.parameters import Binding


def shown(marked, settings=None):
    found = hover(*at_cursor(marked, settings))
    assert found is not None
    return found.markdown


def test_a_link_tells_its_place_its_mass_and_its_pose():
    assert shown(ARM.replace("link upper", "link $0upper")) == (
        "**link `upper`**, id 1\n\n"
        "- supporting joint `shoulder` (revolute), parent `base`\n"
        "- child `lower` via `elbow`\n"
        "- mass 2 kg; subtree 3 kg with 1 joint\n"
        "- CoM (0.25, 0, 0) m in the link frame\n"
        "- principal moments about the CoM 0.01, 0.075, 0.075 kg·m²\n"
        "- ✓ physically consistent\n"
        "- zero configuration, in the base: origin (0, 0, 0.5) m, turned (-90, 0, 0)° about x, y, z"
    )


def test_a_child_is_told_like_its_declaration():
    assert shown(ARM.replace("lower via", "lo$0wer via")) == shown(
        ARM.replace("link lower", "link lo$0wer")
    )


def test_of_two_links_with_one_name_each_tells_of_itself():
    text = ARM.replace("link lower", "link upp$0er")
    assert "mass 1 kg" in shown(text)


def test_a_joint_tells_its_axis_in_the_base():
    text = shown(ARM.replace("p_joint elbow", "p_joint elb$0ow"))
    assert text.startswith("**prismatic joint `elbow`**")
    assert "predecessor `upper`, successor `lower`" in text
    assert "slides along its z axis: (0, 1, 0) through (0.5, 0, 0.5) m in the base" in text


def test_a_frame_tells_where_it_is():
    settings = Settings(bindings={"reach": Binding(0.3)})
    text = shown(ARM.replace("tip {", "ti$0p {"), settings)
    assert "in the link frame: origin (0.3, 0, 0) m, turned (0, 90, 0)°" in text
    assert "in the base: origin (0.8, 0, 0.5) m" in text


def test_a_parameter_tells_its_class_its_value_and_where_that_comes_from():
    settings = Settings(bindings={"reach": Binding(0.3, 0.1, None, "kindsl.toml")})
    text = shown(ARM.replace("reach", "rea$0ch"), settings)
    assert "**parameter `reach`**: kinematics parameter, a length" in text
    assert "value 0.3 m, from kindsl.toml" in text
    assert "range 0.1 to …" in text
    assert "1 use: translation x of frame `tip`" in text


def test_an_unbound_parameter_says_so_everywhere():
    assert "unbound" in shown(ARM.replace("reach", "rea$0ch"))
    why = "not known: the parameter `reach` has no value"
    assert why in shown(ARM.replace("tip {", "ti$0p {"))


def test_a_number_beyond_all_bounds_places_nothing():
    text = shown(ARM.replace("reach", "1e999").replace("tip {", "ti$0p {"))
    assert "not known: `1e999` is not finite" in text


def test_a_default_is_told():
    assert "default 1.5, in the document" in shown(PARAMETRIC.replace("m[1.5]", "$0m[1.5]"))


def test_a_constant_tells_its_value_and_what_the_expression_comes_to():
    text = shown(PARAMETRIC.replace("*<off", "*<o$0ff"))
    assert "**constant `offset`**" in text
    assert "CoM z of link `finger`: **0.1 m**" in text


def test_angles_are_told_in_degrees_too():
    text = shown(ARM.replace("-PI/2.0", "-PI$0/2.0"))
    assert "rotation about x of joint `shoulder`: **-1.571 rad = -90°**" in text


@pytest.mark.parametrize(
    ("word", "words"),
    [
        ("rotation", "intrinsic"),
        ("inertia_params", "not about the CoM"),
        ("Ixy", "opposite to the one in a URDF"),
        ("r_joint", "turns about the z axis"),
        ("via", "predecessor"),
    ],
)
def test_keywords_tell_the_conventions(word, words):
    assert words in shown(ARM.replace(word, "$0" + word, 1))


def test_half_a_link_tells_what_it_can():
    text = shown(BROKEN.replace("link a", "link $0a"))
    assert "parent `base`" in text
    assert "not known" in text


def test_an_undeclared_name_is_told_to_be_one():
    marked = ARM.replace("upper via shoulder", "upp$0er via shoulder").replace(
        "link upper", "link u"
    )
    assert shown(marked) == "There is no link `upper`."


def test_the_robot_tells_its_sum():
    text = shown(ARM.replace("Robot Arm", "Robot A$0rm"))
    assert "fixed base, 2 links, 1 revolute joint and 1 prismatic joint" in text
    assert "total mass 3 kg" in text


def test_a_loop_has_no_pose_but_a_hover():
    text = ARM.replace("children {}", "children { upper via elbow }").replace(
        "upper via sh", "u via s"
    )
    assert "kinematic loop" in shown(text.replace("link lower", "link low$0er"))


def test_blanks_tell_nothing():
    assert hover(*at_cursor(ARM.replace("\n\nlink upper", "\n$0\nlink upper"))) is None


def test_what_is_below_a_loop_is_not_weighed():
    text = ARM.replace("children {}", "children { upper via elbow }")
    text = shown(text.replace("link upper", "link up$0per"))
    assert "subtree at least 3 kg with 2 joints (the links below it are no tree)" in text


def test_the_number_of_a_link_tells_what_it_is_for():
    assert "without gaps" in shown(ARM.replace("id = 1", "id = $01"))
