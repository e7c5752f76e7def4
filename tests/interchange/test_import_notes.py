"""What makes a robot move otherwise than in the other format is told, one sentence each."""

from pathlib import Path

import pytest
from tests.interchange.round_trips import read

import kindsl
from kindsl.robots.interchange.format import FormatError
from kindsl.robots.interchange.kindsl_writing import written_kindsl
from kindsl.robots.interchange.registry import format_named
from kindsl.robots.interchange.urdf.urdf_reading import robot_of_urdf

MJCF = """<mujoco model="m"><option/><worldbody><body name="torso"><!---->
<inertial pos="0 0 0" mass="2" diaginertia="0.1 0.2 0.2"/>
<body name="arm" pos="0 0 1"><joint name="j"/>
<inertial pos="0.1 0 0" mass="2" diaginertia="0.1 0.2 0.2"/></body></body></worldbody></mujoco>"""
MASS = "<inertial><mass>2</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia></inertial>"
SDF = f"""<sdf version="1.9"><world name="w"><gravity>0 0 -9.81</gravity><model name="m">
<joint name="weld" type="fixed"><parent>world</parent><child>torso</child></joint>
<link name="torso">{MASS}</link><link name="arm">{MASS}</link>
<joint name="j" type="revolute"><parent>torso</parent><child>arm</child></joint>
</model></world></sdf>"""
INERTIA = '<inertial><mass value="2"/>'
INERTIA += '<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'
URDF = f"""<robot name="m"><link name="torso">{INERTIA}</link><link name="arm">{INERTIA}</link>
<joint name="j" type="continuous"><parent link="torso"/><child link="arm"/></joint></robot>"""
FLOATING = URDF.replace("</robot>", '<link name="world"/><joint name="free" type="floating">')
FLOATING += '<parent link="world"/><child link="torso"/></joint></robot>'
GRAVITY = "gravity ({}) m/s² dropped: kindsl computes with (0, 0, -9.81) unless given --gravity={}"
WORLDS = "the frame of the fixed base 'torso' is now the world's"
NOT_SUPPORTED = "{} dropped: not supported"
FLUID = NOT_SUPPORTED.format("forces of the fluid around the bodies")
SITES = '<site name="tool"/><site name="tip" pos="0 0 1"/></body></body></worldbody>'
WELD = SDF[SDF.index("<joint") : SDF.index("<link")]
WEIGHTLESS = "gravity, which 1 link did without, acts on all links"
STATIC = "the model is static: its joints can move here"
UNMOVED = "the link 'world', which does not move, dropped"
TURNED = FLOATING.replace(
    '"torso"/></joint></robot>', '"torso"/><origin rpy="1 0 0"/></joint></robot>'
)
GROUND = '<model name="ground"><static>true</static><link name="plane"/></model>'
INITIAL = "the initial orientation of the floating base 'torso' dropped"


def test_a_frame_that_is_its_links_is_left_out(tmp_path: Path) -> None:
    text = MJCF.replace("</body></body></worldbody>", SITES)
    written = written_kindsl(read(text, format_named("mjcf"), tmp_path))
    assert written.remarks == ("the frame 'tool' left out: it is that of link 'arm' itself",)
    assert [str(frame.name) for frame in kindsl.parse(written.text).model.frames] == ["tip"]


def notes(text: str, format: str, folder: Path) -> tuple[str, ...]:
    return read(text, format_named(format), folder).remarks


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("<option/>", '<option gravity="0 0 -9.81"/>', []),
        (
            "<option/>",
            '<option gravity="0.5 0 -3.71"/>',
            [GRAVITY.format("0.5, 0, -3.71", "0.5,0,-3.71")],
        ),
        (
            "<option/>",
            '<option><flag gravity="disable"/></option>',
            [GRAVITY.format("0, 0, 0", "0,0,0")],
        ),
        ("<option/>", '<option density="1.2"/>', [FLUID]),
        ("<option/>", '<option viscosity="1.2"/>', [FLUID]),
        ('"arm"', '"arm" gravcomp="1"', [NOT_SUPPORTED.format("gravity compensation of 1 body")]),
        ('"torso"', '"torso" pos="0 0 0" quat="1 0 0 0"', []),
        ('"torso"', '"torso" pos="0 0 1"', [WORLDS]),
        ('"torso"', '"torso" quat="1 1 0 0"', [WORLDS]),
        ("<!---->", "<freejoint/>", []),
        ('"torso"><!---->', '"torso" pos="0 0 1"><freejoint/>', []),
        ('"torso"><!---->', '"torso" quat="1 1 0 0"><freejoint/>', [INITIAL]),
        (
            '"torso"><!---->',
            '"torso"><joint type="free" armature="1" damping="2"/>',
            [
                NOT_SUPPORTED.format("damping of the floating base"),
                NOT_SUPPORTED.format("armature of the floating base"),
            ],
        ),
        ('name="j"', 'name="j" frictionloss="1"', []),
        ('name="j"', 'name="j" stiffness="1"', [NOT_SUPPORTED.format("springs of 1 joint")]),
    ],
)
def test_what_an_mjcf_says_of_mechanics(old, new, told, tmp_path: Path) -> None:
    assert old in MJCF
    assert list(notes(MJCF.replace(old, new), "mjcf", tmp_path)) == told


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("<gravity>0 0 -9.81</gravity>", "", []),
        ("0 0 -9.81", "0 0 -9.8", [GRAVITY.format("0, 0, -9.8", "0,0,-9.8")]),
        ("<gravity>", "<include/><gravity>", ["1 included model dropped: not read"]),
        ("<gravity>", f"{GROUND}<gravity>", ["the static model 'ground' dropped"]),
        ('<model name="m">', '<model name="m"><pose>0 0 0 0 0 0</pose>', []),
        ('<model name="m">', '<model name="m"><pose>0 0 1 0 0 0</pose>', [WORLDS]),
        ('<link name="torso">', '<link name="torso"><pose>0 0 0 1 0 0</pose>', [WORLDS]),
        (WELD, "<pose>0 0 2 0 0 0</pose>", []),
        (WELD, "<pose>0 0 2 1 0 0</pose>", [INITIAL]),
        ('<model name="m">', '<model name="m"><static>1</static>', [STATIC]),
        ('<link name="arm">', '<link name="arm"><gravity>false</gravity>', [WEIGHTLESS]),
        (
            '<link name="arm"><inertial>',
            '<link name="arm"><inertial><fluid_added_mass/>',
            [NOT_SUPPORTED.format("added mass of the fluid around 1 link")],
        ),
    ],
)
def test_what_an_sdf_says_of_mechanics(old, new, told, tmp_path: Path) -> None:
    assert old in SDF
    assert list(notes(SDF.replace(old, new), "sdf", tmp_path)) == told


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (URDF, []),
        (
            URDF.replace("</robot>", "<gazebo/><gazebo/></robot>"),
            [NOT_SUPPORTED.format("2 Gazebo extensions")],
        ),
        (
            URDF.replace("</robot>", "<transmission/></robot>"),
            [NOT_SUPPORTED.format("1 transmission")],
        ),
        (
            URDF.replace(INERTIA, f"{INERTIA}<visual/>", 1).replace(
                "</link>\n", "<collision/></link>\n"
            ),
            ["visuals and collisions of 2 links dropped"],
        ),
        (FLOATING, [UNMOVED]),
        (TURNED, [UNMOVED, INITIAL]),
    ],
)
def test_what_a_urdf_says_of_mechanics(text, told, tmp_path: Path) -> None:
    assert list(notes(text, "urdf", tmp_path)) == told


WORLD = """<robot name="r"><link name="arm"/><joint name="turn" type="continuous">
<parent link="{}"/><child link="arm"/><axis xyz="0 0 1"/></joint></robot>"""


def test_world_needs_no_link_of_its_own_as_in_drake() -> None:
    read = robot_of_urdf(WORLD.format("world"), "r")
    assert [body.name for body in read.robot.bodies] == ["world", "arm"]
    assert read.tells_base and not read.robot.is_floating
    with pytest.raises(FormatError, match="names a link 'wrld' that does not exist"):
        robot_of_urdf(WORLD.format("wrld"), "r")
