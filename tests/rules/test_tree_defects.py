"""Loops and repeated children: what is told of them, for whom, and what their fixes write."""

import pytest
from tests.support.examples import link, robot
from tests.support.one_rule import found

from kindsl.judgement.analysis.analysis import analyse
from kindsl.language.text.edits import apply_edits

LOOP = link("upper", 1, "lower via elbow"), link("lower", 2, "upper via wrist")
OTHER_LOOP = link("leg", 3, "foot via knee"), link("foot", 4, "leg via ankle")


@pytest.mark.parametrize(
    ("links", "title"),
    [
        ((*LOOP, link("hand", 5)), "Replace 'upper' with 'hand'"),
        (LOOP, None),
        ((*LOOP, link("hand", 5), link("tool", 6)), None),
        ((*LOOP, *OTHER_LOOP, link("hand", 5)), None),
        ((*LOOP, link("hand", 5, "gripper via grip")), None),
        ((*LOOP, link("hand", 5, "upper via grip")), None),
    ],
)
def test_a_loop_is_opened_to_the_only_link_that_nothing_carries(
    links: tuple[str, ...], title: str | None
) -> None:
    loops = found("KD201", robot(*links, joints="elbow wrist knee ankle grip"))
    assert {f.fix.title if f.fix else None for f in loops} == {title}


def test_a_loop_is_told_with_all_its_pairs() -> None:
    (loop,) = found("KD201", robot(*LOOP, joints="elbow wrist"))
    assert loop.message == "kinematic loop: upper -> lower -> upper"
    assert [r.message for r in loop.related] == [
        "'upper' carries 'lower'",
        "'lower' carries 'upper'",
    ]


@pytest.mark.parametrize(
    ("targets", "by_another"),
    [((), "warning"), (("robcogen",), "warning"), (("robcogen2",), "error")],
)
def test_a_child_twice_by_another_joint_is_fatal_for_robcogen2(
    targets: tuple[str, ...], by_another: str
) -> None:
    for joint_name, severity, tag in (("k", by_another, None), ("j", "warning", "unnecessary")):
        text = robot(link("a", 1), base=f"a via j a via {joint_name}", joints="j k")
        (finding,) = found("KD207", text, *targets)
        assert (finding.severity, finding.tag) == (severity, tag)
        assert (finding.fix is None) == (joint_name == "k")


@pytest.mark.parametrize(
    ("before", "after", "left"),
    [
        (" ", " ", " a via j"),
        (" ", " \t }", " a via j }"),
        ("\n\t", " \n", " a via j\n"),
        ("\r\n  ", "\t\r\n", " a via j\r\n"),
        ("\r", "\r", " a via j\r"),
        ("\n", "// again\n", " a via j\n// again\n"),
        (" ", "\n", " a via j \n"),
    ],
)
def test_a_repeated_child_is_removed_with_its_line(before: str, after: str, left: str) -> None:
    text = robot(link("a", 1), base="%s", joints="j")
    document = text % f"a via j{before}a via j{after.replace('}', '/**/')}"
    (finding,) = found("KD207", document)
    assert finding.fix is not None
    fixed = apply_edits(document, finding.fix.edits)
    assert fixed == text % left.removeprefix(" ").replace("}", "/**/")


def test_a_repeated_child_may_end_a_broken_document() -> None:
    text = "Robot R {\nRobotBase b { children { a via j a via j"
    analysis = analyse(text)
    assert analysis.faults == ()


@pytest.mark.parametrize(
    ("joints", "spare"), [("j", []), ("j k", ["joint 'k' is not used"]), ("j k l", [])]
)
def test_the_only_joint_left_may_be_meant_by_a_joint_named_twice(
    joints: str, spare: list[str]
) -> None:
    text = robot(link("a", 1), link("b", 2), base="a via j b via j", joints=joints)
    (finding,) = found("KD205", text)
    assert finding.message == "joint 'j' already connects link 'a'"
    assert [r.message for r in finding.related] == ["'a' moves by 'j'", *spare]


def test_the_base_is_shown_where_it_is_a_child() -> None:
    text = robot(link("a", 1, "ground via k"), base="a via j", joints="j k")
    (finding,) = found("KD206", text)
    assert finding.message == "the base 'ground' cannot be a child of 'a'"
    (related,) = finding.related
    assert text[related.start : related.end] == "ground" and related.start < finding.start
