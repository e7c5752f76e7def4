"""A skeleton in plain floats is what the arrays' formulas say of the same document."""

import subprocess
import sys

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.preview.robots import ARM, PLAIN, random_model
from tests.support.documents import EXAMPLES, all_documents
from tests.support.spatial import rotation_from_intrinsic_xyz

from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.language.syntax.vocabulary import MOMENTS
from kindsl.mechanics.spatial.inertia import move_inertia
from kindsl.robots.mechanism.errors import ModelError
from kindsl.robots.mechanism.reading import named_frames, partial_linkage, reachable_linkage

WITHOUT_NUMPY = """
import sys
sys.modules["numpy"] = None
from kindsl.judgement.analysis.analysis import analyse
from kindsl.robots.scene.encoding import encode
from kindsl.robots.scene.picture import picture
from kindsl.robots.scene.robot import robot_messages
analysis = analyse(open(sys.argv[1]).read())
shown = picture(analysis.model, analysis.context.values, None)
print(sum(len(encode(m)) for m in robot_messages("robot", shown.skeleton)) > 1000)
"""


def assert_same_numbers(analysis: Analysis) -> None:
    values = {str(p.name): 0.3 for p in analysis.model.parameters} | analysis.context.values
    skeleton = reachable_linkage(analysis.model, values)
    joints, links = analysis.model.joint_named, analysis.model.body_named
    for name, placement in zip(skeleton.joint_names, skeleton.placements, strict=True):
        assert_pose(placement, joints[name].pose, values)
    for name, body in zip(skeleton.body_names, skeleton.masses, strict=True):
        if links[name].inertia is not None:
            assert_body(body, links[name], values)


def assert_pose(ours, written, values):
    R, r = arrays(written, values)
    np.testing.assert_allclose(ours.rotation, R, rtol=0, atol=1e-15)
    np.testing.assert_allclose(ours.translation, r, rtol=0, atol=0)


def assert_body(ours, link, values):
    inertia = link.inertia
    mass = np.array(inertia.mass.value(values))
    com = numbers(inertia.com, values)
    Ix, Iy, Iz, Ixy, Ixz, Iyz = (inertia.moments[name].value(values) for name in MOMENTS)
    tensor = np.array([[Ix, -Ixy, -Ixz], [-Ixy, Iy, -Iyz], [-Ixz, -Iyz, Iz]])
    for frame in (f for f in link.frames if f.name == inertia.frame):
        com, tensor = move_inertia(mass, com, tensor, *arrays(frame.pose, values))
    size = 1e-14 * (np.abs(tensor).max() + mass * com @ com)
    Ix, Iy, Iz, Ixy, Ixz, Iyz = ours.moments
    mine = [[Ix, -Ixy, -Ixz], [-Ixy, Iy, -Iyz], [-Ixz, -Iyz, Iz]]
    assert ours.mass == mass
    np.testing.assert_allclose(ours.com, com, rtol=1e-14, atol=1e-15)
    np.testing.assert_allclose(mine, tensor, rtol=0, atol=size)


def arrays(pose, values):
    return (
        rotation_from_intrinsic_xyz(numbers(pose.rotation, values)),
        numbers(pose.translation, values),
    )


def numbers(vector, values):
    return np.array([component.value(values) for component in vector.components])


@pytest.mark.parametrize("file", all_documents())
def test_written_robots(file):
    analysis = analyse(file.read_text())
    try:
        assert_same_numbers(analysis)
    except ModelError:
        assert partial_linkage(analysis.model, {}) is not None


@given(links=st.integers(1, 20), seed=st.integers(0, 1000))
@settings(max_examples=60, deadline=None)
def test_random_robots(links, seed):
    assert_same_numbers(analyse(random_model(links, seed, PLAIN)))


@given(links=st.integers(1, 12), seed=st.integers(0, 1000))
@settings(max_examples=30, deadline=None)
def test_both_readers_agree_on_whole_documents(links, seed):
    analysis = analyse(random_model(links, seed, PLAIN))
    values = analysis.context.values
    assert partial_linkage(analysis.model, values) == reachable_linkage(analysis.model, values)


@pytest.mark.parametrize("file", EXAMPLES, ids=lambda file: file.stem)
def test_a_scene_needs_no_numpy(file):
    command = [sys.executable, "-c", WITHOUT_NUMPY, str(file)]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "True"


def test_a_frame_without_a_name_is_not_drawn() -> None:
    at = ARM.index("children")
    frames = "frames { { translation = (0.0, 0.0, 1.0) rotation = (0.0, 0.0, 0.0) } }\n"
    bodies = analyse(ARM[:at] + frames + ARM[at:]).model.bodies
    assert any(not str(frame.name) for body in bodies for frame in body.frames)
    assert all(name for name, _, _ in named_frames(bodies))
