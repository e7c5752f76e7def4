"""What is offered for names that nothing has: what may be meant, or a block of that name."""

import pytest
from tests.support.examples import link, robot

from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.fixing import fixed, is_fixable
from kindsl.judgement.rules.base import Fix
from kindsl.judgement.rules.missing_names import missing_names
from kindsl.judgement.rules.new_blocks import new_joint, new_link
from kindsl.language.semantics.model import Model


def model_of(base: str, joints: str) -> Model:
    names = [pair.split(" via ")[0] for pair in base.split(", ")]
    links = [link(name, number) for number, name in enumerate(names, 1)]
    return analyse(robot(*links, base=base.replace(",", ""), joints=joints)).model


def offers(base: str, joints: str) -> list[tuple[str, ...]]:
    """Return the titles of what is offered for each joint that does not exist."""
    model = model_of(base, joints)
    edges = model.tree.edges
    wrong = [edge.child.joint for edge in edges if edge.joint is None]
    used = {edge.child.joint for edge in edges}
    idle = [joint for joint in model.joints if joint.name not in used]

    def new(name: str) -> Fix:
        return Fix(f"new {name}", ())

    found = missing_names(wrong, "joint", idle, model.joints, new)
    return [tuple(f.title for f in (*filter(None, (each.fix,)), *each.choices)) for each in found]


@pytest.mark.parametrize(
    ("base", "joints", "expected"),
    [
        ("arm via wrst", "wrist", [("Replace 'wrst' with 'wrist'",)]),
        ("arm via neck", "wrist", [("new neck",)]),
        # The first reference takes it.
        (
            "arm via wrst, hand via wrisst",
            "wrist",
            [("Replace 'wrst' with 'wrist'",), ("new wrisst",)],
        ),
        ("arm via neck, hand via wrst", "wrist", [("new neck",), ("Replace 'wrst' with 'wrist'",)]),
        # What is in use is told, but not written.
        ("arm via wrist, hand via wrst", "wrist", [("new wrst",)]),
        # Of several one is to be chosen.
        (
            "arm via wrist_c",
            "wrist_a wrist_b",
            [("Replace 'wrist_c' with 'wrist_a'", "Replace 'wrist_c' with 'wrist_b'")],
        ),
    ],
)
def test_what_is_offered(base: str, joints: str, expected: list[tuple[str, ...]]) -> None:
    assert offers(base, joints) == expected


@pytest.mark.parametrize(
    ("ids", "parent", "number"),
    [
        ((), 0, 1),
        ((1,), 1, 2),
        ((1, 7, 3), 0, 2),
        ((1, 7, 3), 1, 2),
        ((1, 7, 3), 3, 8),
        ((4, 1, 2), 2, 3),
        ((2, 2), 2, 3),
        ((None,), 0, 1),
        ((None, 4), 4, 5),
    ],
)
def test_a_new_link_has_a_number_that_is_missing_above_its_parents(
    ids: tuple[int | None, ...], parent: int, number: int
) -> None:
    links = [link(f"part{n}", given or 0).replace("id = 0\n", "\n") for n, given in enumerate(ids)]
    model = analyse(robot(*links)).model
    fix = new_link(model, "hand", parent_id=parent)
    assert fix is not None
    assert fix.title == "Create link 'hand'"
    assert f"link hand {{\n    id = {number}\n" in fix.changes[0].text
    after = (model.links or model.bases)[-1]
    at = fix.changes[0].at
    assert (at.island, at.start, at.end) == (after.island, after.end, after.end)


def test_the_link_that_is_missing_leaves_no_gap() -> None:
    text = robot(
        link("upper", 1, "hand via wrist tool via pan"), link("tool", 3),
        base="upper via shoulder", joints="shoulder wrist pan",
    )  # fmt: skip
    after = fixed(analyse(text), is_fixable).analysis
    assert [(str(each.name), each.id) for each in after.model.links] == [
        ("upper", 1), ("tool", 3), ("hand", 2),
    ]  # fmt: skip


def test_a_new_block_needs_a_name_and_a_place() -> None:
    model = analyse(robot(link("arm", 1), joints="elbow")).model
    assert new_link(model, "no-name") is None
    assert new_joint(model, "no-name") is None
    empty = analyse("").model
    assert new_link(empty, "hand") is None
    assert new_joint(empty, "wrist") is None
    fix = new_joint(model, "wrist")
    assert fix is not None
    assert fix.changes[0].at.start == model.joints[-1].end
    without = analyse(robot(link("arm", 1))).model
    fix = new_joint(without, "wrist")
    assert fix is not None
    assert fix.changes[0].at.start == without.links[-1].end
