"""What of a leg its mirror image takes over, and which legs have one."""

from pathlib import Path

import pytest
from tests.features.manipulation.made import changed

from kindsl.frontends.features.manipulation.gesture import Gesture, Refusal
from kindsl.frontends.features.manipulation.mirror_leg import can_mirror, mirror_leg
from kindsl.judgement.analysis.analysis import analyse

LEG = """\
Robot R {
RobotBase b { children { LF_a via LF_j other via o } }
link LF_a { id = 7 inertia_params { mass = 1.0 CoM = (0.1, %s, 0.3)
    Ix=1.0 Iy=1.0 Iz=1.0 Ixy=0.01 Ixz=0.02 Iyz=-0.03 } children { LF_b via LF_k LF_c via LF_l } }
link LF_b { id = 3 inertia_params { Ix=1.0 } children {} }
link LF_c { children {} }
link other { id = 1 children {} }
r_joint LF_j { ref_frame { translation = (0.1, 0.2, 0.3) rotation = (0.1, 0.2, 0.3) } }
r_joint LF_k { ref_frame { translation = (x, %s, x) rotation = (0.0, 0.2, PI/2.0) } }
p_joint LF_l { }
r_joint o { ref_frame { translation = (0.0, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } }
}
"""


EXAMPLES = sorted((Path(__file__).parents[3] / "examples").glob("*.kindsl"))


@pytest.mark.parametrize(
    ("value", "opposite"),
    [
        ("0.5", "-0.5"), ("-0.5", "0.5"), ("+0.5", "-0.5"), ("- 0.5", "0.5"), ("0.0", "0.0"),
        ("x", "-x"), ("-x", "x"), ("x/2.0", "-x/2.0"), ("-2.0*x", "2.0*x"), ("2.0 x", "-2.0 x"),
        ("-<k=1.0>", "<k=1.0>"), ("-(x)", "(x)"), ("0.1+0.2", "-(0.1+0.2)"),
        ("-0.1+0.2", "-(-0.1+0.2)"), ("x-0.2", "-(x-0.2)"), ("", ""),
    ],
)  # fmt: skip
def test_what_points_left_points_right_as_far(value: str, opposite: str) -> None:
    text = LEG % (value, value)
    moved = changed(text, mirror_leg(analyse(text), "LF_a"))
    values = {"x": 0.7, "<k>": 1.0}
    for left, right in (("LF_j", "RF_j"), ("LF_k", "RF_k")):
        poses = [moved.model.joint_named[name].pose for name in (left, right)]
        for vector, signs in (("translation", (1, -1, 1)), ("rotation", (-1, 1, -1))):
            rows = [getattr(pose, vector).components for pose in poses]
            for sign, one, other in zip(signs, *rows, strict=True):
                if one.text:
                    assert other.value(values) == sign * one.value(values)
    (_, y, _) = moved.model.joint_named["RF_k"].pose.translation.components
    assert y.text == opposite
    inertia = moved.model.body_named["RF_a"].inertia
    assert [c.text for c in inertia.com.components] == ["0.1", opposite, "0.3"]
    products = [inertia.moments[name].text for name in ("Ixy", "Ixz", "Iyz")]
    assert products == ["-0.01", "0.02", "0.03"]


def test_new_links_are_numbered_behind_all_others() -> None:
    text = LEG % ("0.1", "0.1")
    gesture = mirror_leg(analyse(text), "LF_a")
    moved = changed(text, gesture)
    assert gesture.title == "Mirror 'LF_a' as 'RF_a'"
    assert {str(link.name): link.id for link in moved.model.links} == {
        "LF_a": 7, "LF_b": 3, "LF_c": None, "other": 1, "RF_a": 8, "RF_b": 9, "RF_c": None,
    }  # fmt: skip
    children = [(str(c.link), str(c.joint)) for c in moved.model.base.children]
    assert children == [("LF_a", "LF_j"), ("other", "o"), ("RF_a", "RF_j")]
    below = [(str(c.link), str(c.joint)) for c in moved.model.body_named["RF_a"].children]
    assert below == [("RF_b", "RF_k"), ("RF_c", "RF_l")]
    assert [*gesture.names] == ["RF_a", "RF_b", "RF_c", "RF_j", "RF_k", "RF_l"]


def test_a_leg_may_be_all_that_a_document_holds() -> None:
    leg = "// of a robot\nlink LF_a { children { LF_b via LF_k } }\n"
    text = f"{leg}link x {{ children {{ LF_a via LF_j }} }}\nlink LF_b {{}}\n"
    text += "r_joint LF_j {}\nr_joint LF_k {}\n"
    new = changed(text, mirror_leg(analyse(text), "LF_a")).text
    assert "\n\nlink RF_a { children { RF_b via RF_k } }\n\nlink RF_b {}" in new
    assert new.endswith("\n\nr_joint RF_j {}\n\nr_joint RF_k {}\n")


def test_of_a_link_whose_keyword_is_misspelt_the_image_is_as_right_as_the_rest() -> None:
    """It stands in the piece of text that the block before it begins."""
    text = LEG % ("0.1", "0.1")
    new = changed(text, mirror_leg(analyse(text), "LF_a")).text
    broken = text.replace("link LF_b", "ink LF_b")
    found = changed(broken, mirror_leg(analyse(broken), "LF_a")).text
    assert found == new.replace("link LF_b", "ink LF_b").replace("link RF_b", "ink RF_b")


def test_an_image_that_is_listed_already_is_not_listed_twice() -> None:
    text = (LEG % ("0.1", "0.1")).replace("other via o }", "other via o RF_a via RF_j }")
    moved = changed(text, mirror_leg(analyse(text), "LF_a"))
    children = [(str(c.link), str(c.joint)) for c in moved.model.base.children]
    assert children == [("LF_a", "LF_j"), ("other", "o"), ("RF_a", "RF_j")]
    assert "RF_b" in moved.model.body_named


def test_a_link_that_is_named_only_has_no_image() -> None:
    text = LEG % ("0.1", "0.1")
    refused = mirror_leg(analyse(text.replace("other via", "LF_d via")), "LF_d")
    assert refused == Refusal("there is no link 'LF_d' with a supporting joint")


@pytest.mark.parametrize(
    ("old", "new", "reason"),
    [
        ("LF_c via LF_l", "LF_d via LF_l", "'LF_d' is not defined"),
        ("LF_c via LF_l", "LF_c via LF_m", "'LF_m' is not defined"),
        ("LF_a via LF_j", "LF_a via LF_m", "'LF_m' is not defined"),
        ("link other", "link RF_c", "'RF_c' is already defined"),
        ("link LF_c", "link RF_j", "'LF_c' is not defined"),
        ("r_joint o", "r_joint RF_k", "'RF_k' is already defined"),
        (
            "id = 1 children {}",
            "id = 1 children {} frames { RF_b {} }",
            "'RF_b' is already defined",
        ),
        (
            "id = 1 children {}",
            "id = 1 children { RF_b via p }",
            "'other' has 'RF_b via p' already",
        ),
        ("other via o }", "other via o x via RF_k }", "'b' has 'x via RF_k' already"),
        ("other via o }", "other via o RF_a via p }", "'b' has 'RF_a via p' already"),
        ("children { LF_a via LF_j", "children LF_a via LF_j", "link 'LF_a' is not whole"),
    ],
)
def test_a_leg_that_is_not_whole_has_no_image(old: str, new: str, reason: str) -> None:
    text = LEG % ("0.1", "0.1")
    assert old in text
    assert mirror_leg(analyse(text.replace(old, new)), "LF_a") == Refusal(reason)


@pytest.mark.parametrize("text", [LEG % ("0.2", "0.0"), *(path.read_text() for path in EXAMPLES)])
def test_it_is_offered_where_it_can_be_done(text: str) -> None:
    analysis = analyse(text)
    names = [str(body.name) for body in analysis.model.bodies]
    done = [name for name in names if isinstance(mirror_leg(analysis, name), Gesture)]
    assert [name for name in names if can_mirror(analysis.model, name)] == done
    assert not {"b", "other"} & set(done)
