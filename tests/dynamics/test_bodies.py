"""Bodies are checked once, when they are put together."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from tests.dynamics.random_bodies import random_bodies

from kindsl.mechanics.dynamics.bodies import BodyFrame

GOOD = random_bodies(np.random.default_rng(0), 3, is_floating=True)
MIRROR = np.diag([1.0, 1.0, -1.0])


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"parents": (0, 2, 1)}, "link 'link2' is body 2: its parent 2 is not before it"),
        ({"parents": (0, -1, 1)}, "its parent -1 is not before it"),
        ({"parents": (0, 1)}, "parents has 2 entries, expected 3"),
        ({"joint_kinds": ("revolute", "fixed", "revolute")}, "'fixed' is neither revolute nor"),
        ({"link_names": ("a", "b", "a")}, "the name 'a' is used twice"),
        ({"link_names": ("a", "base", "b")}, "the name 'base' is used twice"),
        ({"joint_names": ("a", "b", "a")}, "the name 'a' is used twice"),
        ({"masses": np.ones(3)}, r"masses has shape \(3,\), expected \(4,\)"),
        ({"coms": np.full((4, 3), np.nan)}, "coms holds a value that is not finite"),
        ({"inertias": np.array([[[0.0, 1, 0], [0, 0, 0], [0, 0, 0]]] * 4)}, "is not symmetric"),
        (
            {"p_R_j": np.array([MIRROR] * 3)},
            "joint 'joint1': the rotation matrix is not a rotation",
        ),
        ({"p_R_j": np.zeros((3, 3, 3))}, "joint 'joint1': the rotation matrix is not a rotation"),
        (
            {"frames": (BodyFrame("f", 9, np.eye(3), np.zeros(3)),)},
            "frame 'f' is on body 9, of 0 to 3",
        ),
        (
            {"frames": (BodyFrame("f", 0, MIRROR, np.zeros(3)),)},
            "frame 'f': the rotation matrix is not",
        ),
        (
            {"frames": (BodyFrame("f", 0, np.eye(3), np.zeros(2)),)},
            r"position of frame 'f' has shape",
        ),
    ],
)
def test_what_is_wrong_is_named(change: dict[str, Any], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        replace(GOOD, **change)


def test_a_mechanism_has_links() -> None:
    with pytest.raises(ValueError, match="at least one link"):
        replace(GOOD, link_names=())


def test_arrays_are_copied_and_frozen() -> None:
    masses = np.ones(4)
    bodies = replace(GOOD, masses=masses)
    masses[0] = 9.0
    assert bodies.masses[0] == 1.0
    with pytest.raises(ValueError, match="read-only"):
        bodies.masses[0] = 2.0


def test_support_goes_from_body_to_base() -> None:
    bodies = replace(GOOD, parents=(0, 1, 1))
    assert bodies.support(3) == [3, 1]
    assert bodies.support(0) == []
