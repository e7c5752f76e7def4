"""What SDF can say and the language can hold, or cannot: read, told or refused in one sentence."""

import random
import re
from pathlib import Path

import numpy as np
import pytest
from tests.interchange.round_trips import mechanism_of, read
from tests.support.urdf_mutants import mutant

from kindsl.language.semantics.parameters import UNTOLD
from kindsl.robots.interchange.format import AS_WRITTEN, FormatError, ReadingChoices, ReadRobot
from kindsl.robots.interchange.kindsl_writing import kindsl_text, written_kindsl
from kindsl.robots.interchange.registry import format_named

MASS = "<inertial><pose>0.1 0 0 0 0 0</pose><mass>2</mass><inertia><ixx>0.1</ixx><iyy>0.2</iyy>"
MASS += "<izz>0.2</izz><ixy>0.01</ixy></inertia></inertial>"
ARM = f"""<sdf version="1.9"><model name="arm">
<joint name="weld" type="fixed"><parent>world</parent><child>base</child></joint>
<link name="base"/>
<link name="upper"><pose>0 0 1 0 0.5 0</pose>{MASS}</link>
<link name="lower"><pose relative_to="upper" degrees="true">1 0 0 0 0 90</pose>{MASS}</link>
<joint name="shoulder" type="revolute"><pose>0.1 0 0 0 0 0</pose><parent>base</parent>
<child>upper</child><axis><xyz expressed_in="__model__">0 1 0</xyz></axis></joint>
<joint name="slider" type="prismatic"><parent>upper</parent><child>lower</child>
<axis><xyz>0 0 -1</xyz></axis></joint>
<frame name="tool" attached_to="lower"><pose>0 0 1 0 0 0</pose></frame>
<frame name="mark"><pose relative_to="tool">1 0 0 0 0 0</pose></frame>
</model></sdf>"""


def robot(text: str, folder: Path) -> ReadRobot:
    return read(text, format_named("sdf"), folder)


def test_poses_follow_what_they_are_relative_to(tmp_path: Path) -> None:
    ours = mechanism_of(kindsl_text(robot(ARM, tmp_path).robot))
    assert not ours.bodies.is_floating
    at_zero = ours.forward_kinematics([0.0, 0.0])
    c, s = np.cos(0.5), np.sin(0.5)
    upper = np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])
    lower = np.array([0, 0, 1]) + upper @ [1, 0, 0]
    tool = lower + upper @ [0, 0, 1]
    np.testing.assert_allclose(at_zero["tool"][:3, 3], tool, atol=1e-12)
    np.testing.assert_allclose(at_zero["mark"][:3, 3], tool + upper @ [0, 1, 0], atol=1e-12)
    # The shoulder's axis is the model's y through a point 0.1 along the upper arm.
    moved = ours.forward_kinematics([-0.5, 0.2])
    anchor = np.array([0, 0, 1]) + upper @ [0.1, 0, 0]
    expected = anchor + np.array([0.9, 0.0, 1.0 - 0.2])
    np.testing.assert_allclose(moved["tool"][:3, 3], expected, atol=1e-12)


def test_a_limit_as_far_as_sdformat_s_default_is_none(tmp_path: Path) -> None:
    for lower, upper, told in (
        ("-1e16", "1e16", (None, None)),
        ("-9e15", "1e16", (-9e15, None)),
        ("-1e17", "9e15", (None, 9e15)),
        ("-inf", " Infinity ", (None, None)),
    ):
        limit = f"<limit><lower>{lower}</lower><upper>{upper}</upper></limit>"
        text = ARM.replace("<xyz>0 0 -1</xyz>", f"<xyz>0 0 -1</xyz>{limit}")
        found = robot(text, tmp_path).joints.get("slider", UNTOLD)
        assert found.limits == told


def test_without_a_joint_to_the_world_the_base_floats(tmp_path: Path) -> None:
    weld = ARM[ARM.index('<joint name="weld"') : ARM.index('<link name="base"')]
    found = robot(ARM.replace(weld, ""), tmp_path)
    assert found.robot.is_floating
    assert "the link 'base' has no inertia: SDFormat's default is 1 kg" in found.remarks
    assert found.robot.bodies[0].mass.mass == 1.0


@pytest.mark.parametrize(
    ("version", "is_in_model"),
    [("1.4", True), ("1.04", True), ("1.5", False), ("1.10", False), ("1.²", False), ("", False)],
)
def test_axes_are_in_the_model_before_version_1_5(
    version: str, is_in_model: bool, tmp_path: Path
) -> None:
    text = ARM.replace('"1.9"', f'"{version}"').replace(' expressed_in="__model__"', "")
    text = text.replace("<xyz>0 1 0<", "<xyz>1 0 0<")
    arm = mechanism_of(kindsl_text(robot(text, tmp_path).robot))
    axis = arm.forward_kinematics([0.0, 0.0])["upper"][:3, 2]
    # In the joint's frame it leans with the upper arm, whose frame turns with z along the axis.
    leaning = [np.cos(0.5), 0.0, -np.sin(0.5)]
    np.testing.assert_allclose(axis, [1.0, 0.0, 0.0] if is_in_model else leaning, atol=1e-12)


def test_world_is_the_base_of_what_turns_on_it(tmp_path: Path) -> None:
    text = ARM.replace('name="weld" type="fixed"', 'name="weld" type="revolute"')
    found = robot(text, tmp_path)
    assert [*found.robot.body_names] == ["world", "base", "upper", "lower"]


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("</sdf>", "", "not a readable SDF: not well-formed XML at line .*"),
        ("sdf", "robot", "not an SDF: its root element is <robot>, not <sdf>"),
        ('type="prismatic"', 'type="ball"', "line 8: <joint name='slider'> is a ball joint.*"),
        ('name="lower"', 'name="upper"', "line 5: <link name='upper'> has the name of .* line 4"),
        ("<parent>upper</parent>", "", "line 8: <joint name='slider'> has no <parent>"),
        ("<parent>upper<", "<parent>uper<", ".*names 'uper', .*; did you mean 'upper'."),
        ("<child>lower<", "<child>upper<", ".*gives link 'upper' a second parent.*'shoulder'"),
        ("<parent>base<", "<parent>lower<", ".*in a kinematic loop.*"),
        ('relative_to="upper"', 'relative_to="lower"', ".*relative to itself: lower -> lower"),
        ("<mass>2<", "<mass>two<", "line 4: <mass> has 'two', which is not a finite number"),
        ("0.1 0 0 0 0 0", "0.1 0", "line 6: <pose> has 2 numbers, not 6"),
        ("<xyz>0 0 -1<", "<xyz>0 0 0<", "line 9: <xyz> of joint 'slider' has no length"),
        ('<frame name="mark"', '<include/><frame name="mark"', ".*none of .*: add .* GZ_.*"),
        ("<inertial>", "<inertial auto='1'>", "line 4: <link name='upper'> .*its shape .auto.*"),
        ("<mass>2", "<origin/><mass>2", "line 4: <origin> is the pose of SDF before 1.2.*"),
        ("</model>", "</model><world><joint name='w'/></world>", ".*is a joint of the world.*"),
        ("<pose>0.1 0 0 0 0 0", "<pose relative_to='base'>0.1 0 0 0 0 0", ".*another frame.*"),
        ('"arm"', '"arm"><pose relative_to="x"/><frame name="y"/', ".*relative to 'x' of the.*"),
        (
            "<parent>world</parent><child>base",
            "<parent>lower</parent><child>base",
            "the joints of the SDF close a kinematic loop, which the language does not support",
        ),
        (
            "</model>",
            "</model><model name='b'><link name='l'/></model>",
            "line 12: the SDF has 2 models.*'arm' and 'b'",
        ),
        ("</model>", "<link name='b'/></model>", "line 12: .*2 root links.*the world and 'b'"),
    ],
)  # fmt: skip
def test_what_cannot_be_held_is_refused(old: str, new: str, message: str, tmp_path: Path) -> None:
    with pytest.raises(FormatError, match=f"^{message}$") as caught:
        written_kindsl(robot(ARM.replace(old, new), tmp_path))
    assert "\n" not in str(caught.value) and not str(caught.value).endswith(".")


@pytest.mark.parametrize("seed", range(100))
def test_mutant_is_read_or_refused(seed: int, tmp_path: Path) -> None:
    try:
        text = kindsl_text(robot(mutant(ARM, random.Random(seed)), tmp_path).robot)
    except FormatError as error:
        assert re.fullmatch(r"[^\n]+[^.\n]", str(error))
    else:
        assert "nan" not in text and "inf" not in text.replace("inertia", "")


def test_each_loss_is_one_sentence(tmp_path: Path) -> None:
    text = ARM.replace('<frame name="mark"', '<plugin/><frame name="mark"')
    text = text.replace(
        "<xyz>0 0 -1</xyz>", "<xyz>0 0 -1</xyz><dynamics><spring_stiffness/></dynamics>"
    )
    assert robot(text, tmp_path).remarks == (
        "springs of 1 joint dropped: not supported",
        "1 plugin dropped: not supported",
    )


def test_of_many_models_and_roots_five_are_named(tmp_path: Path) -> None:
    for part, message in (
        (
            "<model name='{}'><link name='l'/></model>",
            "line 12: the SDF has 7 models, .*: 'arm', 'a', 'b', 'c' and 'd'",
        ),
        ("<link name='{}'/>", "line 12: .*7 root links, .*: the world, 'a', 'b', 'c' and 'd'"),
    ):
        more = "".join(map(part.format, "abcdef"))
        text = ARM.replace("</model>", f"</model>{more}" if "model" in part else f"{more}</model>")
        with pytest.raises(FormatError, match=f"^{message}$"):
            written_kindsl(robot(text, tmp_path))


def test_roots_without_the_world_are_named(tmp_path: Path) -> None:
    text = ARM.replace("<parent>world</parent><child>base", "<parent>base</parent><child>lower")
    text = text.replace("<parent>upper</parent><child>lower", "<parent>upper</parent><child>b")
    message = "line 12: .* 2 root links, exactly one root link is required: 'base' and 'b0'"
    text = text.replace("</model>", "<link name='b'/><link name='b0'/></model>")
    with pytest.raises(FormatError, match=f"^{message}$"):
        written_kindsl(robot(text, tmp_path))


def test_model_without_links_is_refused_where_it_begins(tmp_path: Path) -> None:
    with pytest.raises(FormatError, match=r"^line 2: <model name='a'> has no link$"):
        robot("<sdf>\n<model name='a'/></sdf>", tmp_path)


def test_a_model_in_a_model_without_links_is_refused_where_it_begins(tmp_path: Path) -> None:
    text = ARM.replace("</model>", "\n<model name='tool'/></model>")
    line = text[: text.index("<model name='tool'")].count("\n") + 1
    with pytest.raises(FormatError, match=rf"^line {line}: <model name='tool'> has no link$"):
        robot(text, tmp_path)


FOREARM = f"""<sdf version="1.9"><model name="forearm" canonical_link="upper">
<pose>7 7 7 0 0 0</pose>
<frame name="middle"><pose relative_to="upper">0.5 0 0 0 0 0</pose></frame>
<link name="upper"><pose>0 0 0.75 0 0.5 0</pose>{MASS}</link>
<include><name>hand</name><uri>model://hand</uri>
<pose relative_to="upper">1 0 0 0 0 1.5707963267948966</pose></include>
<joint name="slider" type="prismatic"><parent>upper</parent><child>hand::lower</child>
<axis><xyz>0 0 -1</xyz><limit><lower>-1</lower><upper>2</upper></limit></axis></joint>
</model></sdf>"""
HAND = f"""<sdf version="1.9"><model name="any">
<link name="lower">{MASS}</link>
<frame name="tool" attached_to="lower"><pose>0 0 1 0 0 0</pose></frame>
</model></sdf>"""
NESTED = """<sdf version="1.9"><model name="arm">
<joint name="weld" type="fixed"><parent>world</parent><child>base</child></joint>
<link name="base"/>
<include><name>leg</name><uri>model://forearm/arm.sdf</uri><pose>0 0 0.25 0 0 0</pose></include>
<joint name="shoulder" type="revolute"><pose>0.1 0 0 0 0 0</pose><parent>base</parent>
<child>leg::upper</child><axis><xyz expressed_in="__model__">0 1 0</xyz></axis></joint>
<frame name="mark"><pose relative_to="leg::hand::tool">1 0 0 0 0 0</pose></frame>
</model></sdf>"""


def test_included_models_are_the_robot_that_they_make(tmp_path: Path) -> None:
    models = tmp_path / "models"
    for name, file, text in (("forearm", "arm.sdf", FOREARM), ("hand", "v2.sdf", HAND)):
        (models / name).mkdir(parents=True)
        (models / name / file).write_text(text)
    for name in ("old.sdf", "model.sdf"):
        (models / "hand" / name).write_text("<sdf/>")
    manifest = "<model><sdf version='1.6'>old.sdf</sdf><sdf version='1.9'>v2.sdf</sdf></model>"
    (models / "hand" / "model.config").write_text(manifest)
    path = tmp_path / "arm.sdf"
    path.write_text(NESTED)
    format = format_named("sdf")
    with pytest.raises(FormatError, match=r"^line 4: <include> names 'model://forearm/arm.sdf'"):
        format.read(path, AS_WRITTEN)
    found = format.read(path, ReadingChoices(model_paths=(models,)))
    ours, plain = (mechanism_of(kindsl_text(read.robot)) for read in (found, robot(ARM, tmp_path)))
    for q in ([0.0, 0.0], [0.4, -0.3]):
        poses, expected = ours.forward_kinematics(q), plain.forward_kinematics(q)
        for name, other in (("mark", "mark"), ("leg_hand_tool", "tool")):
            np.testing.assert_allclose(poses[name], expected[other], atol=1e-12)
        H, other_H = ours.joint_space_inertia(q), plain.joint_space_inertia(q)
        np.testing.assert_allclose(H, other_H, atol=1e-12)
    assert found.joints["leg::slider"].limits == (-1.0, 2.0)
    (models / "hand" / "model.config").unlink()
    (models / "hand" / "v2.sdf").rename(models / "hand" / "model.sdf")
    again = format.read(path, ReadingChoices(model_paths=(models,)))
    assert kindsl_text(again.robot) == kindsl_text(found.robot)


def test_a_model_that_includes_itself_is_refused(tmp_path: Path) -> None:
    text = ARM.replace("</model>", "<include><uri>robot.sdf</uri></include></model>")
    with pytest.raises(FormatError, match="is the 20th model in a model"):
        robot(text, tmp_path)
