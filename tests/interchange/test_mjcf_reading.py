"""What MJCF can say and the language can hold, or cannot: read, told or refused in one sentence."""

import random
import re
from math import pi
from pathlib import Path

import mujoco
import numpy as np
import pytest
from tests.interchange.mujoco_agreement import gap
from tests.interchange.round_trips import mechanism_of, read
from tests.support.urdf_mutants import mutant

from kindsl.language.semantics.parameters import JointProperties
from kindsl.robots.interchange.format import AS_WRITTEN, FormatError, ReadRobot
from kindsl.robots.interchange.kindsl_writing import kindsl_text, written_kindsl
from kindsl.robots.interchange.mjcf.mjcf_reading import read_mjcf
from kindsl.robots.interchange.registry import format_named

BODY = '<inertial pos="0.1 0 0" mass="2" fullinertia="0.1 0.2 0.2 0.01 0 0"/>'
ARM = f"""<mujoco model="arm"><worldbody><body name="base">
<body name="upper" pos="0 0 1" euler="0 30 0">
<joint name="shoulder" axis="1 2 2" pos="0.1 0.2 0.3" ref="20"/>{BODY}
<site name="elbow" pos="0 1 0"/>
<body name="lower" pos="0 1 0"><joint name="slider" type="slide" axis="0 1 0"/>{BODY}
<body name="tool" pos="0 0 0.5" quat="1 1 0 0">{BODY}</body></body></body>
</body></worldbody></mujoco>"""


def robot(text: str, folder: Path) -> ReadRobot:
    return read(text, format_named("mjcf"), folder)


def test_anchors_references_axes_and_fixed_bodies_move_as_in_mujoco(tmp_path: Path) -> None:
    ours = mechanism_of(kindsl_text(robot(ARM, tmp_path).robot))
    spec = mujoco.MjSpec.from_string(ARM)
    for name in ("upper", "lower"):  # link frames are at the joints and turned to their axes
        spec.body(name).name = f"{name}_body"
    model = spec.compile()
    q = [0.3, -0.2]
    data = mujoco.MjData(model)
    data.qpos[:] = q
    mujoco.mj_forward(model, data)
    M = np.zeros((2, 2))
    mujoco.mj_fullM(model, data, M)
    np.testing.assert_allclose(ours.joint_space_inertia(q), M, atol=1e-12)
    np.testing.assert_allclose(ours.gravity_torque(q), data.qfrc_bias, atol=1e-12)
    poses = ours.forward_kinematics(q)
    np.testing.assert_allclose(poses["elbow"][:3, 3], data.site("elbow").xpos, atol=1e-12)
    np.testing.assert_allclose(poses["tool"][:3, 3], data.body("tool").xpos, atol=1e-12)
    np.testing.assert_allclose(poses["tool"][:3, :3].ravel(), data.body("tool").xmat, atol=1e-12)


def test_body_with_two_joints_becomes_two_links(tmp_path: Path) -> None:
    text = ARM.replace('pos="0.1 0.2 0.3" ref="20"/>', '/><joint name="twist" axis="0 1 0"/>')
    found = robot(text, tmp_path)
    assert [*found.robot.joint_names] == ["shoulder", "twist", "slider"]
    assert any("'upper' has 2 joints" in remark for remark in found.remarks)
    data = mujoco.MjData(model := mujoco.MjModel.from_xml_string(text))
    data.qpos[:] = [0.3, 0.5, -0.2]
    mujoco.mj_forward(model, data)
    ours = mechanism_of(kindsl_text(found.robot)).forward_kinematics([0.3, 0.5, -0.2])
    np.testing.assert_allclose(ours["tool"][:3, 3], data.body("tool").xpos, atol=1e-12)


def test_free_joint_is_a_floating_base(tmp_path: Path) -> None:
    text = ARM.replace('<body name="base">', f'<body name="base"><freejoint/>{BODY}')
    text = text.replace('pos="0.1 0.2 0.3" ref="20"', "")
    text = text.replace('<joint name="shoulder" axis="1 2 2"', '<joint name="shoulder"')
    text = text.replace(' axis="0 1 0"', "")
    found = robot(text, tmp_path)
    assert found.robot.is_floating
    names = ("tool",)
    spec = mujoco.MjSpec.from_string(text)
    for name in names:
        body = spec.body(name)
        body.parent.add_site(name=name, pos=body.pos, quat=body.quat)
    ours = mechanism_of(kindsl_text(found.robot))
    assert max(gap(ours, spec.compile(), np.random.default_rng(1))) < 1e-12


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("</mujoco>", "", "not a readable MJCF: .*"),
        ("mujoco", "robot", "not an MJCF: a URDF: use --from urdf"),
        ("mujoco", "sdf", "not an MJCF: its root element is not <mujoco>"),
        ('type="slide" axis="0 1 0"', 'type="ball"', "the joint 'slider' is a ball joint.*"),
        (
            'name="slider" type="slide" axis="0 1 0"',
            'type="ball"',
            "a joint of the body '.*' is a ball joint.*",
        ),
        ("<joint", "<jiont", "not a readable MJCF: .*"),
        (
            "</worldbody>",
            "</worldbody><equality><connect body1='upper' body2='tool' anchor='0 0 0'/></equality>",
            "the equality .connect of 'upper' and 'tool'. closes a kinematic loop.*",
        ),
        (
            "</worldbody>",
            f"<body name='b'><freejoint/>{BODY}</body></worldbody>",
            "the MJCF has 2 moving root bodies.*'b' and 'base'",
        ),
        (
            "</worldbody>",
            "</worldbody><deformable><flex name='cord' dim='1' body='upper tool' element='0 1'/>"
            "</deformable>",
            "the body 'cord' deforms .*",
        ),
        (BODY, "", "MuJoCo refuses the model: .*'upper'.*"),
    ],
)
def test_what_cannot_be_held_is_refused(old: str, new: str, message: str, tmp_path: Path) -> None:
    with pytest.raises(FormatError, match=f"^{message}$") as caught:
        written_kindsl(robot(ARM.replace(old, new), tmp_path))
    assert "\n" not in str(caught.value) and not str(caught.value).endswith(".")


def test_a_robot_that_cannot_move_is_read_but_no_document(tmp_path: Path) -> None:
    path = tmp_path / "still.xml"
    path.write_text(re.sub("<joint.*?/>", "", ARM))
    read = format_named("mjcf").read(path, AS_WRITTEN)
    assert read.robot.n_links == 0
    with pytest.raises(FormatError, match="no joint of the robot moves, and a document"):
        written_kindsl(read)


def test_number_that_is_none_is_refused_and_leaves_no_log(
    tmp_path: Path, capfd, monkeypatch
) -> None:
    monkeypatch.chdir(tmp_path)
    with pytest.raises(FormatError, match="'upper' has a number that is not finite"):
        robot(ARM.replace('pos="0.1 0.2 0.3"', 'pos="0.1 nan 0.3"'), tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == ["robot.xml"]
    assert capfd.readouterr() == ("", "")


@pytest.mark.parametrize("seed", range(60))
def test_mutant_is_read_or_refused(seed: int, tmp_path: Path, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    try:
        text = kindsl_text(robot(mutant(ARM, random.Random(seed)), tmp_path).robot)
    except FormatError as error:
        assert re.fullmatch(r"[^\n]+[^.\n]", str(error))
    else:
        assert "nan" not in text and "inf" not in text.replace("inertia", "")


LOSSY = ARM.replace(
    "<body name=\"upper\"", "<geom type='plane' size='1 1 1'/><body name=\"upper\""
).replace(
    '<site name="elbow"', "<geom type='mesh' mesh='absent'/><site name=\"elbow\""
).replace(
    'ref="20"', 'ref="20" armature="1" damping="1" range="-90 90" stiffness="2"'
).replace(
    "<worldbody>", "<asset><mesh name='absent' file='absent.stl'/></asset><worldbody>"
).replace(
    "</worldbody>",
    "</worldbody><actuator><motor joint='slider'/></actuator>"
    "<sensor><jointpos joint='slider'/></sensor>"
    "<equality><joint joint1='slider' joint2='shoulder'/></equality>",
)  # fmt: skip


def test_each_loss_is_one_sentence(tmp_path: Path) -> None:
    found = robot(LOSSY, tmp_path)
    assert [remark for remark in found.remarks if "dropped" in remark] == [
        "1 sensor dropped: not supported",
        "1 actuator dropped: not supported",
        "geometry and meshes of 2 bodies dropped",
        "the equality (joint of 'slider' and 'shoulder') dropped: the joints are now independent",
        "springs of 1 joint dropped: not supported",
    ]
    (told,) = found.joints.values()
    assert told == JointProperties(*told.limits, armature=1.0, damping=1.0)
    assert told.limits == pytest.approx((-pi / 2, pi / 2))
    plain = robot(ARM, tmp_path)
    assert kindsl_text(found.robot) == kindsl_text(plain.robot)


@pytest.mark.parametrize(
    ("mass", "moment", "is_kept"),
    [
        ("1", "2e-14", True),
        ("2e-14", "1", True),
        ("2e-14", "2e-14", False),
        ("4e-14", "4e-14", True),
    ],
)
def test_dust_is_left_out_and_a_point_is_not(
    mass: str, moment: str, is_kept: bool, tmp_path: Path
) -> None:
    dust = f'<inertial pos="0 0 0" mass="{mass}" diaginertia="{moment} {moment} {moment}"/>'
    found = robot(ARM.replace(f'quat="1 1 0 0">{BODY}', f'quat="1 1 0 0">{dust}'), tmp_path).robot
    (tool,) = [part for part in found.bodies[2].parts if part.name == "tool"]
    assert (tool.mass is not None) is is_kept


def test_what_a_program_places_for_the_hand_to_follow_is_no_part_of_the_robot(
    tmp_path: Path,
) -> None:
    text = (
        "<mujoco><worldbody><body name='upper'><joint axis='0 1 0'/><geom size='.1'/></body>"
        "<body name='goal' mocap='true'><geom size='.1'/></body></worldbody>"
        "<equality><weld body1='goal' body2='upper'/></equality></mujoco>"
    )
    read = robot(text, tmp_path)
    assert [body.name for body in read.robot.bodies[1:]] == ["upper"]
    assert "the mocap body 'goal' dropped: it is a target, no part of the robot" in read.remarks
    assert not any("weld" in remark for remark in read.remarks)


def test_what_is_held_to_the_world_is_held_to_no_target(tmp_path: Path) -> None:
    text = (
        "<mujoco><worldbody><body name='upper'><joint axis='0 1 0'/><geom size='.1'/></body>"
        "<body mocap='true'><geom size='.1'/></body></worldbody>"
        "<equality><weld body1='upper'/></equality></mujoco>"
    )
    with pytest.raises(FormatError, match="closes a kinematic loop"):
        written_kindsl(robot(text, tmp_path))


def test_a_robot_that_a_program_carries_about_is_kept(tmp_path: Path) -> None:
    text = (
        "<mujoco><worldbody><body name='mount' mocap='true'><geom size='.1'/>"
        "<body name='finger'><joint axis='0 1 0'/><geom size='.1'/></body></body>"
        "</worldbody></mujoco>"
    )
    read = robot(text, tmp_path)
    assert [body.name for body in read.robot.bodies] == ["mount", "finger"]
    assert not any("mocap" in remark for remark in read.remarks)


def test_an_equality_of_one_joint_names_it_alone(tmp_path: Path) -> None:
    text = LOSSY.replace(" joint2='shoulder'/></equality>", "/></equality>")
    (told,) = [remark for remark in robot(text, tmp_path).remarks if "equality" in remark]
    assert told.startswith("the equality (joint of 'slider') dropped")


def test_names_that_collide_are_told(tmp_path: Path) -> None:
    text = ARM.replace('"elbow"', '"tool"').replace('"slider"', '"lower"')
    found = robot(text, tmp_path)
    mechanism_of(kindsl_text(found.robot))
    told = written_kindsl(found).remarks
    assert any("joint 'lower' is now 'lower_joint'" in sentence for sentence in told)
    assert any("frame 'tool' is now 'tool_frame'" in sentence for sentence in told)


def test_a_name_that_is_not_utf_8_is_refused(tmp_path: Path) -> None:
    file = tmp_path / "arm.xml"
    file.write_bytes(ARM.encode().replace(b'"lower"', b'"l\xf6wer"'))
    with pytest.raises(FormatError, match="a name in it is not UTF-8"):
        read_mjcf(file, AS_WRITTEN)


def test_a_text_that_is_cut_off_is_told_with_its_line_alone(tmp_path: Path) -> None:
    path = tmp_path / "cut.xml"
    path.write_text('<mujoco>\n<worldbody>\n<body name="a"><joint na')
    with pytest.raises(FormatError, match=r"^not a readable MJCF: not well-formed XML at line 3: "):
        read_mjcf(path, AS_WRITTEN)


SOLID = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n"


@pytest.mark.parametrize(("suffix", "place"), [(".xml", "parts/"), (".XML", ""), (".mjcf", "")])
def test_files_that_it_names_are_found_from_where_it_is(
    suffix: str, place: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A suffix that MuJoCo does not know includes its neighbours only."""
    (tmp_path / "parts").mkdir()
    part = f"<mujoco><asset><mesh name='solid' file='{place}solid.obj'/></asset></mujoco>"
    (tmp_path / place / "solid.xml").write_text(part)
    (tmp_path / place / "solid.obj").write_text(SOLID)
    text = ARM.replace("<worldbody>", f"<include file='{place}solid.xml'/><worldbody>")
    text = text.replace(f'quat="1 1 0 0">{BODY}', "><geom type='mesh' mesh='solid' density='6'/>")
    path = tmp_path / f"arm{suffix}"
    path.write_text(text)
    monkeypatch.chdir("/")
    former = mujoco.get_mju_user_warning()
    parts = read_mjcf(path, AS_WRITTEN).robot.bodies[2].parts[1:]
    (tool,) = [part for part in parts if part.is_link]
    assert mujoco.get_mju_user_warning() is former
    assert tool.mass is not None and tool.mass.mass == pytest.approx(1.0)


@pytest.mark.parametrize(
    ("body", "more", "refused"),
    [
        ("lower", "", "the body 'lower' has its inertia by the mesh 'a.stl', which is missing"),
        ("base", "", None),
        ("lower", ' mass="0"', None),
    ],
)
def test_a_robot_without_a_mesh_that_it_weighs_by_is_only_shown(
    body: str, more: str, refused: str | None, tmp_path: Path
) -> None:
    asset = '<mujoco model="arm"><asset><mesh name="a" file="a.stl"/></asset>'
    text = ARM.replace('<mujoco model="arm">', asset)
    at = text.index(f'<body name="{body}"')
    own = text[at:].replace(BODY, "" if refused else BODY, 1)
    text = text[:at] + re.sub(r">", f'><geom type="mesh" mesh="a"{more}/>', own, count=1)
    found = robot(text, tmp_path)
    assert found.refused == ((refused,) if refused else ())
    assert found.unknown == ({body} if refused else set())
    assert found.robot.n_links == 2
