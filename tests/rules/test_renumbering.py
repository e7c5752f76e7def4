"""Numbers in order: what the fix writes, and where an order is broken (KD701, KD705)."""

import random
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.support.amount import usually
from tests.support.examples import link, robot
from tests.support.one_rule import found, told
from tests.support.published import published_models

from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.settings import Settings
from kindsl.judgement.rules.renumbering import regular_order, renumbering
from kindsl.language.text.edits import apply_edits

ROOT = Path(__file__).parents[2]
EXAMPLES, FIXTURES = ROOT / "examples", ROOT / "tests" / "fixtures"
MOST_COPIES = usually(15, 1000)
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


def documents() -> list[object]:
    """Return a parameter for each model at hand whose links are numbered."""
    own = [*sorted(EXAMPLES.glob("*.kindsl")), *sorted(FIXTURES.glob("**/*.kindsl"))]
    return [*(pytest.param(path, id=path.stem) for path in own), *published_models()]


@pytest.mark.parametrize("path", documents())
def test_a_copied_number_is_put_back(path: Path) -> None:
    """Of whichever link, from whichever other; nothing else changes."""
    text = path.read_text(encoding="utf-8", errors="replace")
    analysis = analyse(text, Settings(select=("KD1", "KD2")))
    bodies, span = analysis.model.links, analysis.resolver.span
    places = [span(body.id_place) for body in bodies if body.id_place is not None]
    is_plain = [text[start:end] for start, end in places] == [str(body.id) for body in bodies]
    if not is_plain or any(f.severity == "error" or f.code == "KD110" for f in analysis.findings):
        return
    pairs = [(one, other) for one in range(len(places)) for other in range(len(places))]
    pairs = [(one, other) for one, other in pairs if one != other]
    for one, other in random.Random(path.stem).sample(pairs, min(len(pairs), MOST_COPIES)):
        (start, end), copied = places[one], bodies[other].id
        planted = f"{text[:start]}{copied}{text[end:]}"
        findings = [f for f in analyse(planted, NUMBERS).findings if f.code == "KD101"]
        assert [f.start for f in findings] == [start]
        assert findings[0].fix is not None
        assert len(findings[0].fix.edits) == 1
        assert apply_edits(planted, findings[0].fix.edits) == text


def star(numbers: str, **joints: int) -> str:
    """Return links a, b, c, ... on the base with these numbers, some joints with numbers, too."""
    names = "abcdef"[: len(numbers.split())]
    blocks = [link(name, int(n)) for name, n in zip(names, numbers.split(), strict=True)]
    base = " ".join(f"{name} via to_{name}" for name in names)
    text = robot(*blocks, base=base, joints=" ".join(f"to_{name}" for name in names))
    for name, number in joints.items():
        text = text.replace(f"joint to_{name} {{", f"joint to_{name} {{ id = {number}", 1)
    return text


@pytest.mark.parametrize(
    ("text", "message", "title"),
    [
        (star("1 1 3"), "link 'b' reuses id 1 of link 'a'", "Change id of 'b' to 2"),
        (star("2 2 3"), "link 'a' reuses id 2 of link 'b'", "Change id of 'a' to 1"),
        (star("1 2 1"), "link 'c' reuses id 1 of link 'a'", "Change id of 'c' to 3"),
        (star("3 2 3"), "link 'a' reuses id 3 of link 'c'", "Change id of 'a' to 1"),
        # The joints tell more than the order in which the links are written.
        (star("2 2 3", a=2, b=1), "link 'b' reuses id 2 of link 'a'", "Change id of 'b' to 1"),
        # The tree tells most of all.
        (
            chain(1, 1, 3),
            "link 'part1x' reuses id 1 of link 'part0x'",
            "Change id of 'part1x' to 2",
        ),
        # A new link in the middle: the others must make room, or a child comes before its parent.
        (chain(1, 2, 2, 3), "link 'part2x' reuses id 2 of link 'part1x'", "Renumber the links"),
        (star("1 1 1 4"), "link 'b' reuses id 1 of link 'a'", "Renumber the links"),
        (star("1 1 5"), "link 'b' reuses id 1 of link 'a'", "Renumber the links"),
    ],
)
def test_which_of_two_links_has_the_copy(text: str, message: str, title: str) -> None:
    first, *_ = found("KD101", text)
    assert first.message == message
    assert first.fix is not None
    assert first.fix.title == title


def test_a_copied_number_is_put_back_where_the_rest_is_in_no_order() -> None:
    """The third link is numbered before its parent, whatever the copy becomes."""
    (finding,) = found("KD101", chain(1, 1, 4, 3))
    assert finding.fix is not None
    assert finding.fix.title == "Change id of 'part1x' to 2"


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
