"""Poses and numbers as written: each sentence of their rules, and what they leave alone."""

import pytest
from tests.support.example_documents import document_of
from tests.support.examples import (
    STEEL_BALL,
    inertia,
    joint,
    link,
    pitched_joint,
    placed_joint,
    robot,
)
from tests.support.one_rule import found, told

from kindsl.language.text.edits import apply_edits


def at(translation: str, rotation: str = "0.1, 0.2, 0.3", name: str = "elbow") -> str:
    """Return a revolute joint at a pose."""
    return joint(name, rotation=rotation).replace("0.0, 0.0, 0.3", translation, 1)


def ball(**moments: str) -> str:
    section = STEEL_BALL
    for name, value in moments.items():
        given = "0.0041" if len(name) == 2 else "0.0"
        section = section.replace(f"{name}={given}", f"{name}={value}" if value else "")
    return link("ball", 1, inertia=section)


@pytest.mark.parametrize(
    ("translation", "fixed"),
    [
        ("425.0, 0.0, 30.0", "0.425, 0.0, 0.03"),
        ("0.0, -425.0, 0.0", "0.0, -0.425, 0.0"),
        ("425.0, 0.02, 12.0", "0.425, 0.02, 0.012"),
        ("425.0, 0.5, 0.0", None),
        ("425.0, 0.02, 2.0", None),
        ("425.0, x, 0.0", None),
    ],
)
def test_a_vector_in_millimetres_is_told_once(translation: str, fixed: str | None) -> None:
    text = document_of(at(translation))
    (finding,) = found("KD502", text)
    assert (finding.fix is not None) == (fixed is not None)
    if finding.fix is not None and fixed is not None:
        assert apply_edits(text, finding.fix.edits) == document_of(at(fixed))


@pytest.mark.parametrize(("y", "is_unit"), [("1.0", False), ("2.0", True)])
def test_a_vector_with_a_number_of_others_is_not_in_millimetres(y: str, is_unit: bool) -> None:
    """The drums of a cable robot stand at the corners of a square; one has a digit too many."""
    corners = ("1.0, 1.0, 0.5", "-1.0, 1.0, 0.5", f"-1000.0, {y}, 0.0")
    drums = "".join(at(corner, name=f"drum{n}") for n, corner in enumerate(corners))
    (finding,) = found("KD502", document_of(drums))
    assert ("millimetres" in finding.message, finding.fix is not None) == (is_unit, is_unit)


@pytest.mark.parametrize(
    ("angle", "written"),
    [
        ("180.0", "PI"),
        ("45.0", "PI/4.0"),
        ("-90.0", "-PI/2.0"),
        ("15.0", "PI/12.0"),
        ("10.1", "0.17627825"),
    ],
)
def test_degrees_are_written_as_fractions_of_pi(angle: str, written: str) -> None:
    (finding,) = found("KD501", pitched_joint(angle))
    assert finding.message == f"angle {angle} rad is more than a whole turn; is it in degrees?"
    assert finding.fix is not None
    assert finding.fix.title == f"Write {written}"


def fingers(*poses: str, kinds: str = "rrrr", rotation: str = "0.0, 0.0, 0.5") -> str:
    names = "abcd"[: len(poses)]
    joints = [
        at(pose, rotation, f"to_{name}").replace("r_joint", f"{kind}_joint")
        for pose, name, kind in zip(poses, names, kinds, strict=False)
    ]
    links = [link(name, number) for number, name in enumerate(names, 1)]
    return robot(*links, *joints, base=" ".join(f"{name} via to_{name}" for name in names))


HERE, THERE = "0.0, 0.1, 0.0", "0.0, -0.1, 0.0"


@pytest.mark.parametrize(
    ("text", "messages"),
    [
        (fingers(HERE, THERE), []),
        (fingers(HERE, HERE), []),
        (fingers(HERE, HERE, THERE), ["joints 'to_b' and 'to_a' have the same frame"]),
        (fingers(HERE, THERE, THERE), ["joints 'to_c' and 'to_b' have the same frame"]),
        (
            fingers(HERE, "0.0, 1.0/10.0, 0.0", THERE),
            ["joints 'to_b' and 'to_a' have the same frame"],
        ),
        (fingers(HERE, HERE, kinds="rp"), []),
        (fingers(HERE, HERE, HERE), []),
        (fingers("0.0, x, 0.0", "0.0, x, 0.0"), []),
        (fingers("0.0, y, 0.0", HERE, THERE), ["joints 'to_b' and 'to_a' have the same frame"]),
        (fingers(HERE, HERE).replace("a via to_a", "a via lost"), []),
        (
            fingers(HERE, HERE, HERE, THERE),
            [
                "joints 'to_b' and 'to_a' have the same frame",
                "joints 'to_c' and 'to_a' have the same frame",
            ],
        ),
    ],
)
def test_siblings_with_one_frame(text: str, messages: list[str]) -> None:
    assert told("KD505", text, y=0.1) == messages


TURNS = ["joint 'elbow' turns about the axis of joint 'shoulder' before it"]
SLIDES = ["joint 'elbow' slides along the axis of joint 'shoulder' before it"]
SHOULDER = joint("shoulder", rotation="PI/2.0, 0.0, 0.0")


def arm(elbow: str, kinds: str = "rr", first: str = "upper via shoulder") -> str:
    links = link("upper", 1, "lower via elbow"), link("lower", 2)
    joints = SHOULDER.replace("r_joint", f"{kinds[0]}_joint"), elbow.replace("r_", f"{kinds[1]}_")
    return robot(*links, *joints, base=first)


@pytest.mark.parametrize(
    ("text", "messages"),
    [
        (arm(at("0.0, 0.0, 0.5", "0.0, 0.0, 0.3")), TURNS),
        (arm(at("0.0, 0.0, 0.5", "0.0, PI, 0.0")), TURNS),
        (arm(at("0.1, 0.0, 0.5", "0.0, 0.0, 0.3")), []),
        (arm(at("0.000001, 0.0, 0.5", "0.0, 0.0, 0.3")), []),
        (arm(at("0.0, 0.0000009, 0.5", "0.0, 0.0, 0.3")), TURNS),
        (arm(at("0.0, 0.1, 0.5", "0.0, 0.0, 0.3")), []),
        (arm(at("0.0, 0.0, 0.5", "0.1, 0.0, 0.0")), []),
        (arm(at("0.0, 0.0, 0.5", "0.0, 0.1, 0.0")), []),
        (arm(at("0.0, 0.0, x", "0.0, 0.0, 0.3")), []),
        (arm(at("0.0, 0.0, y", "0.0, 0.0, 0.3")), TURNS),
        (arm(at("0.1, 0.1, 0.5", "0.0, 0.0, 0.3"), "pp"), SLIDES),
        (arm(at("0.1, 0.1, 0.5", "0.1, 0.0, 0.3"), "pp"), []),
        (arm(at("0.0, 0.0, 0.5", "0.0, 0.0, 0.3"), "rp"), []),
        (arm(at("0.0, 0.0, 0.5", "0.0, 0.0, 0.3"), "pr"), []),
        (arm(at("0.0, 0.0, 0.5", "0.0, 0.0, 0.3"), first=""), []),
        (arm(at("0.0, 0.0, 0.5", "0.0, 0.0, 0.3"), first="upper via lost"), []),
        (arm(at("0.0, 0.0, 0.5", "0.0, 0.0, 0.3"), first="upper via elbow"), []),
    ],
)
def test_joints_on_one_axis(text: str, messages: list[str]) -> None:
    assert told("KD506", text, y=0.5) == messages


@pytest.mark.parametrize(
    ("rotation", "count"),
    [
        ("0.1, PI/2.0, 0.1", 1),
        ("0.1, -PI/2.0, 0.1", 1),
        ("0.1, right, 0.1", 1),
        ("0.1, unbound, 0.1", 0),
        ("0.1, PI, 0.1", 0),
        ("zero, PI/2.0, 0.1", 0),
        ("0.1, PI/2.0, zero", 0),
        ("0.1, 0.0, 0.1", 0),
    ],
)
def test_gimbal_lock(rotation: str, count: int) -> None:
    frames = f"frames {{ eye {{ translation = (0.0, 0.0, 0.1) rotation = ({rotation}) }} }}"
    head = link("head", 1).removesuffix("}\n") + f"{frames} }}\n"
    for text in (joint("elbow", rotation=rotation), head):
        assert len(found("KD504", text, right=1.5707963, zero=0.0)) == count


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (at("0.000001, 0.0, 0.0"), "0.000001"),
        (at("0.1, 0.000001, -0.000002"), "0.000001 and 1 more value here"),
        (at("0.1, 0.000001, 0.000002", "0.000003, 0.0, x"), "0.000001 and 2 more values here"),
        (ball(Ix="0.000003", Iy="0.000003", Iz="0.000003"), "0.000003 and 2 more values here"),
        (ball(Ixy="0.000003"), "0.000003"),
        (ball(Ixy="0.000003", Ixz="0.0000001", Iyz="-0.000003"), "0.000003 and 1 more value here"),
        (ball(Ixy="0.0000001"), None),
        (ball(Ixy="-0.0000001"), None),
        (ball(Ix="x", Iy="x", Ixy="0.0000001"), None),
        (ball(Ix="x", Iy="x", Iz="x", Ixy="0.0000001"), "0.0000001"),
        (ball(Ix="", Iy="0.0", Iz="-50.0", Ixy="0.000003"), None),
        (ball(Ix="x", Iy="0.000003", Iz="50.0"), "0.000003"),
    ],
)
def test_tiny_values_are_counted_in_each_block(text: str, message: str | None) -> None:
    expected = [] if message is None else [f"robcogen2 treats {message} as zero"]
    assert told("KD507", text, "robcogen2") == expected


def test_a_tiny_value_in_a_frame_of_a_link_without_inertia() -> None:
    frames = "frames { eye { translation = (0.000001, 0.0, 0.1) rotation = (0.0, 0.0, 0.0) } }"
    text = link("head", 1, inertia="").removesuffix("}\n") + f"{frames} }}\n"
    assert told("KD507", text, "robcogen2") == ["robcogen2 treats 0.000001 as zero"]


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (at("0.123456789, 0.0, 0.0"), None),
        (at("0.1234567891, 0.0, 0.0"), "0.1234567891 has"),
        (at("123456.789, 0.0, 0.0"), None),
        (at("1234567.891, 0.0, 0.0"), "1234567.891 has"),
        (at("0.1, 0.1234567891, 1.234567891"), "0.1234567891 and 1 more number here have"),
        (at("0.1234567891, 1.234567891, 1.234567891"), "0.1234567891 and 2 more numbers here have"),
        (at("0.0000000000000, 0.0, 0.0"), None),
        (at("1.234567891 reach, 0.0, 0.0"), None),
        (ball(Ix="0.00412345678912"), "0.00412345678912 has"),
    ],
)
def test_long_numbers_are_counted_in_each_block(text: str, message: str | None) -> None:
    expected = [] if message is None else [f"{message} more digits than robcogen keeps"]
    assert told("KD508", text) == expected


@pytest.mark.parametrize(
    ("targets", "codes"),
    [
        ((), ["KD508"]),
        (("robcogen",), ["KD508"]),
        (("robcogen2",), ["KD507"]),
        (("robcogen", "robcogen2"), ["KD507", "KD508"]),
    ],
)
def test_each_generator_has_its_own_precision(targets: tuple[str, ...], codes: list[str]) -> None:
    text = at("0.000001, 0.1234567891, 0.0")
    assert [code for code in ("KD507", "KD508") for _ in found(code, text, *targets)] == codes


@pytest.mark.parametrize(
    ("angle", "message"),
    [
        ("1.5708", "angle 1.5708 is PI/2.0"),
        ("-1.5708", "angle -1.5708 is -PI/2.0"),
        ("6.2832", "angle 6.2832 is PI/0.5"),
        ("0.00", None),
        ("0.000000", None),
        ("1.5708 x", None),
        ("1.5708/1.0", None),
        ("3.1", None),
    ],
)
def test_a_number_is_a_fraction_of_pi(angle: str, message: str | None) -> None:
    assert told("KD503", pitched_joint(angle)) == ([] if message is None else [message])


@pytest.mark.parametrize(
    ("mass", "height", "across", "along", "n_told"),
    [
        ("5600.0", "12.4741", "1040000.0", "2000.0", 0),
        ("5600.0", "0.124741", "190.0", "104.0", 1),
        ("5.6", "12.4741", "1040.0", "2.0", 2),
    ],
)
def test_a_crane_has_long_links(
    mass: str, height: str, across: str, along: str, n_told: int
) -> None:
    tower = link("tower", 1, "jib via slew", inertia(mass, height, across, across, along))
    places = joint("yaw"), placed_joint("slew", "0.4, 0.0, 19.5", "0.0, 0.0, 0.0")
    text = robot(tower, link("jib", 2), base="tower via yaw").removesuffix("}\n")
    assert len(found("KD502", f"{text}{''.join(places)}}}\n")) == n_told
