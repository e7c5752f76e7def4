"""Each mistake in who carries whom is counted once, and excuses what it leaves over."""

from types import SimpleNamespace
from typing import Any

import pytest
from tests.support.examples import link, robot

from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.rules.missing_names import missing_names
from kindsl.judgement.rules.reference_defects import ReferenceDefects, reference_defects
from kindsl.language.semantics.kinematic_tree import Edge
from kindsl.language.text.nearest import hint


def defects(text: str) -> dict[str, list[Any]]:
    """Return what is found, as written; without the idle things, of which nothing is said."""
    found = reference_defects(analyse(text).model)
    names = [name for name in ReferenceDefects._fields if not name.startswith("idle")]
    return {name: list(map(written, things)) for name in names if (things := getattr(found, name))}


def written(thing: Any) -> Any:
    if isinstance(thing, Edge):
        return f"{thing.predecessor.name}: {thing.child.link} via {thing.child.joint}"
    return tuple(map(written, thing)) if isinstance(thing, tuple) else str(thing.name)


def text_of(base: str, joints: str, **links: str) -> str:
    """Return a document: what the base and each link carry, and the names of the joints."""
    numbered = enumerate(links.items(), 1)
    return robot(
        *(link(name, n, children) for n, (name, children) in numbered), base=base, joints=joints
    )


TWO, THREE = "elbow wrist", "elbow wrist ankle"
ONE_ARM = "arm via elbow"
ARM = f"ground: {ONE_ARM}"
TWICE = f"{ONE_ARM} {ONE_ARM}"
PASTED = {"repeated": [(ARM, ARM)]}


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (text_of(f"{ONE_ARM} hand via wrist", TWO, arm="", hand=""), {}),
        # A link that is missing altogether may carry whatever nothing carries.
        (
            text_of(f"{ONE_ARM} hnd via wrist", TWO, arm="", hand="", foot="", head=""),
            {"undefined_links": ["ground: hnd via wrist"]},
        ),
        # A wrong joint means the one with the most similar name, if any.
        (
            text_of(f"{ONE_ARM} hand via wrst", "elbow ankle wrist", arm="", hand=""),
            {"undefined_joints": ["ground: hand via wrst"], "unused_joints": ["ankle"]},
        ),
        (
            text_of(f"{ONE_ARM} hand via q1", "elbow ankle wrist", arm="", hand=""),
            {"undefined_joints": ["ground: hand via q1"], "unused_joints": ["wrist"]},
        ),
        # Names the wrong way round mean the two that they are of.
        (
            text_of("wrist via hand", "ankle wrist", foot="", hand=""),
            {"swapped": ["ground: wrist via hand"], "orphans": ["foot"]},
        ),
        (
            text_of("wrist via hand", "ankle wrist", hand=""),
            {"swapped": ["ground: wrist via hand"], "unused_joints": ["ankle"]},
        ),
        (
            text_of("wrist via hand", "wrist hand", hand=""),
            {"undefined_links": ["ground: wrist via hand"]},
        ),
        # The base as a child takes the place of a link, unless a joint is left over besides.
        (
            text_of(ONE_ARM, TWO, arm="ground via wrist", hand=""),
            {"bases": ["arm: ground via wrist"]},
        ),
        (
            text_of(ONE_ARM, THREE, arm="ground via wrist", hand=""),
            {"bases": ["arm: ground via wrist"], "orphans": ["hand"]},
        ),
        (
            text_of(ONE_ARM, THREE, arm="ground via wrist ground via ankle"),
            {"bases": ["arm: ground via wrist", "arm: ground via ankle"]},
        ),
        (
            text_of(ONE_ARM, THREE, arm="ground via elbow", hand="", foot=""),
            {"bases": ["arm: ground via elbow"], "orphans": ["foot"]},
        ),
        # A pair that is there twice was pasted, and takes the place of a whole pair.
        (text_of(TWICE, TWO, arm="", hand=""), PASTED),
        (text_of(TWICE, TWO, arm="", hand="", foot=""), {**PASTED, "orphans": ["foot"]}),
        (text_of(TWICE, THREE, arm="", hand="", foot=""), {**PASTED, "orphans": ["foot"]}),
        (text_of(TWICE, THREE, arm="", hand=""), {**PASTED, "unused_joints": ["ankle"]}),
        # With another joint it names a wrong link only.
        (
            text_of(f"{ONE_ARM} arm via wrist", TWO, arm="", hand=""),
            {"repeated": [(ARM, "ground: arm via wrist")]},
        ),
        (
            text_of(f"{ONE_ARM} arm via wrist", THREE, arm="", hand="", foot=""),
            {"repeated": [(ARM, "ground: arm via wrist")], "orphans": ["foot"]},
        ),
        (
            text_of(f"{ONE_ARM} arm via wrist", f"{THREE} neck", arm="", hand="", foot=""),
            {"repeated": [(ARM, "ground: arm via wrist")], "orphans": ["hand", "foot"]},
        ),
        # A second parent is the later one.
        (
            text_of(f"{ONE_ARM} hand via wrist", THREE, arm="hand via ankle", hand="", foot=""),
            {"extra_parents": [("ground: hand via wrist", "arm: hand via ankle")]},
        ),
        # A joint in two pairs leaves one over, and that says of no missing pair.
        (
            text_of(f"{ONE_ARM} hand via elbow", TWO, arm="", hand=""),
            {"reused_joints": [(ARM, "ground: hand via elbow")]},
        ),
        (
            text_of(f"{ONE_ARM} hand via elbow", THREE, arm="", hand=""),
            {"reused_joints": [(ARM, "ground: hand via elbow")], "unused_joints": ["ankle"]},
        ),
        (
            text_of(
                f"{ONE_ARM} hand via elbow",
                "elbow wrist neck",
                arm="hand via neck",
                hand="",
                foot="",
            ),
            {
                "reused_joints": [(ARM, "ground: hand via elbow")],
                "extra_parents": [("ground: hand via elbow", "arm: hand via neck")],
            },
        ),
        # Which of two joints of a name is meant cannot be told.
        (text_of(f"{ONE_ARM} hand via elbow", "elbow elbow", arm="", hand=""), {}),
        # A loop is one mistake: the pair that closes it names a wrong link.
        (
            text_of(ONE_ARM, THREE, arm="hand via wrist", hand="arm via ankle", foot=""),
            {"loops": [("arm: hand via wrist", "hand: arm via ankle")]},
        ),
        (
            text_of(ONE_ARM, THREE, arm="hand via wrist", hand="arm via elbow", foot=""),
            {"loops": [("arm: hand via wrist", "hand: arm via elbow")]},
        ),
        (
            text_of(ONE_ARM, f"{THREE} neck", arm="hand via wrist", hand="arm via neck", foot=""),
            {"loops": [("arm: hand via wrist", "hand: arm via neck")], "orphans": ["foot"]},
        ),
        (
            text_of(
                "foot via ankle",
                f"{THREE} neck",
                arm="hand via wrist",
                hand="arm via neck",
                foot="arm via elbow",
            ),
            {"loops": [("arm: hand via wrist", "hand: arm via neck")]},
        ),
        (
            text_of(
                ONE_ARM, THREE, arm="hand via wrist", hand="foot via ankle", foot="arm via elbow"
            ),
            {"loops": [("arm: hand via wrist", "hand: foot via ankle", "foot: arm via elbow")]},
        ),
        # Several mistakes: each excuses its own. A pasted pair leaves a link and a joint over, a
        # wrong joint leaves one over, and a wrong link a link.
        (
            text_of(f"{TWICE} arm via wrist", THREE, arm="", hand="", foot=""),
            {"repeated": [(ARM, ARM), (ARM, "ground: arm via wrist")]},
        ),
        (
            text_of(
                f"{ONE_ARM} foot via wrst arm via neck",
                "elbow wrist neck",
                arm="",
                foot="",
                hand="",
            ),
            {
                "undefined_joints": ["ground: foot via wrst"],
                "repeated": [(ARM, "ground: arm via neck")],
            },
        ),
        # What is left out is told by its link.
        (text_of(ONE_ARM, TWO, arm="", hand=""), {"orphans": ["hand"]}),
        (text_of(ONE_ARM, "elbow", arm="", hand=""), {"orphans": ["hand"]}),
        (text_of(ONE_ARM, TWO, arm=""), {"unused_joints": ["wrist"]}),
        (
            text_of(ONE_ARM, THREE, arm="", hand=""),
            {"orphans": ["hand"], "unused_joints": ["ankle"]},
        ),
        (text_of("", TWO, arm="", hand=""), {"orphans": ["arm", "hand"]}),
    ],
)
def test_each_mistake_is_counted_once(text: str, expected: dict[str, list[Any]]) -> None:
    assert defects(text) == expected


def test_without_a_base_nothing_is_an_orphan() -> None:
    text = text_of(ONE_ARM, TWO, arm="", hand="")
    base = text[text.index("RobotBase") : text.index("link")]
    assert defects(text) == {"orphans": ["hand"]}
    assert defects(text.replace(base, "")) == {}


def test_a_link_may_have_the_name_of_the_base() -> None:
    text = text_of(ONE_ARM, TWO, arm="ground via wrist", ground="")
    assert "bases" not in defects(text)


@pytest.mark.parametrize(
    ("text", "words", "expected"),
    [
        (text_of(ONE_ARM, TWO, arm="", hand="", foot=""), "", {"orphans": ["hand", "foot"]}),
        (text_of(ONE_ARM, TWO, arm="", hand="", foot=""), "hand % ", {"orphans": ["foot"]}),
        (text_of(ONE_ARM, THREE, arm=""), "wrist % ", {"unused_joints": ["ankle"]}),
        (text_of(ONE_ARM, TWO, arm="foot via", hand="", foot=""), "", {}),
        (text_of(ONE_ARM, TWO, arm="via wrist", hand="", foot=""), "", {}),
        (
            text_of(f"{ONE_ARM} foot via neck", TWO, arm=""),
            "foot neck %",
            {"unused_joints": ["wrist"]},
        ),
        (
            text_of(f"{ONE_ARM} foot via neck", TWO, arm=""),
            "feet necks %",
            {
                "undefined_links": ["ground: foot via neck"],
                "undefined_joints": ["ground: foot via neck"],
            },
        ),
    ],
)
def test_what_broken_text_mentions_may_be_declared_or_carried_there(
    text: str, words: str, expected: dict[str, list[Any]]
) -> None:
    last = text.rindex("link ")
    inside = text.index("children", last)
    assert defects(f"{text[:inside]}{words}{text[inside:]}") == expected


UNKNOWN = text_of(f"{ONE_ARM} foot via neck", TWO, arm="", hand="")


def test_what_has_lost_its_name_may_be_any() -> None:
    expected = ["ground: foot via neck"]
    assert defects(UNKNOWN) == {"undefined_links": expected, "undefined_joints": expected}
    without = defects(UNKNOWN.replace("link hand", "link"))
    assert without["undefined_joints"] == expected
    assert "undefined_links" not in without
    without = defects(UNKNOWN.replace("r_joint wrist", "r_joint"))
    assert "undefined_joints" not in without


def test_what_is_cut_off_may_be_declared_beyond() -> None:
    assert defects(UNKNOWN.rstrip().removesuffix("}")) == {"orphans": ["hand"]}
    assert defects(text_of(ONE_ARM, "")) == {}


def test_one_of_two_declarations_of_a_name_may_be_what_is_not_declared() -> None:
    text = text_of(f"{ONE_ARM} foot via wrist", TWO, arm="", hand="")
    assert defects(text) == {"undefined_links": ["ground: foot via wrist"]}
    assert defects(text.replace("link hand", "link arm")) == {}
    two = text.replace("foot via wrist", "foot via wrist toe via wrist")
    found = defects(two.replace("link hand", "link arm"))
    assert found["undefined_links"] == ["ground: toe via wrist"]
    joints = text_of(f"{ONE_ARM} hand via neck", TWO, arm="", hand="")
    assert "undefined_joints" in defects(joints)
    assert defects(joints.replace("r_joint wrist", "r_joint elbow")) == {}


def test_what_two_bodies_of_a_name_carry_is_carried_once() -> None:
    text = text_of(ONE_ARM, TWO, arm="hand via wrist", leg="hand via wrist", hand="")
    assert "extra_parents" in defects(text)
    assert defects(text.replace("link leg", "link arm")) == {}


def test_what_is_found_of_a_model_is_found_once() -> None:
    model = analyse(text_of(ONE_ARM, TWO, arm="")).model
    assert reference_defects(model) is reference_defects(model)


def test_idle_is_what_no_pair_names() -> None:
    model = analyse(text_of("hnd via wrst", TWO, arm="", hand="")).model
    found = reference_defects(model)
    assert [str(link.name) for link in found.idle_links] == ["arm", "hand"]
    assert [str(joint.name) for joint in found.idle_joints] == ["elbow", "wrist"]


@pytest.mark.parametrize(
    ("position", "idle", "others", "expected"),
    [
        (0, ["elbow", "wrist"], ["wrest"], ("wrist",)),
        (0, ["elbow"], ["wrist"], ("wrist",)),
        (0, ["elbow"], ["neck"], ()),
        (19, ["wrist"], [], ("wrist",)),
        (20, ["wrist"], ["wrist"], ()),
    ],
)
def test_idle_things_are_suggested_first_and_twenty_times(
    position: int, idle: list[str], others: list[str], expected: tuple[str, ...]
) -> None:
    names: Any = ["wrst"] * (position + 1)
    free: Any = [SimpleNamespace(name=name) for name in idle]
    declared: Any = [SimpleNamespace(name=name) for name in others]
    *_, last = missing_names(names, "link", free, declared, lambda _: None)
    assert last.message == f"link 'wrst' does not exist{hint(expected)}"
