"""Gestures that add or rewrite whole things: what they write, and the mechanics they promise."""

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.support.mechanisms import matrix
from tests.support.models import Style, random_model

from kindsl.frontends.features.manipulation.additions import add_child, add_frame
from kindsl.frontends.features.manipulation.gesture import Gesture, Refusal
from kindsl.frontends.features.manipulation.mirror_leg import mirror_leg
from kindsl.frontends.features.manipulation.pose_as_zero import pose_as_zero
from kindsl.judgement.analysis.analysis import analyse
from kindsl.language.formatting import format_document
from kindsl.robots.mechanism.reading import reachable_linkage

EXAMPLES = Path(__file__).parents[3] / "examples"
QUADRUPED = (EXAMPLES / "quadruped.kindsl").read_text()
ONE_LINE = random_model(6, 2, Style(layout="one_line", has_expressions=False))
MIRROR = np.diag([1.0, -1.0, 1.0])
MIRROR_4 = np.diag([1.0, -1.0, 1.0, 1.0])
LEFT_LEG = """\
Robot biped {
RobotBase trunk floating {
    inertia_params { mass = 9.0 CoM = (0.0, 0.0, 0.0)
        Ix = 0.2 Iy = 0.2 Iz = 0.2 Ixy = 0.0 Ixz = 0.0 Iyz = 0.0 }
    children {
        left_thigh via left_hip
    }
}
link left_thigh {
    id = 1
    inertia_params { mass = 2.0 CoM = (0.1, 0.02, -0.03)
        Ix = 0.1 Iy = 0.2 Iz = 0.2 Ixy = 0.01 Ixz = -0.02 Iyz = 0.005 ref_frame = left_mid }
    children { left_shin via left_knee }
    frames { left_mid { translation = (0.1, 0.2, 0.3) rotation = (0.4, PI/5.0, -0.6) } }
}
link left_shin {
    id = 2
    inertia_params { mass = 1.0 CoM = (0.1, length/2.0, 0.0)
        Ix = 0.1 Iy = 0.1 Iz = 0.1 Ixy = 0.0 Ixz = 0.0 Iyz = 0.0 }
    children { }
    frames { left_foot { translation = (length[0.3], -length, 0.0) rotation = (PI, 0.1, 0.0) } }
}
r_joint left_hip { ref_frame { translation = (0.2, 0.1, 0.0) rotation = (-PI/2.0, 0.3, 0.2) } }
p_joint left_knee { ref_frame { translation = (0.0, -0.4, 0.0) rotation = (0.5, 0.0, PI/2.0) } }
}
"""


def made(analysis, gesture):
    assert isinstance(gesture, Gesture), gesture
    return analysis.edited(gesture.edits)


def errors(analysis):
    return [(f.code, f.message) for f in analysis.findings if f.severity == "error"]


def poses(analysis, q):
    """Return where each link and frame is when the joints are at `q`, in the base's frame."""
    skeleton = reachable_linkage(analysis.model, analysis.context.values)
    found = {skeleton.base_name: np.eye(4)}
    names = skeleton.body_names
    for link, parent in skeleton.links():
        joint, kind = skeleton.joint_names[link - 1], skeleton.joint_kinds[link - 1]
        placed = matrix(skeleton.placements[link - 1])
        found[names[link]] = found[names[parent]] @ placed @ motion(kind, q.get(joint, 0.0))
    for frame in skeleton.frames:
        found[frame.name] = found[names[frame.body]] @ matrix(frame.pose)
    return found


def motion(kind, position):
    T = np.eye(4)
    if kind == "prismatic":
        T[2, 3] = position
    else:
        c, s = np.cos(position), np.sin(position)
        T[:2, :2] = [[c, -s], [s, c]]
    return T


@given(
    links=st.integers(1, 10),
    seed=st.integers(0, 200),
    data=st.lists(st.floats(-3.0, 3.0), min_size=20, max_size=20),
)
@settings(max_examples=40, deadline=None)
def test_the_new_zero_is_the_pose_that_was_shown(links, seed, data):
    analysis = analyse(random_model(links, seed, Style(has_expressions=False)))
    names = list(analysis.model.joint_named)
    shown = dict(zip(names, data, strict=False))
    again = dict(zip(names, data[10:], strict=False))
    moved = made(analysis, pose_as_zero(analysis, shown))
    both = {name: shown[name] + again[name] for name in names}
    wanted, found = poses(analysis, both), poses(moved, again)
    for name, pose in wanted.items():
        np.testing.assert_allclose(found[name], pose, rtol=0, atol=1e-12)
    assert errors(moved) == errors(analysis)


def test_the_new_zero_is_written_with_pi_where_it_is_exact():
    analysis = analyse(QUADRUPED)
    moved = made(analysis, pose_as_zero(analysis, {"LF_HAA": np.pi / 2.0, "LF_KFE": 0.0}))
    changed = [line for line in moved.text.split("\n") if line not in QUADRUPED.split("\n")]
    assert [line.strip() for line in changed] == ["rotation = (0.0, PI/2.0, PI/2.0)"]


def test_a_parametric_joint_cannot_take_a_new_zero():
    text = LEFT_LEG.replace("0.3, 0.2)", "0.3, twist)")
    refused = pose_as_zero(analyse(text), {"left_hip": 0.5})
    assert refused == Refusal("'twist' of joint 'left_hip' is not a plain number")
    assert pose_as_zero(analyse(text), {"hip": 0.5}) == Refusal("there is no joint 'hip'")


def test_a_mirrored_leg_is_the_mirror_image():
    analysis = analyse(LEFT_LEG)
    moved = made(analysis, mirror_leg(analysis, "left_thigh"))
    assert errors(moved) == []
    q = {"left_hip": 0.7, "left_knee": 0.2, "right_hip": -0.7, "right_knee": 0.2}
    found = poses(moved, q)
    for name in ("left_thigh", "left_shin", "left_mid", "left_foot"):
        mirrored = MIRROR_4 @ found[name] @ MIRROR_4
        right = name.replace("left", "right")
        np.testing.assert_allclose(found[right], mirrored, rtol=0, atol=1e-12)
    assert_mirrored_bodies(moved)
    assert [link.id for link in moved.model.links] == [1, 2, 3, 4]


def assert_mirrored_bodies(analysis):
    skeleton = reachable_linkage(analysis.model, analysis.context.values)
    bodies = dict(zip(skeleton.body_names, skeleton.masses, strict=True))
    for name, body in bodies.items():
        if name.startswith("left"):
            other = bodies[name.replace("left", "right")]
            np.testing.assert_allclose(other.com, MIRROR @ body.com, atol=1e-12)
            signs = np.array([1, 1, 1, -1, 1, -1])
            np.testing.assert_allclose(other.moments, signs * body.moments, atol=1e-12)


def test_a_leg_is_mirrored_from_either_side():
    right = LEFT_LEG.replace("left", "right")
    moved = made(analyse(right), mirror_leg(analyse(right), "right_thigh"))
    wanted = made(analyse(LEFT_LEG), mirror_leg(analyse(LEFT_LEG), "left_thigh"))
    swapped = wanted.text.replace("left", "LEFT").replace("right", "left").replace("LEFT", "right")
    assert moved.text == swapped


@pytest.mark.parametrize(
    ("link", "text", "reason"),
    [
        ("trunk", LEFT_LEG, "there is no link 'trunk' with a supporting joint"),
        ("arm", LEFT_LEG, "there is no link 'arm' with a supporting joint"),
        (
            "left_thigh",
            LEFT_LEG.replace("left_mid", "mid"),
            "the name 'mid' tells no side, such as 'LF' or 'left'",
        ),
        ("LF_thigh", QUADRUPED, "'RF_thigh' is already defined"),
    ],
)
def test_what_cannot_be_mirrored(link, text, reason):
    assert mirror_leg(analyse(text), link) == Refusal(reason)


@pytest.mark.parametrize("text", [QUADRUPED, LEFT_LEG, ONE_LINE])
def test_every_link_takes_a_frame_and_a_child(text):
    analysis = analyse(text)
    before = poses(analysis, {})
    for name in analysis.model.body_named:
        for add in (add_frame, add_child):
            gesture = add(analysis, name, (0.1, 0.0, -0.25))
            moved = made(analysis, gesture)
            assert errors(moved) == errors(analysis)
            found = poses(moved, {})
            for old, pose in before.items():
                np.testing.assert_array_equal(found[old], pose)
            new = found[gesture.names[0]]
            np.testing.assert_allclose(new[:3, 3], (before[name] @ [0.1, 0.0, -0.25, 1.0])[:3])


@pytest.mark.parametrize("name", ["LF_shank", "LF_hip"])
def test_what_is_added_is_laid_out_as_the_formatter_would(name):
    analysis = analyse(QUADRUPED)
    assert not format_document(analysis.syntax)
    for add in (add_frame, add_child):
        assert not format_document(made(analysis, add(analysis, name, (0.1, 0.0, 0.0))).syntax)
