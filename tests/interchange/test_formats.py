"""Every format: what is written is read again as the same robot; MuJoCo has our numbers."""

from pathlib import Path

import mujoco
import numpy as np
import pinocchio
import pytest
from tests.interchange.mujoco_agreement import gap
from tests.interchange.random_robots import random_robot
from tests.interchange.round_trips import gaps, mechanism_of, written, written_and_read

from kindsl.interchange.format import Format, WritingChoices
from kindsl.interchange.kindsl_writing import kindsl_text
from kindsl.interchange.registry import all_formats, format_named, format_of_suffix

TOLERANCE = 1e-9
BOTH_WAYS = [format for format in all_formats() if format.read and format.write]


def test_formats_are_found_with_their_suffixes() -> None:
    assert [format.name for format in all_formats()] == ["mjcf", "sdf", "urdf", "xacro"]
    assert format_of_suffix(".XML") is format_named("mjcf")
    assert format_of_suffix(".step") is None


@pytest.mark.parametrize("format", BOTH_WAYS, ids=lambda format: format.name)
@pytest.mark.parametrize("seed", range(7))
def test_round_trip_keeps_the_mechanics(format: Format, seed: int, tmp_path: Path) -> None:
    before = mechanism_of(kindsl_text(random_robot(seed)))
    if format.name == "urdf" and before.bodies.is_floating:
        pytest.skip("a URDF's root link does not say that it floats")
    after = written_and_read(before, format, tmp_path)
    assert max(gaps(before, after, np.random.default_rng(seed))) < TOLERANCE


@pytest.mark.parametrize("seed", range(8))
def test_mujoco_has_our_numbers(seed: int) -> None:
    ours = mechanism_of(kindsl_text(random_robot(seed)))
    model = mujoco.MjModel.from_xml_string(written(ours, format_named("mjcf")))
    assert max(gap(ours, model, np.random.default_rng(seed))) < TOLERANCE


def test_revolute_joints_of_a_urdf_have_one_coordinate_unless_asked() -> None:
    urdf, ours = format_named("urdf"), mechanism_of(kindsl_text(random_robot(3)))
    plain = pinocchio.buildModelFromXML(written(ours, urdf))
    assert plain.nq == plain.nv == ours.n_joints
    endless = urdf.write("robot", ours.bodies, WritingChoices(endless_joints=True)).text
    n_turning = ours.bodies.joint_kinds.count("revolute")
    assert n_turning and pinocchio.buildModelFromXML(endless).nq == ours.n_joints + n_turning
