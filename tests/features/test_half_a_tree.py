"""What of a robot is in its tree and in the search, when the text is not whole."""

from kindsl.frontends.features.outline import kinematic_outline, workspace_symbols
from kindsl.judgement.analysis.analysis import analyse


def tree(text):
    def told(symbols):
        return [(s.name, s.detail, *told(s.children)) for s in symbols]

    return told(kinematic_outline(analyse(text)))


def test_what_nothing_carries_stands_above_what_it_carries():
    text = "Robot R { RobotBase b { } link low { } link up { id = 1 children { low via j } } }"
    assert tree(text) == [("b", "base"), ("up", "id 1", ("low", "via j"))]


def test_a_loop_begins_with_its_first_link():
    a = "link a { id = 1 children { c via j } }"
    text = f"Robot R {{ RobotBase b {{ }} {a} link c {{ children {{ a via k }} }} }}"
    assert tree(text) == [("b", "base"), ("a", "id 1", ("c", "via j"))]


def test_a_joint_that_is_used_twice_is_listed_once():
    children = "children { a via j c via j }"
    text = f"Robot R {{ RobotBase b {{ {children} }} link a {{ }} link c {{ }} r_joint j {{ }} }}"
    assert tree(text) == [
        ("b", "base", ("a", "via j (revolute)", ("j", "revolute")), ("c", "via j (revolute)"))
    ]


def test_a_search_finds_no_nameless_thing():
    text = "Robot R { link { frames { { } } } r_joint { } link a { } }"
    assert [s.name for s in workspace_symbols(analyse(text))] == ["R", "a"]
    assert [s.name for s in workspace_symbols(analyse("link a { }"))] == ["a"]
