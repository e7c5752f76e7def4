"""What scales the picture follows the robot, whatever its size."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.preview.robots import ARM, plain_robot, skeleton_in, skeleton_of

from kindsl.robots.scene.size import LARGEST_RADIUS, STEP, extent


@given(links=st.integers(1, 12), seed=st.integers(0, 50))
@settings(max_examples=40, deadline=None)
def test_the_box_holds_all_bodies(links, seed):
    skeleton = skeleton_in(plain_robot(links, seed))
    size = extent(skeleton)
    assert size.size > 0.0
    assert 0.0 < size.radius <= LARGEST_RADIUS * size.size * STEP
    assert len(size.segments) == len(skeleton.masses)
    for own in size.segments:
        assert all(np.linalg.norm(segment.end) <= 1.001 * size.size for segment in own)


@pytest.mark.parametrize("scale", [0.001, 1.0, 1000.0])
def test_all_sizes_look_alike(scale):
    text = ARM.replace("0.5)", f"{0.5 * scale})").replace("(0.4,", f"({0.4 * scale},")
    text = text.replace("0.3)", f"{0.3 * scale})")
    assert extent(skeleton_of(text)).radius / extent(skeleton_of(text)).size == pytest.approx(
        extent(skeleton_of(ARM)).radius / extent(skeleton_of(ARM)).size, rel=0.12
    )


def test_a_leaf_reaches_to_its_frames():
    size = extent(skeleton_of(ARM))
    assert [segment.name for segment in size.segments[2]] == ["tool"]


def test_the_ground_lies_below_a_floating_robot_and_under_a_fixed_base():
    assert extent(skeleton_of(ARM)).ground == 0.0
    assert extent(skeleton_of(ARM.replace("base {", "base floating {"))).ground < 0.0


def test_a_robot_without_extent_has_a_size():
    text = ARM
    for length in ("0.5)", "(0.4,", "(0.2,", "0.1)", "0.3)"):
        text = text.replace(length, length.replace(length.strip("(),"), "0.0"))
    assert extent(skeleton_of(text)).size == 1.0
