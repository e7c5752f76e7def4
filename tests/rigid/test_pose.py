"""Poses in plain floats, against NumPy's and against their own definitions."""

from math import atan2, cos, pi, sin

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from tests.support.spatial import rotation_from_intrinsic_xyz

from kindsl.mechanics.rigid.pose import (
    IDENTITY,
    PLAIN,
    Rotation,
    Vector3,
    angles,
    fixed_axis_angles,
    pose_from,
    pose_from_fixed_axes,
)
from kindsl.mechanics.spatial.transforms import homogeneous

# Rounding of sums and products of numbers up to one.
ROUNDING = 1e-15

turns = st.one_of(
    st.floats(-7.0, 7.0),
    st.sampled_from([0.0, pi / 2, -pi / 2, pi, -pi, 3 * pi / 2]),
    # Around a quarter turn, at all distances.
    st.builds(
        lambda e, sign: sign * (pi / 2 - 10.0**e), st.floats(-17.0, -1.0), st.sampled_from([1, -1])
    ),
)
triples = st.tuples(turns, turns, turns)
places = st.tuples(*[st.floats(-10.0, 10.0)] * 3)
many = settings(max_examples=150, deadline=None, derandomize=True)


def _matrix(rotation: Rotation) -> np.ndarray:
    return np.array(rotation)


def _again(rotation: Rotation, within: float) -> np.ndarray:
    return _matrix(pose_from((0.0, 0.0, 0.0), angles(rotation, within)).rotation)


@many
@given(triples)
def test_turns_are_those_of_batches(given_angles: Vector3) -> None:
    ours = _matrix(pose_from((0.0, 0.0, 0.0), given_angles).rotation)
    theirs = rotation_from_intrinsic_xyz(np.array(given_angles))
    np.testing.assert_allclose(ours, theirs, rtol=0, atol=ROUNDING)


@many
@given(triples)
@example((0.4, pi / 2, -1.1))
@example((0.4, pi / 2 - 1e-9, -1.1))
@example((0.4, pi / 2 - 3e-8, -1.1))
@example((0.3, -pi / 2, 0.4))
def test_angles_make_the_rotation_again(given_angles: Vector3) -> None:
    """For files nothing may be lost, least of all near a quarter turn."""
    rotation = pose_from((0.0, 0.0, 0.0), given_angles).rotation
    np.testing.assert_allclose(_again(rotation, 0.0), _matrix(rotation), rtol=0, atol=2 * ROUNDING)
    np.testing.assert_allclose(_again(rotation, PLAIN), _matrix(rotation), rtol=0, atol=2 * PLAIN)


@many
@given(triples, places)
@example((0.4, pi / 2, -1.1), (1.0, 2.0, 3.0))
def test_turns_about_fixed_axes_follow_each_other(rpy: Vector3, place: Vector3) -> None:
    pose = pose_from_fixed_axes(place, rpy)
    single = [
        pose_from((0.0, 0.0, 0.0), tuple(rpy[i] * (i == j) for j in range(3))) for i in (0, 1, 2)
    ]
    x, y, z = (_matrix(turn.rotation) for turn in single)
    assert pose.translation == place
    np.testing.assert_allclose(_matrix(pose.rotation), z @ y @ x, rtol=0, atol=ROUNDING)
    again = pose_from_fixed_axes(place, fixed_axis_angles(pose.rotation))
    np.testing.assert_allclose(
        _matrix(again.rotation), _matrix(pose.rotation), rtol=0, atol=2 * ROUNDING
    )


def test_rounding_at_a_quarter_turn_about_the_fixed_y_is_no_turn_about_z() -> None:
    """It leaves a cosine, from which two angles of no meaning could be read."""
    pose = pose_from((0.0, 0.0, 0.0), (-pi / 2, 0.0, -pi / 2))
    assert fixed_axis_angles(pose.rotation) == pytest.approx((-pi / 2, -pi / 2, 0.0), abs=1e-15)


@pytest.mark.parametrize("quarter", [pi / 2, -pi / 2])
@given(turns, turns)
@many
def test_at_a_quarter_turn_people_read_one_sum(quarter: float, x: float, z: float) -> None:
    got_x, got_y, got_z = angles(pose_from((0.0, 0.0, 0.0), (x, quarter, z)).rotation, PLAIN)
    assert (got_y, got_z) == (pytest.approx(quarter, abs=1e-8), 0.0)
    total = x + z if quarter > 0.0 else x - z
    assert abs(np.exp(1j * got_x) - np.exp(1j * total)) < 1e-8


@many
@given(turns, st.sampled_from((-1.0, 1.0)))
def test_exact_quarter_turns_are_read_without_noise(total: float, side: float) -> None:
    """Matrices that files hold with exact zeros have no rounding to tell the angles apart."""
    c, s = cos(total), sin(total)
    rotation: Rotation = ((0.0, 0.0, side), (side * s, c, 0.0), (-side * c, s, 0.0))
    assert angles(rotation, within=0.0) == (atan2(s, c), side * pi / 2, 0.0)


@many
@given(places, triples, places, triples, places)
def test_poses_chain_as_matrices_do(
    r: Vector3, a: Vector3, r_next: Vector3, a_next: Vector3, point: Vector3
) -> None:
    first, second = pose_from(r, a), pose_from(r_next, a_next)
    T = homogeneous(_matrix(first.rotation), np.array(r)) @ homogeneous(
        _matrix(second.rotation), np.array(r_next)
    )
    both = first.then(second)
    np.testing.assert_allclose(_matrix(both.rotation), T[:3, :3], rtol=0, atol=1e-14)
    np.testing.assert_allclose(both.translation, T[:3, 3], rtol=0, atol=1e-13)
    np.testing.assert_allclose(both.point(point), (T @ [*point, 1.0])[:3], rtol=0, atol=1e-12)
    back = first.inverse().then(first)
    np.testing.assert_allclose(_matrix(back.rotation), _matrix(IDENTITY.rotation), atol=1e-14)
    np.testing.assert_allclose(back.translation, IDENTITY.translation, atol=1e-13)


@pytest.mark.parametrize(("off", "is_plain"), [(1e-3, False), (1e-7, False), (1e-10, True)])
def test_for_people_only_what_is_a_quarter_turn_to_nine_digits_is_one_sum(
    off: float, is_plain: bool
) -> None:
    rotation = pose_from((0.0, 0.0, 0.0), (0.3, pi / 2 - off, 0.4)).rotation
    x, _, z = angles(rotation, PLAIN)
    assert (z == 0.0) is is_plain
    assert x == pytest.approx(0.7 if is_plain else 0.3, abs=1e-6)
