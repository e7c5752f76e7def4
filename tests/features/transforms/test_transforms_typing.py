"""Words of transforms documents: which one is typed, and which ones a renaming reaches."""

import pytest
from tests.cli.samples import arm

from kindsl.frontends.features.transforms import renamed_transforms, transforms_completions
from kindsl.judgement.analysis.analysis import analyse
from kindsl.language.text.edits import apply_edits

ARM = arm()


@pytest.mark.parametrize(
    ("text", "word", "offered"),
    [
        ("Rob|ot arm", "Robot", ["Robot"]),
        ("Robot arm\nFrames { low|_er }", "low_er", ["fr_lower"]),
        ("Robot arm\nFrames { |tip }", "tip", ["fr_base", "fr_upper", "fr_lower", "tip"]),
        ("Robot arm\nFrames { a } Transforms { base=|", "", ["a"]),
        ("Robot arm\nFrames { a } Transforms { base=a, |", "", ["target"]),
        ("Robot arm\nFrames { a } Transforms { target=a, |", "", ["base"]),
        ("Robot arm\nFrames { a } Transforms { target=a b|", "b", ["base"]),
        ("Robot ?? ar|", "ar", ["arm"]),
        ("Robot arm\nFrames { ?? ti|", "ti", ["tip"]),
    ],
)
def test_the_whole_word_is_replaced(text, word, offered):
    offset = text.index("|")
    text = text.replace("|", "")
    found = transforms_completions(text, offset, analyse(ARM).model)
    assert text[found.start : found.end] == word
    assert [item.label for item in found.items] == offered


def test_without_a_robot_only_what_the_document_lists_is_offered():
    text = "Robot arm\nFrames { fr_base, a }\nTransforms { base="
    found = transforms_completions(text, len(text), None)
    assert [(i.label, i.detail) for i in found.items] == [("fr_base", ""), ("a", "")]
    assert not transforms_completions("Robot ", 6, None).items


def test_an_item_tells_whose_frame_it_is():
    text = "Robot arm\nFrames { "
    found = transforms_completions(text, len(text), analyse(ARM).model)
    told = {item.label: item.detail for item in found.items}
    assert (told["fr_upper"], told["tip"]) == ("frame of upper", "")


def renamed(robot, at, new_name, text):
    edits = renamed_transforms(analyse(robot), robot.index(at), new_name, text)
    assert isinstance(edits, tuple)
    return apply_edits(text, edits)


def test_an_optional_frame_keeps_its_name_when_a_link_of_like_name_is_renamed():
    text = "Robot arm\nFrames { fr_upper, fr_lower }"
    taken = ARM.replace("tip", "fr_upper")
    assert renamed(taken, "upper via", "thigh", text) == text
    assert renamed(taken, "fr_upper", "hand", text) == text.replace("fr_upper", "hand")
    assert renamed(taken, "lower via", "shin", text) == text.replace("lower", "shin")


def test_a_joint_or_parameter_of_a_frame_s_name_changes_nothing():
    text = "Robot arm\nFrames { elbow, reach }"
    assert renamed(ARM, "elbow", "knee", text) == text


def test_a_document_without_a_robot_s_name_is_left_alone():
    assert renamed(ARM, "arm", "leg", "Robot") == "Robot"
    assert renamed(ARM, "arm", " ^leg ", "Robot arm") == "Robot leg"
