"""What a pose that becomes the new zero changes of each joint."""

import pytest

from kindsl.frontends.features.manipulation.gesture import Refusal
from kindsl.frontends.features.manipulation.pose_as_zero import pose_as_zero
from kindsl.judgement.analysis.analysis import analyse


@pytest.mark.parametrize(
    ("joint", "q", "pose"),
    [
        ("p_joint j {{ ref_frame {{ translation = ({}) rotation = (0.0, 0.0, 0.0) }} }}",
         0.25, ("0.1, 0.2, 0.3", "0.1, 0.2, 0.55")),
        ("p_joint j {{ ref_frame {{ translation = ({}) rotation = (-PI/2.0, 0.0, 0.0) }} }}",
         0.25, ("0.1, 0.2, 0.3", "0.1, 0.45, 0.3")),
        ("p_joint j {{ ref_frame {{ translation = ({}) rotation = (0.0, PI/2.0, 0.0) }} }}",
         -0.1, ("0.1, y, z", "0.0, y, z")),
        ("r_joint j {{ ref_frame {{ translation = (x, y, z) rotation = ({}) }} }}",
         -0.25, ("a, b, 0.75", "a, b, 0.5")),
        # What has two digits is not written with seventeen.
        ("r_joint j {{ ref_frame {{ translation = (x, y, z) rotation = ({}) }} }}",
         0.1, ("a, b, 0.2", "a, b, 0.3")),
        ("r_joint j {{ ref_frame {{ translation = (x, y, z) rotation = ({}) }} }}",
         0.1, ("a, b, 0.7", "a, b, 0.8")),
        ("r_joint j {{ ref_frame {{ translation = (x, y, z) rotation = ({}) }} }}",
         0.0, ("a, b, c", "a, b, c")),
        ("p_joint j {{ ref_frame {{ translation = ({}) }} }}", 0.0, ("x, y, z", "x, y, z")),
    ],
)  # fmt: skip
def test_a_new_zero_changes_only_what_the_joint_moves(
    joint: str, q: float, pose: tuple[str, str]
) -> None:
    old, new = (joint.format(vector).replace("y, z)", "y[0.5], z[0.5])") for vector in pose)
    analysis = analyse(old)
    assert analysis.edited(pose_as_zero(analysis, {"j": q}).edits).text == new


@pytest.mark.parametrize("position", [1e-9, -3e-12, 2000.0])
def test_a_joint_is_moved_however_little_or_far_and_no_dust_is_written(position: float) -> None:
    joint = "p_joint j {{ ref_frame {{ translation = (0.0, 0.0, {}) rotation = (0.0, PI, 0.0) }} }}"
    analysis = analyse(joint.format("0.0"))
    moved = analysis.edited(pose_as_zero(analysis, {"j": position}).edits)
    components = moved.model.joints[0].pose.translation.components
    assert [c.value({}) for c in components] == [0.0, 0.0, -position]


@pytest.mark.parametrize(
    ("joint", "reason"),
    [
        ("p_joint j { ref_frame { translation = (0.1, 0.2, z) } }", "joint 'j' has no known frame"),
        ("p_joint j { ref_frame { translation = (0.1, 0.2, z[0.3]) rotation = (0.0, 0.0, 0.0) } }",
         "'z[0.3]' of joint 'j' is not a plain number"),
        ("r_joint j { ref_frame { rotation = (0.1, 0.2, z) } }",
         "'z' of joint 'j' is not a plain number"),
        ("r_joint j { }", "joint 'j' has no component 'rz'"),
        ("r_joint j { ref_frame { rotation = (0.1, 0.2, ) } }",
         "component rz of joint 'j' is missing"),
    ],
)  # fmt: skip
def test_what_takes_no_new_zero(joint: str, reason: str) -> None:
    assert pose_as_zero(analyse(joint), {"j": 0.5}) == Refusal(reason)
