"""Numbers in order: what the fix writes, and where an order is broken (KD701, KD705)."""

import random

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.support.one_rule import found, told

from kindsl.analysis.analysis import analyse
from kindsl.analysis.settings import Settings
from kindsl.rules.examples import link, robot
from kindsl.rules.renumbering import regular_order, renumbering
from kindsl.text.edits import apply_edits

NUMBERS = Settings(select=("KD101", "KD109", "KD110"))


def chain(*numbers: int) -> str:
    names = [f"part{n}x" for n in range(len(numbers))]
    links = [
        link(name, number, f"{below} via to_{below}" if below else "")
        for name, number, below in zip(names, numbers, [*names[1:], ""], strict=True)
    ]
    joints = " ".join(f"to_{name}" for name in names)
    return robot(*links, base=f"{names[0]} via to_{names[0]}", joints=joints)


@settings(max_examples=40, deadline=None)
@given(seed=st.integers(0, 10**9), size=st.integers(1, 12))
def test_renumbered_links_are_numbered_regularly(seed: int, size: int) -> None:
    generator = random.Random(seed)
    text = chain(*(generator.randrange(1, 2 * size + 1) for _ in range(size)))
    analysis = analyse(text, NUMBERS)
    fix = renumbering(analysis.model)
    assert bool(analysis.findings) == (fix is not None)
    for finding in analysis.findings[:1]:
        assert finding.fix is not None
        after = analyse(apply_edits(text, finding.fix.edits), NUMBERS)
        assert after.findings == ()
        assert [body.id for body in after.model.links] == list(range(1, size + 1))


def test_as_few_numbers_as_possible_change() -> None:
    analysis = analyse(chain(1, 2, 4, 5), NUMBERS)
    fix = renumbering(analysis.model)
    assert fix is not None
    assert [change.text for change in fix.changes] == ["3", "4"]


def test_what_is_no_tree_is_not_renumbered() -> None:
    loop = robot(
        link("one", 3, "other via b"), link("other", 4, "one via a"), base="", joints="a b"
    )
    assert renumbering(analyse(loop).model) is None


def links(*ids: object) -> str:
    names = "abcdef"[: len(ids)]
    blocks = [
        link(name, 0).replace("id = 0", "" if number is None else f"id = {number}")
        for name, number in zip(names, ids, strict=True)
    ]
    base = " ".join(f"{name} via to_{name}" for name in names)
    return robot(*blocks, base=base, joints=" ".join(f"to_{name}" for name in names))


@pytest.mark.parametrize(
    ("ids", "messages"),
    [
        ((1, 2, 3), []),
        ((1, 1, 2), []),
        ((2, 1, 3), ["links are not in order of id: 'b' (1) follows 'a' (2)"]),
        ((1, 3, 2), ["links are not in order of id: 'c' (2) follows 'b' (3)"]),
        ((3, 2, 1), ["links are not in order of id: 'b' (2) follows 'a' (3)"]),
        ((2, None, 1), []),
        ((None, 2, 1), ["links are not in order of id: 'c' (1) follows 'b' (2)"]),
        ((2, 1, None), ["links are not in order of id: 'b' (1) follows 'a' (2)"]),
    ],
)
def test_links_are_in_the_order_of_their_numbers(
    ids: tuple[object, ...], messages: list[str]
) -> None:
    assert told("KD701", links(*ids)) == messages


def before(first: str, first_id: int, second: str, second_id: int) -> list[str]:
    message = f"joint '{second}' moves link {second_id}, joint '{first}' before it link {first_id}"
    return [message]


@pytest.mark.parametrize(
    ("base", "joints", "messages"),
    [
        ("a via i b via j c via k", "i j k", []),
        ("a via i b via j c via k", "j i k", before("j", 2, "i", 1)),
        ("a via i b via j c via k", "i k j", before("k", 3, "j", 2)),
        ("a via i b via j c via k", "k j i", before("k", 3, "j", 2)),
        ("a via i c via k", "k j i", before("k", 3, "i", 1)),
        ("a via i b via j b via k", "j k i", before("k", 2, "i", 1)),
        ("a via i c via j b via j", "j i k", []),
        ("a via i lost via j", "j i", []),
        ("a via i d via j", "j i", []),
    ],
)
def test_joints_are_in_the_order_of_their_links(
    base: str, joints: str, messages: list[str]
) -> None:
    """Link d has no number."""
    blocks = [link(name, number) for number, name in enumerate("abc", 1)]
    text = robot(*blocks, link("d", 9).replace("id = 9", ""), base=base, joints=joints)
    assert told("KD705", text) == messages


def test_the_place_before_is_shown() -> None:
    (finding,) = found("KD701", links(2, 1))
    assert [related.message for related in finding.related] == ["id 2"]
    text = robot(link("a", 1), link("b", 2), base="a via i b via j", joints="j i")
    (finding,) = found("KD705", text)
    assert [related.message for related in finding.related] == ["moves link 2"]


def test_two_parents_are_not_renumbered() -> None:
    links = link("one", 3, "top via a"), link("two", 4, "top via b"), link("top", 5)
    text = robot(*links, base="one via c two via d", joints="a b c d")
    assert renumbering(analyse(text).model) is None


@pytest.mark.parametrize(("findings", "is_offered"), [(200_000, True), (200_001, False)])
def test_a_fix_is_not_copied_without_end(findings: int, is_offered: bool) -> None:
    """One number changes; two hundred thousand changes are as much as is told in total."""
    model = analyse(chain(1, 2, 4), NUMBERS).model
    assert (renumbering(model, findings) is not None) == is_offered


@pytest.mark.parametrize(
    ("ids", "order"), [((2, 1, 3), "b a c"), ((1, 3, 2), "a c b"), ((3, 2, 1), "c b a")]
)
def test_links_are_ordered_by_their_numbers_where_they_may_be(
    ids: tuple[int, ...], order: str
) -> None:
    names = "abc"
    links = [link(name, number) for name, number in zip(names, ids, strict=True)]
    pairs = " ".join(f"{name} via to_{name}" for name in names)
    joints = " ".join(f"to_{name}" for name in names)
    beside = analyse(robot(*links, base=pairs, joints=joints)).model
    assert [str(body.name) for body in regular_order(beside) or ()] == order.split()
    hub = link("hub", 9, pairs)
    below = analyse(robot(*links, hub, base="hub via to_hub", joints=f"{joints} to_hub")).model
    assert [str(body.name) for body in regular_order(below) or ()] == ["hub", *order.split()]


def test_a_link_may_carry_the_base_in_error() -> None:
    links = link("lost", 2, "ground via neck"), link("arm", 1)
    model = analyse(robot(*links, base="arm via elbow", joints="elbow neck")).model
    assert [str(body.name) for body in regular_order(model) or ()] == ["arm", "lost"]


def test_links_without_a_number_come_first() -> None:
    links = link("a", 1), link("b", 2).replace("id = 2", "")
    model = analyse(robot(*links, base="a via ja b via jb", joints="ja jb")).model
    assert [str(body.name) for body in regular_order(model) or ()] == ["b", "a"]
    assert renumbering(model) is None
    below = robot(link("hub", 9, "a via ja b via jb"), *links, base="hub via jh", joints="ja jb jh")
    assert [str(body.name) for body in regular_order(analyse(below).model) or ()] == [
        "hub",
        "b",
        "a",
    ]
