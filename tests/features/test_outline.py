from tests.features.samples import ARM, BROKEN, COMMENTED
from tests.support.cursor import at_cursor

from kindsl.frontends.features.navigation import hierarchy_items, predecessors, successors
from kindsl.frontends.features.outline import (
    document_symbols,
    is_match,
    kinematic_outline,
    workspace_symbols,
)
from kindsl.frontends.features.ranges import folds, selection_ranges
from kindsl.judgement.analysis.analysis import analyse


def outline(symbols):
    return [
        f"{s.name} {s.detail}" if not s.children else (f"{s.name} {s.detail}", outline(s.children))
        for s in symbols
    ]


def test_the_outline_is_the_text():
    assert outline(document_symbols(analyse(ARM))) == [
        (
            "Arm robot",
            [
                "base base",
                "upper id 1",
                ("lower id 2", ["tip frame"]),
                "shoulder revolute",
                "elbow prismatic",
            ],
        )
    ]


def test_the_robot_s_entry_ends_at_its_brace():
    (robot,) = document_symbols(analyse("// a\n" + ARM + "// b\n"))
    assert (robot.start, robot.end) == (5, 5 + len(ARM) - 1)


def test_blocks_outside_the_robot_are_in_the_outline():
    assert [s.kind for s in document_symbols(analyse("link a {}\nRobot R {\nlink b {}\n"))] == [
        "link",
        "robot",
    ]
    assert {s.kind for s in document_symbols(analyse(BROKEN))} == {"robot"}


def test_the_kinematic_tree():
    lower = ("lower via elbow (prismatic), id 2", ["elbow prismatic", "tip frame"])
    upper = ("upper via shoulder (revolute), id 1", ["shoulder revolute", lower])
    assert outline(kinematic_outline(analyse(ARM))) == [("base base", [upper])]


def test_what_nothing_carries_is_in_the_tree_too():
    text = ARM.replace("upper via shoulder", "")
    names = [symbol.name for symbol in kinematic_outline(analyse(text))]
    assert names == ["base", "upper", "shoulder"]


def test_a_loop_ends_somewhere():
    text = ARM.replace("children {}", "children { upper via elbow }")
    assert [s.name for s in kinematic_outline(analyse(text))] == ["base"]


def test_half_a_document_has_a_tree():
    names = {symbol.name for symbol in kinematic_outline(analyse(BROKEN))}
    assert "base" in names


def test_a_deep_chain_nests_only_so_far():
    links = "".join(
        f"link l{i} {{ id = {i} children {{ l{i + 1} via j }} }}\n" for i in range(1, 400)
    )
    symbols = kinematic_outline(analyse(f"Robot R {{ RobotBase b {{ }}\n{links}}}"))
    assert len(symbols) == 5


def test_workspace_symbols_match_letters_in_order():
    analysis = analyse(ARM)
    found = {(s.name, s.kind) for s in workspace_symbols(analysis) if is_match("SHD", s.name)}
    assert found == {("shoulder", "joint")}
    assert ("Arm", "robot") in {(s.name, s.kind) for s in workspace_symbols(analysis)}


def test_blocks_and_comments_fold():
    analysis = analyse(ARM)
    lines = ARM.count
    found = [(f.kind, lines("\n", 0, f.start), lines("\n", 0, f.end)) for f in folds(analysis)]
    assert ("block", 13, 23) in found
    assert ("block", 0, ARM.count("\n") - 1) in found
    text = COMMENTED
    comments = [text[f.start : f.end] for f in folds(analyse(text)) if f.kind == "comment"]
    assert comments[-1] == "// the first line\n// the second line"


def test_a_comment_that_begins_a_document_folds():
    text = "// a robot\n// of ours\n" + ARM.replace("{", "{ // later", 1)
    comments = [text[f.start : f.end] for f in folds(analyse(text)) if f.kind == "comment"]
    assert comments[0] == "// a robot\n// of ours"


def test_selections_grow_from_number_to_document():
    analysis, offset = at_cursor(ARM.replace("(-PI/2.0, 0.0, 0.0)", "(-PI/2.$00, 0.0, 0.0)"))
    texts = [
        analysis.text[s.start : s.end].split("\n")[0] for s in selection_ranges(analysis, offset)
    ]
    assert texts == [
        "2.0",
        "-PI/2.0",
        "-PI/2.0, 0.0, 0.0",
        "(-PI/2.0, 0.0, 0.0)",
        "rotation = (-PI/2.0, 0.0, 0.0)",
        "translation = (0.0, 0.0, 0.5)",
        "ref_frame {",
        "r_joint shoulder {",
        "Robot Arm {",
    ]


def test_the_tree_opens_both_ways():
    analysis, offset = at_cursor(ARM.replace("link upper", "link up$0per"))
    (item,) = hierarchy_items(analysis, offset)
    assert (item.name, item.detail) == ("upper", "via shoulder (revolute)")
    (above,) = predecessors(analysis, "upper")
    (below,) = successors(analysis, "upper")
    assert (above.item.name, below.item.name) == ("base", "lower")
    assert analysis.text[slice(*above.place)] == "upper via shoulder"


def test_a_joint_opens_the_link_that_it_moves():
    (item,) = hierarchy_items(*at_cursor(ARM.replace("p_joint elbow", "p_joint $0elbow")))
    assert item.name == "lower"
