"""What another format says beyond the document, or what other tools refuse of it: told."""

from math import pi
from pathlib import Path
from xml.etree.ElementTree import fromstring

import pytest
from tests.interchange.round_trips import read

import kindsl
from kindsl.frontends.cli.main import main
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.semantics.parameters import JointProperties
from kindsl.robots.interchange.format import ORDINARY, FormatError, WritingChoices
from kindsl.robots.interchange.mjcf import writing
from kindsl.robots.interchange.registry import format_named

BODY = "inertia_params { mass = 2.0 CoM = (0.0, 0.0, 0.0) Ix = 0.1 Iy = 0.2 Iz = 0.2 "
BODY += "Ixy = 0.0 Ixz = 0.0 Iyz = 0.0 }"
TEXT = f"""Robot r {{
RobotBase base {{ {BODY} children {{ arm via turn }} }}
link arm {{ id = 1 {BODY} children {{ hand via slide }} }}
link hand {{ id = 2 {BODY} children {{}} }}
r_joint turn {{ ref_frame {{ translation = (0.0, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) }} }}
p_joint slide {{ ref_frame {{ translation = (0.0, 0.0, 0.5) rotation = (0.0, 0.0, 0.0) }} }}
}}"""
TURN = "1 revolute joint got limits of a full turn each way; kindsl convert --continuous writes "
TURN += "endless joints"
SLIDE = "the joint 'slide' got limits of -1 m and 1 m, which a URDF must give"
IMPOSSIBLE = "inertia of 'hand' is physically impossible: other tools refuse it"
HAND = TEXT[TEXT.index("link hand") : TEXT.index("r_joint")]


def notes(text: str, format: str, choices: WritingChoices = ORDINARY) -> list[str]:
    skeleton = kindsl.parse(text, Settings()).skeleton()
    return list(format_named(format).write("r", skeleton, choices).remarks)


def test_limits_that_a_urdf_must_give() -> None:
    assert notes(TEXT, "urdf") == [TURN, SLIDE]
    assert notes(TEXT, "urdf", WritingChoices(endless_joints=True)) == [SLIDE]
    skeleton = kindsl.parse(TEXT, Settings()).skeleton()
    root = fromstring(format_named("urdf").write("r", skeleton, ORDINARY).text)
    given = {
        joint.get("name"): {name: float(number) for name, number in limit.items()}
        for joint in root.iter("joint")
        for limit in joint.iter("limit")
    }
    usual = {"effort": 1000.0, "velocity": 10.0}
    assert given == {
        "turn": {"lower": -2.0 * pi, "upper": 2.0 * pi, **usual},
        "slide": {"lower": -1.0, "upper": 1.0, **usual},
    }
    limits = {"slide": JointProperties(0.0, 1.0)}
    assert notes(TEXT, "urdf", WritingChoices(joints=limits)) == [TURN]


BASE = "mass and inertia of the fixed base 'base' (2.5 kg) dropped: they move nothing"


@pytest.mark.parametrize("format", ["urdf", "sdf", "mjcf"])
def test_the_mass_of_a_fixed_base_is_dropped_once(format: str) -> None:
    assert notes(TEXT, format, WritingChoices(fixed_base_mass=2.5)).count(BASE) == 1
    assert not any("fixed base" in note for note in notes(TEXT, format))


@pytest.mark.parametrize(("format", "title"), [("urdf", "URDF"), ("sdf", "SDF")])
def test_armature_is_dropped_once(format: str, title: str) -> None:
    joints = {name: JointProperties(0.0, 1.0, armature=0.5) for name in ("turn", "slide")}
    dropped = f"armature of 2 joints dropped: not supported by {title}"
    found = notes(TEXT, format, WritingChoices(joints=joints))
    assert found.count(dropped) == 1
    assert not any("armature" in note for note in notes(TEXT, format))


def test_the_command_says_what_it_drops(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "r.kindsl").write_text(TEXT)
    (tmp_path / "kindsl.toml").write_text("[joints.turn]\narmature = 0.5\n")
    assert main(["convert", str(tmp_path / "r.kindsl"), str(tmp_path / "r.urdf")]) == 0
    printed = capsys.readouterr().err
    assert printed.count("mass and inertia of the fixed base 'base' (2 kg) dropped") == 1
    assert printed.count("armature of 1 joint dropped") == 1


def test_a_floating_base_that_a_urdf_cannot_tell() -> None:
    told = "the floating base 'base' became the root link, which some tools fix"
    assert notes(TEXT.replace("RobotBase base", "RobotBase base floating"), "urdf")[-1] == told


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("RobotBase base", "RobotBase world", []),
        ("RobotBase base", "RobotBase base floating", []),
        (
            "RobotBase base",
            "RobotBase world floating",
            ["the base 'world' is now 'world_': MuJoCo's world has that name"],
        ),
        ("hand", "world", ["the link 'world' is now 'world_': MuJoCo's world has that name"]),
    ],
)
@pytest.mark.parametrize("taken", ["arm", "world_"])
def test_name_of_the_world_of_mujoco(old: str, new: str, told: list[str], taken: str) -> None:
    free = "world_" if taken == "arm" else "world__"
    told = [note.replace("world_'", f"{free}'") for note in told]
    assert notes(TEXT.replace(old, new).replace(" arm", f" {taken}"), "mjcf") == told


def test_what_mujoco_refuses_is_not_written(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(text: str) -> None:
        raise FormatError(text)

    monkeypatch.setattr(writing, "checked_text", refuse)
    with pytest.raises(FormatError, match='body name="hand"'):
        notes(TEXT, "mjcf")


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("Ix = 0.1", "Ix = 0.1", []),
        ("Ix = 0.1", "Ix = 0.0", [IMPOSSIBLE]),
        ("Ix = 0.1", "Ix = 0.41", [IMPOSSIBLE]),
        ("Ix = 0.1 Iy = 0.2 Iz = 0.2", "Ix = 0.1 Iy = 0.2 Iz = 0.3", []),
        ("mass = 2.0", "mass = -2.0", [IMPOSSIBLE]),
        ("mass = 2.0", "mass = 0.0", [IMPOSSIBLE]),
        (BODY, "", ["the link 'hand' has no mass: other tools refuse it"]),
    ],
)
def test_what_other_tools_refuse_of_an_sdf(old: str, new: str, told: list[str]) -> None:
    assert notes(TEXT.replace(HAND, HAND.replace(old, new)), "sdf") == told


@pytest.mark.parametrize(
    ("moments", "is_told"),
    [
        ("Ix = 0.1 Iy = 0.2 Iz = 0.3000000000001", False),
        ("Ix = 0.1 Iy = 0.2 Iz = 0.300000000001", True),
    ],
)
def test_rounding_makes_no_body_impossible(moments: str, is_told: bool) -> None:
    text = TEXT.replace(HAND, HAND.replace("Ix = 0.1 Iy = 0.2 Iz = 0.2", moments))
    for format in ("sdf", "mjcf"):
        told = notes(text, format)
        assert [note.startswith("inertia of 'hand' is phys") for note in told] == [True] * is_told


@pytest.mark.parametrize(("least", "is_told"), [("0.5", False), ("2", True)])
def test_what_mujoco_requires_of_a_small_body_is_added(least: str, is_told: bool) -> None:
    """Up to 2e-15 kg m^2, which is less than what a body without mass gets."""
    zeros = "0." + "0" * 14
    moments = f"Ix = -{zeros}{least.replace('.', '')} Iy = {zeros}5 Iz = {zeros}5"
    hand = HAND.replace("Ix = 0.1 Iy = 0.2 Iz = 0.2", moments)
    told = notes(TEXT.replace(HAND, hand), "mjcf")
    assert [note.startswith("inertia of 'hand' is phys") for note in told] == [True] * is_told


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        (" turn", " arm", "the joint 'arm' is now 'arm_joint': names are unique in SDF"),
        ("slide", "world", "the joint 'world' is now 'world_joint': names are unique in SDF"),
        ("base", "world", "the link 'world' is now 'world_link': names are unique in SDF"),
    ],
)
def test_a_name_that_an_sdf_cannot_give_twice_is_told(old: str, new: str, told: str) -> None:
    skeleton = kindsl.parse(TEXT.replace(old, new), Settings()).skeleton()
    made = format_named("sdf").write("r", skeleton, ORDINARY)
    assert list(made.remarks) == [told]
    names = [element.get("name") for element in fromstring(made.text).findall("model/*")]
    assert len(set(names)) == len(names) == 6


URDF = """<robot name="r"><link name="base"/><link name="arm"/><link name="tip">{tip}</link>
<joint name="j" type="continuous"><parent link="base"/><child link="arm"/></joint>
<joint name="k" type="fixed"><parent link="arm"/><child link="tip"/>
<origin xyz="{x} 0 0"/></joint></robot>"""
MASS = '<inertial><mass value="2"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/>'


@pytest.mark.parametrize(
    ("joint", "body", "is_told"),
    [
        ("l_knee", f"{MASS}</inertial>", True),
        ("l_knee", "", False),
        ("kneed", f"{MASS}</inertial>", False),
    ],
)
def test_a_robot_on_legs_may_float(joint: str, body: str, is_told: bool, tmp_path: Path) -> None:
    text = URDF.format(tip="", x="0").replace('"j"', f'"{joint}"')
    text = text.replace('<link name="base"/>', f'<link name="base">{body}</link>')
    remarks = read(text, format_named("urdf"), tmp_path).remarks
    told = "the base 'base' is fixed, and its mass without effect: for a robot on legs, use "
    assert (f"{told}--floating-base" in remarks) is is_told


def test_links_without_inertia_are_told_unless_something_fixed_to_them_has_it(tmp_path) -> None:
    fixed = "the link 'tip', fixed to 'arm', became a frame of it"
    urdf = format_named("urdf")
    empty = read(URDF.format(tip="", x="0"), urdf, tmp_path)
    assert empty.remarks == (fixed, "the link 'arm' has no inertia")
    assert read(URDF.format(tip=f"{MASS}</inertial>", x="0"), urdf, tmp_path).remarks == (fixed,)


@pytest.mark.parametrize("number", ["1e51", "-1e51", "nan", "1e999"])
def test_numbers_beyond_all_measure_are_refused(number: str, tmp_path: Path) -> None:
    with pytest.raises(FormatError, match=f"has '{number}' in 'xyz', which is not a finite number"):
        read(URDF.format(tip="", x=number), format_named("urdf"), tmp_path)
    read(URDF.format(tip="", x="1e50"), format_named("urdf"), tmp_path)


def test_a_body_beyond_all_measure_is_refused(tmp_path: Path) -> None:
    body = f"<origin xyz='1e25 0 0'/>{MASS.removeprefix('<inertial>')}".replace('"2"', '"1e20"')
    with pytest.raises(FormatError, match="'tip' has a number that is not finite"):
        read(URDF.format(tip=f"<inertial>{body}</inertial>", x="0"), format_named("urdf"), tmp_path)
