"""What is imported moves and weighs as MuJoCo says, wherever and however its root is placed."""

from pathlib import Path
from typing import get_args

import mujoco
import numpy as np
import pytest
from tests.interchange.mujoco_agreement import gap_of_imported
from tests.interchange.placed_robots import RootKind, placed_robot
from tests.interchange.placed_texts import mjcf, sdf, urdf
from tests.interchange.round_trips import gaps, mechanism_of, read, written_and_read
from tests.support.amount import usually

from kindsl.interchange.kindsl_writing import kindsl_text
from kindsl.interchange.registry import format_named

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
