"""Names, numbers and references: which of two is reported, as what, and for whom."""

import pytest
from tests.support.examples import STEEL_BALL, joint, link, robot
from tests.support.one_rule import found, told, told_as

POSE = "{ translation = (0.1, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) }"


def chain(*ids: int | str) -> str:
    """Return links a, b, c, ..., each of which carries the next."""
    names = "abcdefghij"[: len(ids)]
    children = [f"{name} via to_{name}" for name in names[1:]] + [""]
    links = [
        link(name, 0, child).replace("id = 0", f"id = {number}")
        for name, number, child in zip(names, ids, children, strict=True)
    ]
    return robot(*links, base="a via to_a", joints=" ".join(f"to_{name}" for name in names))


def framed(name: str, number: int, *frames: str, inertia: str = STEEL_BALL, more: str = "") -> str:
    section = f"frames {{ {' '.join(f'{frame} {POSE}' for frame in frames)} }}"
    return link(name, number, inertia=inertia).removesuffix("}\n") + f"{section}{more} }}\n"


def given_in(frame: str) -> str:
    return STEEL_BALL[:-1] + f"ref_frame = {frame} }}"


@pytest.mark.parametrize(
    ("ids", "messages"),
    [
        ((1, 2, 3), []),
        ((3, 1, 2), []),
        ((2, 3), ["the links are numbered from 2, not from 1"]),
        ((7, 8), ["the links are numbered from 7, not from 1"]),
        ((3, 7, 8), ["ids 1 and 2 are missing, and id 7 is out of sequence"]),
        ((1, 3, 4), ["id 2 is missing, and id 3 is out of sequence"]),
        ((1, 4, 5), ["ids 2 and 3 are missing, and id 4 is out of sequence"]),
        ((1, 3, 5), ["id 2 is missing, and id 5 is out of sequence"]),
        (
            (1, 3, 5, 6, 7),
            [
                "id 2 is missing, and id 3 is out of sequence",
                "id 4 is missing, and id 5 is out of sequence",
            ],
        ),
        ((1, 6, 7, 9), ["ids 2 to 4 are missing, and id 9 is out of sequence"]),
        (
            (2, 4, 7, 8, 9),
            [
                "id 3 is missing, and id 4 is out of sequence",
                "id 1 is missing, and id 7 is out of sequence",
                "id 5 is missing, and id 9 is out of sequence",
            ],
        ),
    ],
)
def test_missing_numbers_are_told_at_a_number_that_is_too_great(
    ids: tuple[int, ...], messages: list[str]
) -> None:
    assert told("KD109", chain(*ids)) == messages


@pytest.mark.parametrize(
    ("ids", "repeated", "missing"),
    [
        ((1, 2, 2, 5), 1, 0),
        ((1, 3, 3, 3), 2, 0),
        ((1, 2, 2, 6, 7), 1, 1),
        ((1, 2, 2, 2, 6, 7), 2, 0),
        ((2, 2, 3), 1, 1),
    ],
)
def test_a_number_that_two_links_have_explains_one_that_none_has(
    ids: tuple[int, ...], repeated: int, missing: int
) -> None:
    """Except that nothing explains why the numbers do not begin with 1."""
    assert len(told("KD101", chain(*ids))) == repeated
    assert len(told("KD109", chain(*ids))) == missing


@pytest.mark.parametrize(
    ("ids", "count"),
    [
        (("", 1, 3), 0),
        (("x", 1, 3), 0),
        ((0, 1, 3), 0),
        (("", 1, 4), 0),
        (("", 3), 0),
        ((2, ""), 0),
        (("", 1, 4, 5), 1),
        (("", 2, 2, 4, 5), 0),
        (("", 3, 3, 4, 5), 1),
        (("", 2, 2, 7, 8, 9), 2),
    ],
)
def test_a_link_without_a_number_may_have_a_missing_one(
    ids: tuple[int | str, ...], count: int
) -> None:
    assert len(told("KD109", chain(*ids))) == count


def test_an_error_elsewhere_in_a_link_leaves_its_number_certain() -> None:
    broken = chain(1, 3).replace("CoM = (0.0, 0.0, 0.0)", "CoM = (0.0; 0.0, 0.0)")
    assert told("KD109", broken) == ["id 2 is missing, and id 3 is out of sequence"]
    assert len(told("KD109", chain(1, 2, 4))) == 1
    assert told("KD109", chain(1, ";2", 4)) == []


def test_an_undefined_link_may_have_the_missing_number() -> None:
    for ids, count in (((1, 3), 0), ((1, 4, 5), 1)):
        text = chain(*ids).replace("children {  }", "children { gripper via to_gripper }")
        assert len(told("KD109", text)) == count


def test_loops_have_no_order_of_numbers() -> None:
    links = link("upper", 3, "lower via elbow"), link("lower", 2, "upper via wrist")
    text = robot(*links, link("hand", 1), base="hand via palm", joints="elbow wrist palm")
    assert len(told("KD201", text)) == 1
    assert told("KD110", text) == []


@pytest.mark.parametrize(("parent", "count"), [(3, 1), (4, 0)])
def test_a_link_that_is_not_defined_yet_has_a_number_too(parent: int, count: int) -> None:
    """So 3 may be in order where two links of three are there; 4 is wrong otherwise."""
    links = link("a", parent, "b via jb"), link("b", 1, "lost via jc")
    text = robot(*links, base="a via ja", joints="ja jb jc")
    assert len(told("KD110", text)) == count


def test_the_order_of_numbers_is_fatal_for_robcogen2_alone() -> None:
    message = "id 1 of 'b' is below id 2 of its parent 'a'"
    assert told_as("KD110", chain(2, 1)) == [("warning", message)]
    assert told_as("KD110", chain(2, 1), "robcogen") == [("warning", message)]
    assert told_as("KD110", chain(2, 1), "robcogen2") == [("error", message)]
    assert told_as("KD110", chain(2, 1), "robcogen", "robcogen2") == [("error", message)]


def test_links_of_one_name_are_not_told_of_their_number_too() -> None:
    text = robot(link("a", 1), link("a", 1), base="a via j", joints="j")
    assert told("KD102", text) == ["'a' is already the name of another link"]
    assert told("KD101", text) == []


def test_a_second_base_is_no_link_with_a_name_taken() -> None:
    text = robot(link("a", 1), base="a via j", joints="j")
    again = text.replace("link a", "RobotBase ground { children { } }\nlink a", 1)
    assert told("KD102", again) == []
    assert len(told("KD009", again)) == 1


@pytest.mark.parametrize(
    ("names", "codes"), [(("left", "right"), ["KD111"]), (("left", "left"), ["KD103"])]
)
def test_joints_of_one_name_are_not_told_of_their_number_too(
    names: tuple[str, str], codes: list[str]
) -> None:
    joints = [joint(name).replace("{", "{ id = 1", 1) for name in names]
    text = robot(link("a", 1), *joints, base=f"a via {names[0]}")
    assert [code for code in ("KD103", "KD111") for _ in found(code, text)] == codes


def test_a_frame_is_told_once_in_one_link_and_once_across_links() -> None:
    text = robot(framed("a", 1, "eye", "eye"), framed("b", 2, "ear", "eye"), base="a via j b via k")
    assert sorted(told_as("KD104", text)) == [
        ("error", "link 'a' has two frames 'eye'"),
        ("warning", "frame 'eye' is already defined in link 'a'"),
    ]


def test_the_first_of_equal_frames_is_the_one_that_an_inertia_means() -> None:
    hand = framed("hand", 1, "tool", inertia=given_in("eye"))
    links = hand, framed("head", 2, "eye"), framed("tail", 3, "eye")
    text = robot(*links, base="hand via j head via k tail via l")
    assert told("KD108", text) == ["frame 'eye' belongs to link 'head', not to 'hand'"]
    own = robot(framed("hand", 1, "eye", inertia=given_in("eye")), *links[1:])
    assert told("KD108", own) == []


@pytest.mark.parametrize(
    ("targets", "severity"),
    [
        ((), "error"),
        (("robcogen",), "error"),
        (("robcogen2",), "warning"),
        (("robcogen", "robcogen2"), "error"),
    ],
)
def test_robcogen2_alone_takes_a_frame_of_another_link(
    targets: tuple[str, ...], severity: str
) -> None:
    links = link("hand", 1, inertia=given_in("eye")), framed("head", 2, "eye")
    (finding,) = found("KD108", robot(*links, base="hand via j head via k"), *targets)
    assert finding.severity == severity


@pytest.mark.parametrize(
    ("own", "more", "count"),
    [("eye", "", 1), ("eye", " tip", 0), ("eye", " toe", 1), ("tip", "", 0), ("", "", 0)],
)
def test_a_frame_may_be_lost_where_its_link_is_broken(own: str, more: str, count: int) -> None:
    """It is where its name stands a second time, or a frame lacks its name."""
    hand = framed("hand", 1, own, inertia=given_in("tip"), more=f"{more} ; ")
    assert len(told("KD107", robot(hand, base="hand via j"))) == count


@pytest.mark.parametrize(("word", "count"), [("tip", 0), ("toe", 1)])
def test_a_frame_may_be_lost_in_another_link(word: str, count: int) -> None:
    links = (
        framed("hand", 1, "eye", inertia=given_in("tip")),
        framed("arm", 2, "e", more=f" {word}"),
    )
    assert len(told("KD107", robot(*links, base="hand via j arm via k"))) == count


@pytest.mark.parametrize(
    ("link_name", "joint_name", "frame", "messages"),
    [
        ("a", "j", "f", []),
        ("a", "a", "f", [("error", "joint 'a' has the name of the link 'a'")]),
        ("a", "A", "f", [("warning", "joint 'A' differs by case only from the link 'a'")]),
        ("a", "j", "a", [("warning", "frame 'a' has the name of the link 'a'")]),
        ("a", "j", "J", [("warning", "frame 'J' differs by case only from the joint 'j'")]),
        ("Arm", "j", "f", [("warning", "link 'Arm' has the name of the robot 'Arm'")]),
        (
            "a",
            "Ground",
            "f",
            [("warning", "joint 'Ground' differs by case only from the link 'ground'")],
        ),
    ],
)
def test_names_of_different_things_clash(
    link_name: str, joint_name: str, frame: str, messages: list[tuple[str, str]]
) -> None:
    text = robot(
        framed(link_name, 1, frame), base=f"{link_name} via {joint_name}", joints=joint_name
    )
    assert told_as("KD112", text) == messages


@pytest.mark.parametrize(
    ("targets", "severity"),
    [(("robcogen",), "error"), (("robcogen2",), "warning"), (("robcogen", "robcogen2"), "error")],
)
def test_robcogen2_alone_takes_a_joint_with_the_name_of_its_link(
    targets: tuple[str, ...], severity: str
) -> None:
    text = robot(link("a", 1), base="a via a", joints="a")
    (finding,) = found("KD112", text, *targets)
    assert finding.severity == severity


@pytest.mark.parametrize(
    ("links", "joints"), [("a a", "i j"), ("a b", "i i"), ("a A", "i j"), ("a b", "i I")]
)
def test_two_of_a_kind_with_one_name_do_not_clash(links: str, joints: str) -> None:
    """They are told of as such, unless they differ in case."""
    blocks = [link(name, number) for number, name in enumerate(links.split(), 1)]
    text = robot(*blocks, joints=joints)
    differ = len({*links.split(), *joints.split()}) == 4
    assert len(told("KD112", text)) == differ
    assert len(told("KD102", text) + told("KD103", text)) == (not differ)


def test_what_has_no_name_clashes_with_nothing() -> None:
    nameless = link("", 1) + "r_joint {\n    ref_frame " + POSE + " }\n" + framed("a", 2, "")
    assert told("KD112", robot(nameless)) == []


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (robot(name="union"), "'union' is a keyword of C++"),
        (robot(link("until", 1)), "'until' is a keyword of Octave"),
        (joint("while"), "'while' is a keyword of C++"),
        (framed("a", 1, "endif"), "'endif' is a keyword of Octave"),
        (joint("j").replace("0.3", "short"), "'short' is a keyword of C++"),
        (framed("a", 1, "fr_a"), "'fr_a' is already the name of the frame of link 'a'"),
        (
            framed("a", 1, "fr_ground"),
            "'fr_ground' is already the name of the frame of link 'ground'",
        ),
        (framed("a", 1, "fr_b"), None),
        (framed("a", 1, "xr_a"), None),
    ],
)
def test_reserved_names_of_all_things(text: str, message: str | None) -> None:
    assert told("KD113", text) == ([] if message is None else [message])
