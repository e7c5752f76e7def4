"""What is offered in a transforms document, where, and what it writes."""

import pytest

from kindsl.frontends.features.transforms import transforms_actions
from kindsl.judgement.analysis.analysis import analyse
from kindsl.language.semantics.transforms import transforms_document
from kindsl.language.text.edits import apply_edits

LINKS = "link a { id = 1 children {} frames { tip { } } } link b { id = 2 children {} }"
MODEL = analyse(f"Robot arm {{ RobotBase base {{ children {{ a via j }} }} {LINKS} }}").model
FRAMES = "fr_base, fr_a, fr_b, tip"
LISTED = "Robot arm\nFrames { fr_base, tip }\n"
ALL = "List every frame of 'arm'"


def offered(text: str, start: int = 0, end: int = 0, model: object = MODEL) -> dict[str, str]:
    """Return what the text would be after each change that is offered."""
    found = transforms_actions(text, model, start, end)
    return {action.title: apply_edits(text, action.edits) for action in found}


def test_the_document_wants_each_pose_and_the_jacobians_of_tips() -> None:
    pairs, tips = (
        "".join(f"    base=fr_base, target={name}\n" for name in names)
        for names in (("fr_a", "fr_b", "tip"), ("tip", "fr_b"))
    )
    new = (
        f"Robot arm\nFrames {{\n    {FRAMES}\n}}\n"
        f"Transforms {{\n{pairs}}}\nJacobians {{\n{tips}}}\n"
    )
    assert transforms_document(MODEL) == new
    for text in ("", " \n\t"):
        assert offered(text) == {"Write the transforms of 'arm'": new}


@pytest.mark.parametrize(
    ("robot", "is_offered"),
    [
        ("Robot r { RobotBase b {} }", True),
        ("Robot r { link l {} }", True),
        ("Robot r { }", False),
        ("RobotBase b {}", False),
        ("", False),
    ],
)
def test_of_a_robot_without_name_or_frames_nothing_is_written(robot: str, is_offered: bool) -> None:
    assert bool(offered("", model=analyse(robot).model)) == is_offered
    assert not offered("", model=None)


@pytest.mark.parametrize(
    ("frames", "tip"),
    [
        ("near { translation = (0.1, 0.0, 0.0) } far { translation = (0.0, -0.2, 0.0) }", "far"),
        ("far { translation = (0.0, -0.2, 0.0) } near { translation = (0.1, 0.0, 0.0) }", "far"),
        ("a1 { translation = (0.1, 0.0, 0.0) } a2 { translation = (0.1, 0.0, 0.0) }", "a1"),
        ("a1 { translation = (9.0, 0.0, 0.0) } a2 { translation = (reach, 0.0, 0.0) }", "a2"),
    ],
)
def test_the_tip_of_a_leg_is_its_outermost_frame(frames: str, tip: str) -> None:
    whole = frames.replace(") }", ") rotation = (0.0, 0.0, 0.0) }")
    robot = f"Robot arm {{ {LINKS.replace('tip { }', whole)} }}"
    text = transforms_document(analyse(robot).model)
    assert f"base=fr_a, target={tip}\n" in text[text.index("Jacobians") :]
    assert text[text.index("Jacobians") :].count("target=") == 2


def test_links_without_a_base_are_wanted_in_the_first() -> None:
    text = transforms_document(analyse(f"Robot arm {{ {LINKS} }}").model)
    assert "base=fr_a, target=fr_b" in text and "base=fr_base" not in text


def test_without_a_robot_what_the_document_says_itself_is_offered() -> None:
    text = f"{LISTED}Transforms {{ base=tip, target=fr_a }}"
    start = text.index("fr_a")
    new = text.replace("tip }", "tip, fr_a }")
    assert offered(text, start, start, None) == {"List 'fr_a' under 'Frames'": new}


@pytest.mark.parametrize(
    ("text", "title"),
    [
        (f"{LISTED}Transforms {{ base=tip, target=fr_a }}", "List 'fr_a' under 'Frames'"),
        (f"{LISTED}Jacobians {{ base=tip, target=fr_a }}", "List 'fr_a' under 'Frames'"),
        (LISTED.replace("tip", "tipp"), "Replace 'tipp' with 'tip'"),
    ],
)
def test_a_change_is_offered_where_it_is_needed(text: str, title: str) -> None:
    name = title.split("'")[1]
    first, last = text.index(name), text.index(name) + len(name)
    for start, end, is_there in (
        (first, first, True), (last, last, True), (first - 3, first, True), (last, last + 3, True),
        (0, len(text), True), (first - 3, first - 1, False), (last + 1, last + 1, False),
    ):  # fmt: skip
        assert (title in offered(text, start, end)) == is_there


def test_a_replacement_may_be_made_unasked_and_a_listing_may_not() -> None:
    text = LISTED.replace("tip", "tipp")
    preferred = {a.title: a.is_preferred for a in transforms_actions(text, MODEL, 0, len(text))}
    assert preferred == {"Replace 'tipp' with 'tip'": True, ALL: False}


@pytest.mark.parametrize(
    ("text", "new"),
    [
        ("Robot arm\n", f"Robot arm\nFrames {{\n    {FRAMES}\n}}\n"),
        ("Robot arm\nFrames { tip }", "Robot arm\nFrames { tip, fr_base, fr_a, fr_b }"),
        (f"Robot arm\nFrames {{ {FRAMES} }}", None),
        # No list can be begun where the robot or the rest of the text is not read.
        ("Frames", None),
        ("Robot arm Frames { }", None),
        ("Robot arm ;", None),
    ],
)
def test_frames_are_listed_where_there_is_a_place_for_them(text: str, new: str | None) -> None:
    assert offered(text).get(ALL) == new


def test_a_frame_is_not_listed_in_a_text_that_is_not_read_to_its_end() -> None:
    text = "Robot arm Transforms { base=tip, target=fr_a } ;"
    assert offered(text, 0, len(text)) == {}


def test_a_name_that_is_like_no_other_is_not_replaced() -> None:
    text = LISTED.replace("tip", "elsewhere")
    assert [*offered(text, 0, len(text))] == [ALL]


def test_nothing_is_written_for_names_that_no_document_can_have() -> None:
    model = analyse("Robot Größe { RobotBase base { children {} } }").model
    assert transforms_actions("", model, 0, 0) == []
