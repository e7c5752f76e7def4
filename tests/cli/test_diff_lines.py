"""Lines of joint poses in other formats, whatever form these write them in."""

import re
from pathlib import Path

import pytest
from tests.cli.conftest import Runner

ARM = """Robot arm {
RobotBase base {
    children { upper via shoulder }
}
link upper {
    id = 1
    inertia_params {
        mass = 1.3  CoM = (0.1, 0.0, 0.02)
        Ix = 0.01  Iy = 0.04  Iz = 0.04  Ixy = 0.0  Ixz = 0.002  Iyz = 0.0
    }
    children { lower via elbow }
}
link lower {
    id = 2
    inertia_params {
        mass = 0.8  CoM = (0.2, 0.01, 0.0)
        Ix = 0.005  Iy = 0.05  Iz = 0.05  Ixy = 0.001  Ixz = 0.0  Iyz = 0.0
    }
    children {}
}
r_joint shoulder {
    ref_frame { translation = (0.0, 0.0, 0.3)  rotation = (PI/2.0, 0.0, 0.0) }
}
r_joint elbow {
    ref_frame { translation = (0.35, 0.0, 0.1)  rotation = (0.0, 0.0, 0.0) }
}
}
"""
MJCF = """<mujoco model="arm">
  <compiler angle="radian" balanceinertia="false"/>
  <worldbody>
    <body name="base">
      <body name="upper"
            pos="0 0 0.3"
            euler="1.5707963267948966 0 0">
        <inertial pos="0.1 0 0.02" mass="1.3"
                  fullinertia="0.00948 0.02648 0.027 0 0.0006 0"/>
        <joint name="shoulder" axis="0 0 1"/>
        <body name="lower" {lower}>
          <inertial pos="0.2 0.01 0" mass="0.8" fullinertia="0.00492 0.018 0.01792 0.0006 0 0"/>
          <joint name="elbow"
                 {elbow}/>
        </body>
      </body>
    </body>
  </worldbody>
</mujoco>
"""
SDF = """<sdf version="1.9">
  <model name="arm">
    <link name="base"/>
    <joint name="world_fixed" type="fixed"><parent>world</parent><child>base</child></joint>
    <link name="upper">
      <pose>0 0 0.3 1.5707963267948966 0 0</pose>
      <inertial>
        <pose>0.1 0 0.02 0 0 0</pose>
        <mass>1.3</mass>
        <inertia>
          <ixx>0.00948</ixx><ixy>0</ixy><ixz>0.0006</ixz>
          <iyy>0.02648</iyy><iyz>0</iyz><izz>0.027</izz>
        </inertia>
      </inertial>
    </link>
    <joint name="shoulder" type="revolute">
      <parent>base</parent><child>upper</child>
      <axis><xyz>0 0 1</xyz></axis>
    </joint>
    <link name="lower">
      {lower}
      <inertial>
        <pose>0.2 0.01 0 0 0 0</pose>
        <mass>0.8</mass>
        <inertia>
          <ixx>0.00492</ixx><ixy>0.0006</ixy><ixz>0</ixz>
          <iyy>0.018</iyy><iyz>0</iyz><izz>0.01792</izz>
        </inertia>
      </inertial>
    </link>
    <joint name="elbow" type="revolute">
      <parent>upper</parent><child>lower</child>
      {elbow}
    </joint>
  </model>
</sdf>
"""
_ELBOW = "<axis><xyz>0 0 1</xyz></axis>"
_EXPRESSED = '<axis>\n        <xyz expressed_in="elbow">0 0 1</xyz></axis>'
_OF_JOINT = '<pose relative_to="elbow"/>'
_IN_DEGREES = "<pose relative_to='upper' degrees='true'>0.35 0 0.1 0 0 0</pose>"
_QUATERNION = '<pose rotation_format="quat_xyzw" relative_to="upper">0.35 0 0.1 0 0 0 1</pose>'


@pytest.mark.parametrize(
    ("file", "lower", "elbow", "change"),
    [
        ("a.xml", 'pos="0.35 0 0.1"', 'axis="0 0 1"', ("0.35 0 0.1", "0.36 0 0.1")),
        ("a.xml", '\n pos="0.35 0 0.1"\n quat="1 0 0 0"', "", ("1 0 0 0", "1 0.1 0 0")),
        ("a.xml", 'pos="0.35 0 0.1"', 'axis="0 0 1.0"', ("0 0 1.0", "0 0.1 1.0")),
        ("a.xml", 'pos="0.35 0 0.1" euler="0 0 0"', "", ('euler="0 0', 'euler="0.1 0')),
        ("a.sdf", "<pose relative_to='upper'>0.35 0 0.1 0 0 0</pose>", _ELBOW, ("0.35", "0.36")),
        ("a.sdf", "<pose>0.35 -0.1 0.3 1.5707963267948966 0 0</pose>", _ELBOW, ("0.35", "0.36")),
        ("a.sdf", _IN_DEGREES, _ELBOW, ("e'>0.35 0 0.1 0", "e'>0.35 0 0.1 5")),
        ("a.sdf", _OF_JOINT, _QUATERNION + _ELBOW, ("0.35", "0.36")),
        ("a.sdf", _OF_JOINT, _QUATERNION + _ELBOW, ("0 0 0 1", "0.1 0 0 1")),
        ("a.sdf", "<pose relative_to='upper'>0.35 0 0.1 0 0 0</pose>", _EXPRESSED,
         ('expressed_in="elbow">0 0', 'expressed_in="elbow">0.1 0')),
    ],
)  # fmt: skip
def test_the_line_of_a_joint_pose_is_named(
    kindsl: Runner, folder: Path, file: str, lower: str, elbow: str, change: tuple[str, str]
) -> None:
    if file.endswith("xml"):
        pytest.importorskip("mujoco")
    (folder / "arm.kindsl").write_text(ARM)
    text = (MJCF if file.endswith("xml") else SDF).format(lower=lower, elbow=elbow)
    (folder / file).write_text(text)
    run = kindsl("diff", "arm.kindsl", file)
    assert run.status == 0, run.out
    old, new = change
    at = text.index(old)
    (folder / file).write_text(text[:at] + new + text[at + len(old) :])
    run = kindsl("diff", "arm.kindsl", file)
    line = text.count("\n", 0, at) + 1
    assert run.status == 1
    assert f" {file} (line {line})" in run.out.splitlines()[1], run.out
    assert "of joint 'elbow'" in run.out.splitlines()[1]


@pytest.mark.parametrize(
    ("file", "old", "new"),
    [
        ("arm.urdf", 'xyz="0.0 0.0 1.0"', 'xyz="0.0 0.05 1.0"'),
        ("arm.xml", 'axis="0 0 1"', 'axis="0.05 0 -1"'),
        ("arm.sdf", "<xyz>0 0 1</xyz>", "<xyz>0 0.05 1</xyz>"),
    ],
)
@pytest.mark.parametrize("number", [0, 1])
def test_an_axis_that_is_turned_is_one_difference(
    kindsl: Runner, folder: Path, file: str, old: str, new: str, number: int
) -> None:
    if file.endswith("xml"):
        pytest.importorskip("mujoco")
    (folder / "arm.kindsl").write_text(ARM)
    _add_frames(folder / "arm.kindsl")
    assert kindsl("convert", "-q", "arm.kindsl", file).status == 0
    text = Path(file).read_text()
    at = text.index(old, text.index(old) + 1 if number else 0)
    Path(file).write_text(text[:at] + new + text[at + len(old) :])
    line, joint = text.count("\n", 0, at) + 1, ("shoulder", "elbow")[number]
    for sides in (("arm.kindsl", file), (file, "arm.kindsl")):
        run = kindsl("diff", *sides)
        assert run.status == 1
        told = run.out.splitlines()
        assert told[0] == "the mechanics differ"
        assert told[1].startswith(f"  axes of joint '{joint}' in {sides[0]} (line ")
        assert f" {file} (line {line})" in told[1]
        assert " are 0.04996 rad apart [" in told[1]
        assert not any(each.startswith("  ") for each in told[2:])


@pytest.mark.parametrize("file", ["arm.urdf", "arm.xml", "arm.sdf"])
def test_the_line_of_a_frame_is_named(kindsl: Runner, folder: Path, file: str) -> None:
    if file.endswith("xml"):
        pytest.importorskip("mujoco")
    (folder / "arm.kindsl").write_text(ARM)
    _add_frames(folder / "arm.kindsl")
    assert kindsl("convert", "-q", "arm.kindsl", file).status == 0
    text = Path(file).read_text()
    at = text.rindex("0.1 0.2 0.3")
    Path(file).write_text(f"{text[:at]}0.1 0.2 0.4{text[at + 11 :]}")
    run = kindsl("diff", "arm.kindsl", file)
    line = text.count("\n", 0, at) + 1
    assert run.status == 1
    told = rf" is 0\.3 m in arm\.kindsl \(line \d+\) and 0\.4 m in {file} \(line {line}\)"
    assert re.search(told, run.out)
    run = kindsl("diff", file, "arm.kindsl")
    assert f"is 0.4 m in {file} (line {line}) and 0.3 m in arm.kindsl" in run.out


def _add_frames(document: Path) -> None:
    """Add a frame to each link."""
    pose = "translation = (0.1, 0.2, 0.3)  rotation = (0.3, 0.2, 0.1)"
    first, *links = document.read_text().split("    children {")
    framed = (
        link.replace("}", f"}}\n    frames {{ tip{k} {{ {pose} }} }}", 1)
        for k, link in enumerate(links)
    )
    document.write_text("    children {".join((first, *framed)))
