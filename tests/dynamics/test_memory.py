"""Large batches run in chunks: beside the result there is little."""

import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]
LIMIT = 2 * 1024**3

PROGRAM = """
import resource
import numpy as np
from kindsl.mechanics.dynamics.evaluation.mechanics import Mechanics
from tests.dynamics.random_bodies import random_bodies
bodies = random_bodies(np.random.default_rng(0), 7, is_floating=False, frames_per_link=0.0)
poses = Mechanics(bodies).forward_kinematics(np.zeros((1_000_000, 7)))
assert poses["link7"].shape == (1_000_000, 4, 4)
print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)
"""


def test_a_million_poses_of_an_arm_stay_within_two_gibibytes() -> None:
    assert _peak_memory(PROGRAM) < LIMIT


def test_long_chains_use_little_beside_the_result() -> None:
    program = PROGRAM.replace("1_000_000", "20_000").replace("7", "60")
    assert _peak_memory(program) < LIMIT // 2


def _peak_memory(program: str) -> int:
    """Return the most memory, in bytes, that a process of its own held."""
    finished = subprocess.run(
        [sys.executable, "-c", program], cwd=ROOT, capture_output=True, text=True, check=False
    )
    assert finished.returncode == 0, finished.stderr
    return int(finished.stdout) * (1 if sys.platform == "darwin" else 1024)
