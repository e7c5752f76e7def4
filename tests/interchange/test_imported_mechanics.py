"""What is imported moves and weighs as MuJoCo says, wherever and however its root is placed."""

from pathlib import Path
from typing import get_args

import mujoco
import numpy as np
import pytest
from tests.interchange.mujoco_agreement import gap_of_imported
from tests.interchange.placed_robots import RootKind, placed_robot
from tests.interchange.placed_texts import mjcf, sdf, urdf
from tests.interchange.random_robots import random_robot
from tests.interchange.round_trips import gaps, mechanism_of, read, written_and_read
from tests.support.amount import usually

import kindsl
from kindsl.judgement.analysis.settings import Settings
from kindsl.mechanics.rigid.body import MassDistribution
from kindsl.robots.interchange.kindsl_writing import kindsl_text
from kindsl.robots.interchange.registry import format_named
from kindsl.robots.mechanism.linkage import Linkage

TOLERANCE = 1e-9
SEEDS = range(usually(8, 300))
WAYS = {"mjcf": lambda bodies, _: mjcf(bodies), "sdf": sdf, "urdf": urdf}


@pytest.mark.parametrize("root", get_args(RootKind))
@pytest.mark.parametrize("format", WAYS)
@pytest.mark.parametrize("seed", SEEDS)
def test_mechanics_are_those_of_mujoco(
    format: str, root: RootKind, seed: int, tmp_path: Path
) -> None:
    chance = np.random.default_rng([seed, len(root)])
    bodies = placed_robot(chance, root)
    model = mujoco.MjModel.from_xml_string(mjcf(bodies))
    found = read(WAYS[format](bodies, chance), format_named(format), tmp_path)
    assert found.robot.is_floating == (root == "floating")
    ours = mechanism_of(kindsl_text(found.robot))
    assert ours.bodies.frames
    assert max(gap_of_imported(ours, model, chance)) < TOLERANCE
    for other in ("mjcf", "sdf"):
        again = written_and_read(ours, format_named(other), tmp_path)
        assert max(gaps(ours, again, chance)) < TOLERANCE


@pytest.mark.parametrize("format", ["urdf", "mjcf"])
def test_the_axis_that_is_not_written(format: str, tmp_path: Path) -> None:
    """x in a URDF, z in an MJCF, as MuJoCo reads both."""
    mass = '<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/>'
    text = {
        "urdf": f"""<robot name="r"><link name="base"/><link name="arm">{mass}</inertial></link>
<joint name="turn" type="revolute"><parent link="base"/><child link="arm"/>
<limit lower="-1" upper="1" effort="1" velocity="1"/></joint></robot>""",
        "mjcf": """<mujoco><worldbody><body name="base"><body name="arm"><joint name="turn"/>
<inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/></body></body></worldbody></mujoco>""",
    }[format]
    ours = mechanism_of(kindsl_text(read(text, format_named(format), tmp_path).robot))
    axis = ours.bodies.p_R_j[0, :, 2]
    np.testing.assert_allclose(axis, mujoco.MjModel.from_xml_string(text).jnt_axis[0], atol=1e-15)


@pytest.mark.parametrize("size", [1e-4, 1e-2, 1.0, 1e2])
def test_bodies_of_any_size_keep_their_digits(size: float) -> None:
    """Of one density: a body of 0.1 mm weighs micrograms, and its moments are of 1e-17 kg m^2."""
    body = random_robot(1).bodies[1]
    small = scaled(body.mass, size)
    base = body._replace(parent=None, joint="").weighing(None)
    text = kindsl_text(Linkage((base, body._replace(parent=0).weighing(small)), name="r"))
    (body,) = kindsl.parse(text, Settings()).mechanism().bodies.masses[1:]
    np.testing.assert_allclose(body, small.mass, rtol=1e-13)
    read_again = kindsl.parse(text, Settings()).mechanism().linkage.masses[1]
    greatest = max(small.moments)
    np.testing.assert_allclose(read_again.moments, small.moments, rtol=0, atol=1e-13 * greatest)


def scaled(body: MassDistribution, size: float) -> MassDistribution:
    com = tuple(size * c for c in body.com)
    moments = tuple(size**5 * moment for moment in body.moments)
    return MassDistribution(size**3 * body.mass, com, moments)
