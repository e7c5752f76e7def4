"""Bodies are drawn where they are."""

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from kindsl.robots.scene.marks import JOINT_TURNS, body_marks
from kindsl.robots.scene.size import Segment

components = st.floats(-3.0, 3.0).map(lambda number: 0.0 if abs(number) < 1e-6 else number)


@given(st.tuples(components, components, components))
def test_a_rod_goes_from_the_origin_to_the_end(end):
    assume(np.linalg.norm(end) > 1e-6)
    messages = body_marks("robot", "link", (Segment("tip", end),), "body")
    transforms = {m.path: m.matrix for m in messages if m.type == "set_transform"}
    rod = np.reshape(transforms["/kindsl/robot/links/link/body/segment-tip"], (4, 4)).T
    for y, wanted in ((-0.5, np.zeros(3)), (0.5, end)):
        np.testing.assert_allclose((rod @ [0.0, y, 0.0, 1.0])[:3], wanted, atol=1e-12)
    x, y, z = rod[:3, :3].T
    np.testing.assert_allclose([x @ x, z @ z, x @ y, x @ z, y @ z], [1, 1, 0, 0, 0], atol=1e-12)
    assert np.linalg.det(rod[:3, :3]) > 0.0


def test_a_joint_of_another_kind_is_another_mark():
    from kindsl.robots.scene.marks import joint_marks

    paths = [
        {message.path for message in joint_marks("j", kind)} for kind in ("revolute", "prismatic")
    ]
    assert "/kindsl/robot/joints/j/revolute/mark" in paths[0] - paths[1]
    assert "/kindsl/robot/joints/j/prismatic/mark" in paths[1] - paths[0]


@pytest.mark.parametrize(("kind", "along"), [("revolute", (0, 1, 0)), ("prismatic", (0, 0, 1))])
def test_the_axis_of_a_mark_is_turned_to_that_of_the_joint(kind, along):
    turn = np.reshape(JOINT_TURNS[kind], (4, 4)).T
    np.testing.assert_array_equal(turn @ [*along, 1.0], [0.0, 0.0, 1.0, 1.0])
    np.testing.assert_array_equal(turn @ turn.T, np.eye(4))
    assert np.linalg.det(turn) == 1.0
