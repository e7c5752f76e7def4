"""Names that completion makes up: they go on counting, and nothing has them yet."""

import pytest
from tests.support.cursor import at_cursor

from kindsl.frontends.features.completion.completion import completions

ROBOT = "Robot R {\nRobotBase b { children { %s via z } }\n%slink last { children { $0 } }\n}"


@pytest.mark.parametrize(
    ("children", "blocks", "expected"),
    [
        ("last", "", "link1 via joint1"),
        ("a via hinge1 b via hinge3 last", "", "link1 via hinge4"),
        ("a via hinge9 b via hinge10 last", "", "link1 via hinge11"),
        ("a via hinge12 last", "", "link1 via hinge13"),
        ("a via rotor8 b via hinge1 last", "", "link1 via hinge2"),
        ("a via hinge2 b via hinge_x last", "", "link1 via hinge3"),
        ("hinge3 via hinge2 last", "", "link1 via hinge4"),
        ("link1 via x last", "", "link2 via joint1"),
        ("joint1 via x last", "", "link1 via joint2"),
        ("last", "link leg5 { frames { leg6 { } leg7 { } } }\n", "leg8 via joint1"),
        ("last", "link leg5 { }\nlink leg2 { }\n", "leg6 via joint1"),
        ("last", "link leg_12_4 { }\n", "leg_12_5 via joint1"),
    ],
)
def test_a_new_child_goes_on_counting(children, blocks, expected):
    found = completions(*at_cursor(ROBOT % (children, blocks))).items
    assert [item.label for item in found if item.detail == "new child"] == [expected]


@pytest.mark.parametrize(
    ("blocks", "expected"),
    [
        ("", "gadget_joint"),
        ("link gadget_joint { }\n", "gadget_joint1"),
        ("link a { frames { gadget_joint { } gadget_joint1 { } } }\n", "gadget_joint2"),
        ("link a { children { gadget_joint via gadget_joint2 } }\n", "gadget_joint3"),
    ],
)
def test_a_joint_told_by_its_child_takes_no_name_twice(blocks, expected):
    text = ROBOT.replace("$0", "gadget via $0") % ("last", blocks)
    found = completions(*at_cursor(text)).items
    assert [item.label for item in found if item.detail == "new joint"] == [expected]


def test_the_first_joint_of_all_is_joint1():
    text = "Robot R {\nRobotBase b { children { $0 } }\nlink a { }\n}"
    assert completions(*at_cursor(text)).items[0].plain_text == "a via joint1"
