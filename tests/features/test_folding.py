"""What can be folded away, and which comments fold together."""

import pytest
from tests.features.samples import ARM

from kindsl.frontends.features.ranges import folds
from kindsl.judgement.analysis.analysis import analyse


def folded(text, kind):
    return [text[f.start : f.end] for f in folds(analyse(text)) if f.kind == kind]


BASE = "Robot R { RobotBase b { } "


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("// a\n// b", ["// a\n// b"]),
        ("// a\r// b\r\n// c", ["// a\r// b\r\n// c"]),
        ("// a\n\n  // b\n// c", ["// a\n\n  // b\n// c"]),
        ("// a", []),
        ("/* a */ /* b */", []),
        ("/* a */ // b\n", []),
        ("/* a\n */ // b", ["/* a\n */"]),
        ("// a\n/* b */\n", ["// a\n/* b */"]),
        ("// a\n// b\nRobot R { // c\n// d", ["// a\n// b", "// c\n// d"]),
        (
            BASE + "// a\nlink l { // b\n // c\n id = 1 /* d\n */ children { } } }",
            ["// b\n // c", "/* d\n */"],
        ),
        (BASE + "\n// a\n// b\nid // c\n", ["// a\n// b"]),
    ],
)
def test_comments_with_nothing_between_them_fold_together(text, expected):
    assert folded(text, "comment") == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Robot R {\n}", ["\n"]),
        ("Robot R {\n} // end\n", ["\n"]),
        ("Robot R { }", []),
        ("Robot R {\nlink a { }\n", []),
        ("Robot R\nlink a { }\n}", []),
        ("Robot R {\rlink a {\r\n} }", ["\rlink a {\r\n} ", "\r\n"]),
        (
            "Robot R { RobotBase b {\n children {\n} link a { } }",
            [" RobotBase b {\n children {\n} link a { } ", "\n children {\n"],
        ),
        ("Robot R { link a { id = 1\nchildren { b via j }\n", []),
        ("link a { frames { f {\n} } }", [" frames { f {\n} } ", " f {\n} ", "\n"]),
    ],
)
def test_blocks_fold_from_brace_to_brace(text, expected):
    assert folded(text, "block") == expected


def test_every_tall_block_of_a_robot_folds():
    opening = [k + 1 for k, sign in enumerate(ARM) if sign == "{" and ARM[k + 1] == "\n"]
    assert [f.start for f in folds(analyse(ARM))] == opening
