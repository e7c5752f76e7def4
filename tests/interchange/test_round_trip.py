"""URDF and back keeps the mechanics; other libraries read the same robot from our URDF."""

from pathlib import Path

import mujoco
import numpy as np
import pinocchio
import pytest
from tests.interchange.configurations import configuration, velocity_order
from tests.interchange.random_robots import random_robot
from tests.interchange.round_trips import mechanism_of, written
from tests.support.amount import usually

import kindsl
from kindsl.judgement.analysis.settings import Settings
from kindsl.mechanics.dynamics.evaluation.mechanics import Mechanics
from kindsl.mechanics.spatial.arrays import Array
from kindsl.robots.interchange.format import FormatError, ReadingChoices
from kindsl.robots.interchange.kindsl_writing import kindsl_text, written_kindsl
from kindsl.robots.interchange.registry import format_named
from kindsl.robots.interchange.urdf.urdf_reading import robot_of_urdf

TOLERANCE = 1e-9  # what the issue of a round trip promises, absolute, at dimensions near one
SEEDS = range(0, 200, usually(5, thoroughly=1))
URDF_FORMAT = format_named("urdf")


def written_and_read(robot: Mechanics, folder: Path) -> Mechanics:
    path = folder / "robot.urdf"
    path.write_text(written(robot, URDF_FORMAT))
    choices = ReadingChoices(robot.bodies.is_floating)
    return mechanism_of(kindsl_text(robot_of_urdf(path.read_bytes(), "robot", choices).robot))


def by_name(mechanics: Mechanics, values: dict[str, float]) -> Array:
    return np.array([values[name] for name in mechanics.bodies.joint_names])


@pytest.mark.parametrize("seed", SEEDS)
def test_round_trip_keeps_poses_inertia_and_forces(seed: int, tmp_path: Path) -> None:
    before = mechanism_of(kindsl_text(random_robot(seed)))
    after = written_and_read(before, tmp_path)
    chance = np.random.default_rng(seed)
    names = before.bodies.joint_names
    state = [dict(zip(names, chance.uniform(-1, 1, len(names)), strict=True)) for _ in range(3)]
    q_before, q_after = (by_name(m, state[0]) for m in (before, after))
    poses = before.forward_kinematics(q_before), after.forward_kinematics(q_after)
    assert poses[0].keys() == poses[1].keys()
    for name, pose in poses[0].items():
        np.testing.assert_allclose(poses[1][name], pose, rtol=0, atol=TOLERANCE)
    order = [after.bodies.joint_names.index(name) for name in names]
    n_base = 6 if before.bodies.is_floating else 0
    rows = [*range(n_base), *(n_base + i for i in order)]
    M = before.joint_space_inertia(q_before), after.joint_space_inertia(q_after)[np.ix_(rows, rows)]
    np.testing.assert_allclose(M[1], M[0], rtol=0, atol=TOLERANCE)
    forces = [_joint_forces(m, [by_name(m, part) for part in state]) for m in (before, after)]
    np.testing.assert_allclose(forces[1][order], forces[0], rtol=0, atol=TOLERANCE * 10)


def _joint_forces(mechanics: Mechanics, state: list[Array]) -> Array:
    result = mechanics.inverse_dynamics(*state)
    return np.asarray(result[0] if mechanics.bodies.is_floating else result)


@pytest.mark.parametrize("seed", range(0, 200, 10))
def test_pinocchio_reads_the_same_inertia(seed: int) -> None:
    ours = mechanism_of(kindsl_text(random_robot(seed)))
    model = pinocchio.buildModelFromXML(written(ours, URDF_FORMAT))
    values = dict.fromkeys(ours.bodies.joint_names, 0.0)
    chance = np.random.default_rng(seed)
    values |= {name: float(chance.uniform(-1, 1)) for name in values}
    M = pinocchio.crba(model, model.createData(), configuration(model, values))
    M = np.triu(M) + np.triu(M, 1).T
    n_base = 6 if ours.bodies.is_floating else 0
    order = velocity_order(model, list(ours.bodies.joint_names))
    mine = ours.joint_space_inertia(by_name(ours, values))[n_base:, n_base:]
    np.testing.assert_allclose(M[np.ix_(order, order)], mine, rtol=0, atol=TOLERANCE)


@pytest.mark.parametrize("seed", range(5, 200, 20))
def test_mujoco_reads_the_same_inertia(seed: int) -> None:
    ours = mechanism_of(kindsl_text(random_robot(seed)))
    model = mujoco.MjModel.from_xml_string(written(ours, URDF_FORMAT))
    data = mujoco.MjData(model)
    chance = np.random.default_rng(seed)
    values = {name: float(chance.uniform(-1, 1)) for name in ours.bodies.joint_names}
    for name, value in values.items():
        data.joint(name).qpos[0] = value
    mujoco.mj_forward(model, data)
    M = np.zeros((model.nv, model.nv))
    mujoco.mj_fullM(model, data, M)
    order = [model.joint(name).dofadr[0] for name in ours.bodies.joint_names]
    n_base = 6 if ours.bodies.is_floating else 0
    mine = ours.joint_space_inertia(by_name(ours, values))[n_base:, n_base:]
    np.testing.assert_allclose(M[np.ix_(order, order)], mine, rtol=0, atol=1e-8)


URDF = """<robot name="my-robot 1"><link name="world"/><link name="link"/><link name="2nd">
<inertial><origin xyz="0 0 0.1"/><mass value="2"/>
<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link><link name="tip"/>
<joint name="world_fixed" type="fixed"><parent link="world"/><child link="link"/></joint>
<joint name="2nd" type="{kind}"><parent link="link"/><child link="2nd"/>
<origin xyz="0 0 1" rpy="0 0.5 0"/><axis xyz="{axis}"/>
<limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
<joint name="tip_fixed" type="fixed"><parent link="2nd"/><child link="tip"/>
<origin xyz="1 0 0"/></joint></robot>"""


def read(tmp_path: Path, kind: str = "revolute", axis: str = "0 1 0") -> tuple[str, str]:
    path = tmp_path / "robot.urdf"
    path.write_text(URDF.format(kind=kind, axis=axis))
    found = robot_of_urdf(path.read_bytes(), "robot")
    return kindsl_text(found.robot), "\n".join(found.remarks)


def test_fixed_links_become_frames_and_names_become_valid(tmp_path: Path) -> None:
    text, remarks = read(tmp_path)
    document = kindsl.parse(text, Settings())
    assert document.model.name == "my_robot_1"
    assert [str(link.name) for link in document.model.links] == ["_2nd"]
    assert [str(joint.name) for joint in document.model.joints] == ["_2nd_joint"]
    assert [str(frame.name) for frame in document.model.frames] == ["tip"]
    assert "limits" not in remarks
    assert "the link 'tip', fixed to '2nd', became a frame of it" in remarks
    assert "the link 'link', fixed to 'world', merged with it" in remarks


@pytest.mark.parametrize("axis", ["0 1 0", "0 0 -1", "0.6 0 -0.8", "1e-5 0 -1", "-2 1 0.5"])
def test_axis_turns_to_z(axis: str, tmp_path: Path) -> None:
    text, _ = read(tmp_path, axis=axis)
    mechanics = mechanism_of(text)
    model = pinocchio.buildModelFromXML(URDF.format(kind="revolute", axis=axis))
    data = model.createData()
    pinocchio.framesForwardKinematics(model, data, np.array([0.7]))
    theirs = data.oMf[model.getFrameId("tip")].homogeneous
    np.testing.assert_allclose(mechanics.forward_kinematics([0.7])["tip"], theirs, atol=1e-12)


def test_what_the_language_has_not_is_refused_by_name(tmp_path: Path) -> None:
    with pytest.raises(FormatError, match="'2nd'> is a planar joint"):
        written_kindsl(robot_of_urdf(URDF.format(kind="planar", axis="0 1 0"), "robot"))
    with pytest.raises(FormatError, match="no attribute 'name'"):
        robot_of_urdf("<robot><link/></robot>", "robot")
    with pytest.raises(FormatError, match="not a readable URDF"):
        robot_of_urdf("no xml", "robot")
