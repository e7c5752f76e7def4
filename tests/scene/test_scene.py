"""The scene as data: what an edit changes, and that all kinds of things are in it."""

import json
import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.preview.robots import ARM, plain_robot, skeleton_in, skeleton_of
from tests.support.documents import all_documents

from kindsl.frontends.preview.changes import changes, keyed
from kindsl.judgement.analysis.analysis import analyse
from kindsl.robots.scene.encoding import as_json, encode
from kindsl.robots.scene.messages import Change, SetTransform, ValueMessage
from kindsl.robots.scene.picture import picture
from kindsl.robots.scene.robot import ghost_messages, robot_messages, solid_messages

CATEGORIES = {
    "base", "body", "axis", "link-frame", "joint-frame", "com", "robot-com", "inertia", "torque",
}  # fmt: skip


def drawn(name, skeleton):
    return [*robot_messages(name, skeleton), *solid_messages(skeleton)]


def categories(messages):
    paths = [m.path for m in messages if m.type == "set_object"]
    return {path.split("/")[5] for path in paths}


@pytest.mark.parametrize("file", all_documents())
def test_every_category_is_drawn(file):
    analysis = analyse(file.read_text())
    shown = picture(analysis.model, analysis.context.values, None).skeleton
    wanted = CATEGORIES | set(shown.joint_kinds) | ({"optional-frame"} if shown.frames else set())
    assert categories(drawn("robot", shown)) >= wanted


def test_a_moved_joint_moves_transforms_only():
    old = drawn("Arm", skeleton_of(ARM))
    new = drawn("Arm", skeleton_of(ARM.replace("(0.4, 0.0, 0.0)", "(0.41, 0.0, 0.0)")))
    sent = changes(keyed(old), keyed(new))
    kinds = {"joint", "set_transform", "model", "link", "solid"}
    assert {message.type for message in sent} == kinds
    assert {m.name for m in sent if m.type == "joint"} == {"lift"}
    assert {m.name for m in sent if m.type == "link"} == {"upper"}
    # The joint's drum is as thick as its bones, which are as thick as the link is long.
    assert {m.name for m in sent if m.type == "solid"} <= {"upper", "slider"}


def test_a_new_mass_redraws_one_body():
    old = drawn("Arm", skeleton_of(ARM))
    new = drawn("Arm", skeleton_of(ARM.replace("mass = 2.0", "mass = 2.02")))
    sent = changes(keyed(old), keyed(new))
    assert {message.type for message in sent} == {"set_transform", "link", "solid"}
    assert {m.name for m in sent if m.type == "link"} == {"upper"}
    assert {m.name for m in sent if m.type == "solid"} <= {"upper", "slider"}
    assert all("inertia" in m.path for m in sent if m.type == "set_transform")


def test_a_renamed_link_takes_its_marks_along():
    old = drawn("Arm", skeleton_of(ARM))
    new = drawn("Arm", skeleton_of(ARM.replace("slider", "carriage")))
    deleted = [
        message.path for message in changes(keyed(old), keyed(new)) if message.type == "delete"
    ]
    assert deleted == ["/kindsl/robot/links/slider"]


@given(links=st.integers(1, 30), seed=st.integers(0, 20), which=st.integers(0, 29))
@settings(max_examples=25, deadline=None)
def test_a_digit_of_any_joint_changes_few_messages(links, seed, which):
    skeleton = skeleton_in(plain_robot(links, seed))
    placements = list(skeleton.placements)
    (x, y, z), joint = placements[which % links].translation, which % links
    placements[joint] = placements[joint]._replace(translation=(x + 0.01, y, z))
    edited = skeleton.with_placements(placements)
    sent = changes(*(keyed(drawn("r", each)) for each in (skeleton, edited)))
    assert sum(len(encode(message)) for message in sent) < 5000


def test_placements_are_the_joints_homogeneous_matrices_by_columns():
    messages = drawn("Arm", skeleton_of(ARM))
    joint = next(m for m in messages if m.type == "joint" and m.name == "shoulder")
    wanted = [[1, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0.5], [0, 0, 0, 1]]
    np.testing.assert_allclose(np.reshape(joint.placement, (4, 4)).T, wanted, atol=1e-15)


def test_a_ghost_is_made_of_bodies_alone():
    messages = ghost_messages(skeleton_of(ARM))
    assert categories(messages) == {"body"}
    assert all(m.path.startswith("/kindsl/ghost/") for m in messages)


def test_a_message_in_json_has_no_word_that_json_lacks():
    value, place = ValueMessage("/a", "é", math.nan), SetTransform("/b", (1.0, -math.inf))
    assert json.loads(as_json(Change(False, (value, place))))["parts"] == [
        {"type": "value", "path": "/a", "name": "é", "value": None},
        {"type": "set_transform", "path": "/b", "matrix": [1.0, None]},
    ]
