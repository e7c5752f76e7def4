"""Whatever is in a URDF, it is read or refused with one sentence that says where."""

import random
import re
from pathlib import Path

import pytest
from tests.support.urdf_mutants import mutant

from kindsl.robots.interchange.format import FormatError
from kindsl.robots.interchange.kindsl_writing import written_kindsl
from kindsl.robots.interchange.urdf.urdf_reading import robot_of_urdf

LINK = '<link name="{}"><inertial><mass value="1.0"/><inertia ixx="0.1" iyy="0.1" izz="0.1"'
LINK += ' ixy="0" ixz="0" iyz="0"/></inertial></link>\n'
JOINT = '<joint name="{}" type="{}"><origin xyz="{}" rpy="0 0 0"/><parent link="{}"/>'
JOINT += '<child link="{}"/><axis xyz="{}"/></joint>\n'
LINKS = "".join(map(LINK.format, ("base", "arm", "hand")))
SHOULDER = JOINT.format("shoulder", "revolute", "0 0 1", "base", "arm", "0 0 1")
WRIST = JOINT.format("wrist", "fixed", "0 0 1", "arm", "hand", "0 0 1")
ARM = f"<robot name='arm'>\n{LINKS}{SHOULDER}{WRIST}</robot>"


def read(text: str, folder: Path) -> str:
    path = folder / "robot.urdf"
    path.write_text(text, encoding="utf-8")
    return written_kindsl(robot_of_urdf(path.read_bytes(), "robot")).text


@pytest.mark.parametrize(
    ("old", "new"),
    [
        (SHOULDER, SHOULDER.replace('<axis xyz="0 0 1"/>', "<axis/>")),
        (WRIST, WRIST.replace('<axis xyz="0 0 1"', '<axis xyz="none"')),
    ],
)
def test_an_axis_that_is_not_needed_need_not_be_one(old: str, new: str, tmp_path: Path) -> None:
    assert "link arm {" in read(ARM.replace(old, new), tmp_path)


def test_plain_robot_is_read(tmp_path: Path) -> None:
    assert "link arm {" in read(ARM, tmp_path)


def test_another_kind_of_file_is_told(tmp_path: Path) -> None:
    with pytest.raises(FormatError, match=r"^not a URDF: its root element is <model>"):
        read(ARM.replace("robot", "model"), tmp_path)


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ('"arm"/><child link="hand"', '"hand"/><child link="hand"', "line 6: .*loop: hand -> hand"),
        (
            '<parent link="base"/><child link="arm"',
            '<parent link="hand"/><child link="arm"',
            "line 6: <joint name='wrist'> closes a loop: hand -> arm -> hand$",
        ),
        ('<child link="hand"', '<child link="arm"', "line 6: .*'arm' a second parent.*'shoulder'"),
        ('"hand"><inertial', '"arm"><inertial', "line 4: .*has the name of the link in line 3"),
        ('xyz="0 0 1"', 'xyz="1 2"', "line 5: <origin> has 2 numbers in 'xyz', not 3"),
        ('xyz="0 0 1"', 'xyz="1 2 3 4 5"', "has 5 numbers"),
        ('xyz="0 0 1"', 'xyz="1 nan 3"', "has 'nan' in 'xyz', which is not a finite number"),
        ('mass value="1.0"', 'mass value="inf"', "line 2: .*'inf'"),
        ('<axis xyz="0 0 1"', '<axis xyz="0 0 0"', "of joint 'shoulder' has no length"),
        ("</robot>", "", "not well-formed XML at line"),
        ('type="revolute"', 'type="revolut"', "did you mean 'revolute'"),
        ('<child link="hand"/>', "", "has no <child>"),
        ('<parent link="arm"', '<parent link="arn"', "does not exist; did you mean 'arm'"),
        (WRIST, "", "has 2 root links"),
        (' izz="0.1"', "", "<inertia> has no attribute 'izz'"),
        (' iyy="0.1" izz="0.1"', "", "<inertia> has no attributes 'iyy' and 'izz'$"),
        ('"hand"><inertial', '" "><inertial', "^line 4: <link name=' '> has an empty name$"),
        ('<mass value="1.0"/>', "", "^line 2: <inertial> of link 'base' has no <mass>$"),
        ('izz="0.1"', 'izz="1 2"', "^line 2: <inertia> has 2 numbers in 'izz', not 1$"),
        (' type="revolute"', "", "^line 5: <joint name='shoulder'> has no attribute 'type'$"),
        ('<parent link="arm"', "<parent ", "^line 6: <parent> has no attribute 'link'$"),
        (
            '<child link="hand"/>',
            '<child link="hand"/><child link="base"/>',
            "^line 6: <joint name='wrist'> has 2 <child>, and needs one$",
        ),
        (
            'rpy="0 0 0"',
            'rpy="0 0 0" quat_xyzw="0 0 0 1"',
            "^line 5: <origin> has both 'rpy' and 'quat_xyzw'$",
        ),
        ('rpy="0 0 0"', 'quat_xyzw="0 0 0 0"', "^line 5: <origin> has a quaternion of no length$"),
        ('rpy="0 0 0"', 'rpy="0 0"', "^line 5: <origin> has 2 numbers in 'rpy', not 3$"),
        ('<axis xyz="0 0 1"', '<axis xyz="0 1"', "^line 5: <axis> has 2 numbers in 'xyz', not 3$"),
        (
            "</robot>",
            "<link name='a'/><link name='b'/><link name='c'/><link name='d'/></robot>",
            "line 7: the URDF has 5 root links, .*: 'base', 'a', 'b', 'c', 'd'$",
        ),
        (
            "</robot>",
            "".join(f"<link name='{name}'/>" for name in "abcde") + "</robot>",
            "line 7: the URDF has 6 root links, .*: 'base', 'a', 'b', 'c', 'd', ...$",
        ),
        (ARM[ARM.index("<link") : -8], "", "^the URDF has no link$"),
    ],
)
def test_defect_is_told_with_its_line(old: str, new: str, message: str, tmp_path: Path) -> None:
    with pytest.raises(FormatError, match=message) as caught:
        read(ARM.replace(old, new, 1), tmp_path)
    assert "\n" not in str(caught.value)


def test_prefix_that_nobody_declared_does_no_harm(tmp_path: Path) -> None:
    assert "link arm" in read(ARM.replace("</robot>", "<sensor:camera/></robot>"), tmp_path)


@pytest.mark.parametrize("seed", range(200))
def test_mutant_is_read_or_refused(seed: int, tmp_path: Path) -> None:
    text = mutant(ARM, random.Random(seed))
    try:
        document = read(text, tmp_path)
    except FormatError as error:
        assert re.fullmatch(r"[^\n]+", str(error))
    else:
        assert "nan" not in document and "inf" not in document.replace("inertia", "")
