"""Robots that others publish: converted, they move and weigh as pinocchio reads the original."""

from importlib.metadata import files
from pathlib import Path

import numpy as np
import pinocchio
import pytest
from tests.interchange.configurations import configuration, velocity_order

import kindsl
from kindsl.judgement.analysis.settings import Settings
from kindsl.robots.interchange.format import FormatError
from kindsl.robots.interchange.kindsl_writing import kindsl_text
from kindsl.robots.interchange.urdf.urdf_reading import robot_of_urdf

URDFS = sorted(
    Path(str(file.locate())) for file in files("example-robot-data") or () if file.suffix == ".urdf"
)
STILL = ("quadrotor_base", "iris_simple")
# A macro left unexpanded.
EMPTY = ("ur3",)
# The files write rotations and inertias with six digits; what differs is how they are multiplied.
TOLERANCE = 1e-9


def body_frame(model: pinocchio.Model, link: str) -> int:
    return int(model.getFrameId(link, pinocchio.FrameType.BODY))


def test_there_are_enough_of_them() -> None:
    assert len(URDFS) >= 10


@pytest.mark.parametrize("path", URDFS, ids=lambda path: path.stem)
def test_converted_robot_is_the_published_one(path: Path) -> None:
    if path.stem in EMPTY:
        with pytest.raises(FormatError, match="the URDF has no link"):
            robot_of_urdf(path.read_bytes(), "robot")
        return
    found = robot_of_urdf(path.read_bytes(), "robot")
    if path.stem in STILL:
        assert found.robot.n_links == 0
        return
    document = kindsl.parse(kindsl_text(found.robot), Settings())
    assert not [f for f in document.findings if f.code.startswith(("KD0", "KD1", "KD2", "KD703"))]
    ours = document.mechanism()
    model = pinocchio.buildModelFromUrdf(str(path))
    data = model.createData()
    joints = [*found.robot.joint_names]
    chance = np.random.default_rng(len(joints))
    values = {joint: float(chance.uniform(-0.5, 0.5)) for joint in joints}
    q = configuration(model, values)
    M = pinocchio.crba(model, data, q)
    M = np.triu(M) + np.triu(M, 1).T
    order = velocity_order(model, joints)
    mine = ours.joint_space_inertia(list(values.values()))
    n_base = 6 if found.robot.is_floating else 0
    np.testing.assert_allclose(mine[n_base:, n_base:], M[np.ix_(order, order)], atol=TOLERANCE)
    pinocchio.framesForwardKinematics(model, data, q)
    poses = ours.forward_kinematics(list(values.values()))
    base = data.oMf[body_frame(model, found.robot.base_name)].inverse()
    for link in found.robot.bodies:
        for frame in link.frames:
            theirs = (base * data.oMf[body_frame(model, frame.name)]).homogeneous
            known = [np.eye(4)] if link.parent is None else []
            initial = (link if frame.is_in_place else frame).name[:1].lower()
            known += [pose for n, pose in poses.items() if n.lower().startswith(initial)]
            assert any(np.allclose(each, theirs, rtol=0, atol=1e-9) for each in known), frame.name
