"""Every format: what is written is read again as the same robot; MuJoCo has our numbers."""

import re
from pathlib import Path

import mujoco
import numpy as np
import pinocchio
import pytest
from lxml import etree
from tests.interchange.mujoco_agreement import gap
from tests.interchange.random_robots import random_robot
from tests.interchange.round_trips import gaps, mechanism_of, read, written, written_and_read
from tests.support.published import published_models

import kindsl
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.semantics.parameters import JointProperties
from kindsl.robots.interchange.descriptions import read_description
from kindsl.robots.interchange.format import ORDINARY, Format, FormatError, WritingChoices, repaired
from kindsl.robots.interchange.kindsl_writing import kindsl_text
from kindsl.robots.interchange.registry import all_formats, format_named, format_of_suffix
from kindsl.robots.interchange.syntaxes import other_format
from kindsl.robots.mechanism.errors import ModelError, UnboundParameterError

TOLERANCE = 1e-9
BOTH_WAYS = [format for format in all_formats() if format.read and format.write]


@pytest.mark.parametrize(
    ("name", "told"), [("a.step", "the suffix '.step'"), ("a", "a name without a suffix")]
)
def test_a_name_that_tells_no_format_is_said(tmp_path: Path, name: str, told: str) -> None:
    (tmp_path / name).touch()
    message = f"^{re.escape(told)} does not determine the format: use .*\\.urdf"
    with pytest.raises(FormatError, match=message):
        read_description(tmp_path / name, name, None)


def test_formats_are_found_with_their_suffixes() -> None:
    assert [format.name for format in all_formats()] == ["mjcf", "sdf", "urdf", "xacro"]
    assert format_of_suffix(".XML") is format_named("mjcf")
    assert format_of_suffix(".step") is None


@pytest.mark.parametrize("format", BOTH_WAYS, ids=lambda format: format.name)
@pytest.mark.parametrize("seed", range(5))
def test_round_trip_keeps_the_mechanics(format: Format, seed: int, tmp_path: Path) -> None:
    before = mechanism_of(kindsl_text(random_robot(seed)))
    if format.name == "urdf" and before.bodies.is_floating:
        pytest.skip("a URDF's root link does not say that it floats")
    after = written_and_read(before, format, tmp_path)
    assert max(gaps(before, after, np.random.default_rng(seed))) < TOLERANCE


def test_a_point_of_mass_is_written_as_one() -> None:
    """What arithmetic leaves of moments about the CoM would be told as those of no body."""
    tip = "mass = 2.646e-3 CoM = (0.0, 5.204081632653062e-4, 8.801020408163265e-3)"
    y, z = 5.204081632653062e-4, 8.801020408163265e-3
    moments = (2.646e-3 * (y * y + z * z), 2.646e-3 * z * z * (1.0 + 1e-14), 2.646e-3 * y * y)
    given = " ".join(f"I{i} = {m!r}" for i, m in zip("xyz", moments, strict=True))
    point = f"{tip} {given} Ixy = 0.0 Ixz = 0.0 Iyz = {2.646e-3 * y * z!r}"
    text = MASSLESS.replace("link b { id = 2", f"link b {{ id = 2 inertia_params {{ {point} }}")
    ours = kindsl.parse(text, Settings()).mechanism()
    for format in (format_named("urdf"), format_named("sdf")):
        tensor = etree.fromstring(written(ours, format).encode()).find(
            ".//link[@name='b']//inertia"
        )
        numbers = [*tensor.values(), *(each.text for each in tensor)]
        assert [float(number) for number in numbers] == [0.0] * 6


@pytest.mark.parametrize("seed", range(5))
def test_mujoco_has_our_numbers(seed: int) -> None:
    ours = mechanism_of(kindsl_text(random_robot(seed)))
    model = mujoco.MjModel.from_xml_string(written(ours, format_named("mjcf")))
    assert max(gap(ours, model, np.random.default_rng(seed))) < TOLERANCE


MASSLESS = """Robot arm {
RobotBase base { children { a via ja } }
link a { id = 1 children { b via jb } }
link b { id = 2 children { c via jc } }
link c { id = 3 inertia_params { mass = 2.0 CoM = (0.1, 0.2, 0.3)
  Ix = 1.0 Iy = 1.1 Iz = 1.2 Ixy = 0.1 Ixz = 0.0 Iyz = 0.0 } children {} }
r_joint ja { ref_frame { translation = (0.1, 0.2, 0.3) rotation = (0.4, 0.5, 0.6) } }
p_joint jb { ref_frame { translation = (0.5, 0.0, 0.3) rotation = (PI/2.0, 0.0, 0.3) } }
r_joint jc { ref_frame { translation = (0.0, 0.7, 0.1) rotation = (0.0, 0.2, 0.9) } }
}"""


def test_links_without_mass_move_in_mujoco(tmp_path: Path) -> None:
    ours, mjcf = kindsl.parse(MASSLESS, Settings()).mechanism(), format_named("mjcf")
    found = mjcf.write("arm", ours.linkage, WritingChoices())
    assert [remark.split("'")[1] for remark in found.remarks] == ["a", "b"]
    model = mujoco.MjModel.from_xml_string(found.text)
    data, q, qd = mujoco.MjData(model), [0.3, -0.4, 0.5], [0.7, 0.2, -0.3]
    data.qpos[:], data.qvel[:] = q, qd
    mujoco.mj_forward(model, data)
    M = np.zeros((3, 3))
    mujoco.mj_fullM(model, data, M)
    np.testing.assert_allclose(M, ours.joint_space_inertia(q), atol=1e-12)
    np.testing.assert_allclose(data.qfrc_bias, ours.bias_torque(q, qd), atol=1e-12)
    for name, pose in ours.forward_kinematics(q).items():
        np.testing.assert_allclose(data.body(name).xpos, pose[:3, 3], atol=1e-12)
    again = read(found.text, mjcf, tmp_path).robot
    assert [body.mass is None for body in again.bodies] == [True, True, True, False]
    back = mechanism_of(kindsl_text(again))
    np.testing.assert_allclose(back.joint_space_inertia(q), M, atol=1e-12)


def test_a_plate_whose_digits_break_the_triangle_inequality_is_written() -> None:
    text = MASSLESS.replace(
        "Ix = 1.0 Iy = 1.1 Iz = 1.2 Ixy = 0.1", "Ix = 0.1 Iy = 0.2 Iz = 0.3 Ixy = 0.0"
    )
    plate = text.replace("CoM = (0.1, 0.2, 0.3)", "CoM = (0.0, 0.0, 0.0)")
    assert "fullinertia" in written(
        kindsl.parse(plate, Settings()).mechanism(), format_named("mjcf")
    )


def test_an_impossible_body_is_written_and_told_or_repaired() -> None:
    text = MASSLESS.replace(
        "Ix = 1.0 Iy = 1.1 Iz = 1.2 Ixy = 0.1", "Ix = 0.1 Iy = 0.2 Iz = 0.4 Ixy = 0.0"
    )
    document = kindsl.parse(text.replace("CoM = (0.1, 0.2, 0.3)", "CoM = (0.0, 0.0, 0.0)"))
    skeleton, mjcf = document.skeleton(), format_named("mjcf")
    found = mjcf.write("arm", skeleton, ORDINARY)
    assert found.remarks[-1] == (
        "inertia of 'c' is physically impossible: MuJoCo refuses the file; "
        "--repair-inertia writes the nearest possible one"
    )
    with pytest.raises(ValueError, match="inertia"):
        mujoco.MjModel.from_xml_string(found.text)
    possible, notes = repaired(skeleton)
    assert notes == ("inertia of 'c' is impossible: the nearest possible one written",)
    model = mujoco.MjModel.from_xml_string(mjcf.write("arm", possible, ORDINARY).text)
    moments = sorted(model.body("c").inertia)
    np.testing.assert_allclose(moments, [0.15, 0.25, 0.4], atol=1e-9)
    assert repaired(possible) == (possible, ())


@pytest.mark.parametrize("path", published_models())
def test_published_documents_have_our_numbers_in_mujoco(path: Path) -> None:
    try:
        ours = kindsl.load(path, Settings()).mechanism()
    except (ModelError, UnboundParameterError) as error:
        assert re.search("same id|no value", str(error))
        return
    found = format_named("mjcf").write("robot", ours.linkage, ORDINARY)
    text = found.text
    if any("MuJoCo refuses the file" in remark for remark in found.remarks):
        with pytest.raises(ValueError, match=r"inertia|mass"):
            mujoco.MjModel.from_xml_string(text)
        return
    assert (
        max(gap(ours, mujoco.MjModel.from_xml_string(text), np.random.default_rng(1))) < TOLERANCE
    )


def test_revolute_joints_of_a_urdf_have_one_coordinate_unless_asked() -> None:
    urdf, ours = format_named("urdf"), mechanism_of(kindsl_text(random_robot(3)))
    plain = pinocchio.buildModelFromXML(written(ours, urdf))
    assert plain.nq == plain.nv == ours.n_joints
    skeleton = ours.linkage
    endless = urdf.write("robot", skeleton, WritingChoices(endless_joints=True)).text
    n_turning = ours.bodies.joint_kinds.count("revolute")
    assert n_turning and pinocchio.buildModelFromXML(endless).nq == ours.n_joints + n_turning


def test_limits_of_the_configuration_are_written_everywhere() -> None:
    limits = {
        "ja": JointProperties(-1.0, 1.5),
        "jb": JointProperties(-0.5),
        "other": JointProperties(0.0, 1.0),
    }
    skeleton = kindsl.parse(MASSLESS, Settings()).skeleton()
    choices = WritingChoices(endless_joints=True, joints=limits)
    text = {format.name: format.write("arm", skeleton, choices) for format in BOTH_WAYS}
    in_mujoco = mujoco.MjModel.from_xml_string(text["mjcf"].text)
    assert in_mujoco.jnt_limited.tolist() == [1, 1, 0]
    assert in_mujoco.jnt_range.tolist()[:2] == [[-1.0, 1.5], [-0.5, 1e6]]
    in_pinocchio = pinocchio.buildModelFromXML(text["urdf"].text)
    assert in_pinocchio.lowerPositionLimit[:2].tolist() == [-1.0, -0.5]
    assert in_pinocchio.upperPositionLimit[:2].tolist() == [1.5, 1.0]
    assert in_pinocchio.nq == 4, "the unlimited joint alone is endless"
    assert text["urdf"].remarks == ()
    limit = [list(found) for found in etree.fromstring(text["sdf"].text.encode()).iter("limit")]
    ends = [[(end.tag, float(end.text)) for end in found] for found in limit]
    assert ends == [[("lower", -1.0), ("upper", 1.5)], [("lower", -0.5)]]


def test_a_massless_link_is_told_as_such_in_sdf() -> None:
    skeleton = kindsl.parse(MASSLESS, Settings()).skeleton()
    found = format_named("sdf").write("arm", skeleton, ORDINARY)
    assert found.remarks == tuple(
        f"the link '{name}' has no mass: other tools refuse it" for name in "ab"
    )


def test_comments_before_a_root_are_read_once() -> None:
    """In every way to end them they were 2^60 ways."""
    assert other_format("a", 60 * "<!-- a -->\n" + "<launch/>") is None
    found = other_format("a", 60 * "<!-- a -->\n" + "<robot/>")
    assert found is not None and found.name == "urdf"
