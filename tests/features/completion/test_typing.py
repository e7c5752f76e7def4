"""What comes by itself while someone types, and what comes when they ask: typed situations."""

import re
from pathlib import Path

import pytest
from tests.features.samples import ARM, COMMENTED, PARAMETRIC
from tests.support.amount import usually
from tests.support.cursor import at_cursor
from tests.typist.typist import lines_to_type

from kindsl.frontends.features.completion.completion import completions, narrowed, suggestions
from kindsl.judgement.analysis.analysis import analyse

EXAMPLES = sorted((Path(__file__).parents[3] / "examples").glob("*.kindsl"))
ROBOT = "Robot R {\n"
BASE = ROBOT + "RobotBase base {\n    children {\n        b via j\n    }\n}\n"
LINK = BASE + "link b {\n    id = 1\n"
INERTIA = LINK + "    inertia_params {\n"
COM = INERTIA + "        mass = 1.0\n        CoM = (0.0, 0.0, 0.0)"
JOINT = LINK + "    children {}\n}\n"
ASKED = ARM.replace("lower via elbow\n", "$0\n")
NOTHING = None

# What is typed, what comes by itself first, what comes first when asked for.
SITUATIONS = [
    ("$0", NOTHING, "Robot"),
    ("Ro$0", "Robot", "Robot"),
    ("Robot$0", NOTHING, "Robot"),
    ("Robot $0", NOTHING, NOTHING),
    ("Robot ba$0", NOTHING, NOTHING),
    ("Robot R {$0", NOTHING, "RobotBase"),
    ("Robot R {\n    Ro$0\n}", "RobotBase", "RobotBase"),
    (ROBOT + "RobotBase $0", NOTHING, NOTHING),
    (ROBOT + "RobotBase base$0", NOTHING, NOTHING),
    (ROBOT + "RobotBase base $0", NOTHING, "floating"),
    (ROBOT + "RobotBase base fl$0", "floating", "floating"),
    (ROBOT + "RobotBase base floating$0", NOTHING, NOTHING),
    (ROBOT + "RobotBase base {$0", NOTHING, "inertia_params"),
    (BASE + "$0", NOTHING, "link"),
    (BASE + "li$0", "link", "link"),
    (BASE + "link $0", "b", "b"),
    (BASE + "link b$0", NOTHING, NOTHING),
    (BASE + "link new$0", NOTHING, NOTHING),
    (BASE + "link b {$0", NOTHING, "id"),
    (BASE + "link b {\n    id = $0", NOTHING, "1"),
    (BASE + "link b {\n    id = 1$0", NOTHING, NOTHING),
    (LINK + "    in$0", "inertia_params", "inertia_params"),
    (LINK + "    children$0", NOTHING, "children"),
    (LINK + "    children {$0", NOTHING, "link1 via joint1"),
    (LINK + "    children {\n        c$0", NOTHING, NOTHING),
    (LINK + "    children {\n        c $0", "via", "via"),
    (LINK + "    children {\n        c via$0", NOTHING, NOTHING),
    (LINK + "    children {\n        c via $0", NOTHING, "c_joint"),
    (INERTIA + "        mass = $0", NOTHING, NOTHING),
    (INERTIA + "        mass = 1.0$0", NOTHING, NOTHING),
    (INERTIA + "        mass = 1.0\n        C$0", "CoM", "CoM"),
    (COM + "$0", NOTHING, "Ix … Iyz"),
    (COM + "\n        Ix=0.0$0", NOTHING, NOTHING),
    (INERTIA + "        mass = m\n        Ix = m$0", NOTHING, NOTHING),
    (JOINT + "r_joint $0", "j", "j"),
    (JOINT + "r_joint j {\n    $0", NOTHING, "ref_frame"),
    (JOINT + "r_joint j {\n    ref_frame {\n        rotation = ($0", "PI/2.0", "PI/2.0"),
    (JOINT + "r_joint j {\n    ref_frame {\n        rotation = (PI$0", NOTHING, "PI/2.0"),
    (JOINT + "r_joint j {\n    ref_frame {\n        rotation = (PI/$0", NOTHING, "2.0"),
    (JOINT + "r_joint j {\n    ref_frame {\n        translation = (0.0, $0", NOTHING, "0.0"),
    (ARM + "$0", NOTHING, NOTHING),
    (ARM + "li$0", NOTHING, NOTHING),
    (ARM.replace("via elbow", "via $0"), "elbow", "elbow"),
    (ARM.replace("lower via elbow", "lo$0"), "lower via …", "lower via …"),
    (PARAMETRIC.replace("mass = 0.1", "mass = $0"), "m", "m"),
    (PARAMETRIC.replace("(width/2.0", "($0"), "width", "width"),
    (PARAMETRIC.replace("(width/2.0", "(wi$0"), "width", "width"),
    (PARAMETRIC.replace("ref_frame = grip", "ref_frame = $0"), "grip", "grip"),
    (PARAMETRIC.replace("frames { grip", "frames { gr$0"), "grip", "grip"),
    (COMMENTED.replace("the first line", "li$0"), NOTHING, NOTHING),
]  # fmt: skip


def first(found):
    return found.items[0].label if found.items else NOTHING


@pytest.mark.parametrize(("marked", "by_itself", "asked_for"), SITUATIONS)
def test_what_is_offered_first(marked, by_itself, asked_for):
    analysis, offset = at_cursor(marked)
    assert first(suggestions(analysis, offset)) == by_itself
    assert first(completions(analysis, offset)) == asked_for


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
@pytest.mark.parametrize("is_closed", [False, True], ids=["open", "closed"])
def test_no_list_is_open_at_a_line_s_end(path, is_closed):
    typed, depth = "", 0
    for line in lines_to_type(path.read_text()):
        typed += line
        depth += line.count("{") - line.count("}")
        behind = "\n}" * depth if is_closed else ""
        assert not suggestions(analyse(typed + behind), len(typed)).items, line
        typed += "\n"


@pytest.mark.parametrize("text", [ARM, PARAMETRIC])
def test_what_stands_before_the_cursor_is_never_offered(text):
    words = [match.end() for match in re.finditer(r"\w+", text)]
    for offset in usually(words, thoroughly=range(len(text) + 1)):
        analysis = analyse(text[:offset])
        for found in (completions(analysis, offset), suggestions(analysis, offset)):
            assert text[found.start : offset].strip() not in {i.text for i in found.items}


def test_a_link_is_never_its_own_descendant():
    text = ARM.replace("children {}", "children { $0 }")
    offered = {item.text.split()[0] for item in completions(*at_cursor(text)).items}
    assert offered == {"${1:link1}"}


def test_a_used_joint_comes_last_and_says_so():
    items = completions(*at_cursor(ARM.replace("via elbow", "via $0"))).items
    assert [i.label for i in items] == ["elbow", "shoulder"]
    assert items[-1].detail == "revolute, moves upper already"


def test_new_names_go_on_counting():
    text = ARM.replace("shoulder", "joint1").replace("elbow", "joint2").replace("lower", "link2")
    found = completions(*at_cursor(text.replace("children {}", "children { $0 }")))
    assert [item.label for item in found.items] == ["link3 via joint3"]


def test_parameters_of_another_class_are_not_offered():
    found = completions(*at_cursor(PARAMETRIC.replace("(0.0, -tilt, 0.0)", "(0.0, $0")))
    assert not {"m", "width"} & {item.label for item in found.items}


def test_numbers_follow_a_division():
    found = completions(*at_cursor(PARAMETRIC.replace("-tilt", "PI/$0")))
    assert [(i.label, i.detail) for i in found.items] == [
        ("2.0", "90°"), ("4.0", "45°"), ("3.0", "60°"), ("6.0", "30°"),
    ]  # fmt: skip


def test_a_list_asked_for_narrows_until_the_word_is_whole():
    sections = BASE + "link b {\n    id = 1\n    chi$0"
    assert [i.label for i in narrowed(*at_cursor(sections)).items] == ["children", "children {}"]
    assert not narrowed(*at_cursor(sections.replace("chi$0", "children$0"))).items
    attached = ARM.replace("lower via elbow", "$0")
    assert "upper" not in {i.label for i in completions(*at_cursor(attached)).items}


@pytest.mark.parametrize("text", [ARM, PARAMETRIC])
def test_an_editor_without_placeholders_gets_one_line(text):
    for offset in range(0, len(text), 7):
        for item in completions(analyse(text[:offset]), offset).items:
            assert not set("\n\r\0$") & set(item.plain_text), item.label


def test_a_block_replaces_the_indentation_of_its_line():
    found = suggestions(*at_cursor("Robot R {\n    Ro$0\n}"))
    assert (found.start, found.end) == (10, 16)
