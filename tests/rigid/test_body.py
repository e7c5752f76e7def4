"""The mathematics of rigid bodies, against NumPy and against its own definitions."""

import random
from math import sqrt

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.support.bodies import SHAPES, random_body

from kindsl.rigid.body import (
    MassDistribution,
    Symmetric,
    determinant,
    eigensystem,
    equivalent_density,
    greatest_moment,
    greatest_second_moment,
    is_clearly_positive,
    moments_of,
    principal_moments,
    second_moments_about_com,
    seen_from,
    shifted,
)
from kindsl.rigid.pose import Vector3, pose_from
from kindsl.spatial.inertia import move_inertia

entries = st.tuples(*[st.floats(-1e3, 1e3) for _ in range(6)])
seeds = st.integers(0, 10**9)
shapes = st.sampled_from(SHAPES)
triples = st.tuples(*[st.floats(-4.0, 4.0)] * 3)


def matrix_of(entries: Symmetric) -> np.ndarray:
    xx, yy, zz, xy, xz, yz = entries
    return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])


def inertia_tensor_about_com(body: MassDistribution) -> np.ndarray:
    ix, iy, iz, ixy, ixz, iyz = body.moments
    tensor = np.array([[ix, -ixy, -ixz], [-ixy, iy, -iyz], [-ixz, -iyz, iz]])
    c = np.array(body.com)
    return tensor - body.mass * (c @ c * np.eye(3) - np.outer(c, c))


@settings(deadline=None)
@given(entries)
def test_eigensystem_is_that_of_numpy(matrix: Symmetric) -> None:
    pairs = eigensystem(matrix)
    size = 1e-12 * max(map(abs, matrix)) + 1e-300
    np.testing.assert_allclose(
        [pair.value for pair in pairs], np.linalg.eigvalsh(matrix_of(matrix)), atol=size
    )
    axes = np.array([pair.axis for pair in pairs])
    np.testing.assert_allclose(axes @ axes.T, np.eye(3), atol=1e-12)
    again = sum(pair.value * np.outer(pair.axis, pair.axis) for pair in pairs)
    np.testing.assert_allclose(again, matrix_of(matrix), atol=size)


@settings(deadline=None)
@given(seeds, shapes)
def test_principal_moments_are_those_of_the_tensor(seed: int, shape: str) -> None:
    body = random_body(random.Random(seed), shape)
    moments = principal_moments(eigensystem(second_moments_about_com(body)))
    expected = np.linalg.eigvalsh(inertia_tensor_about_com(body))
    np.testing.assert_allclose(moments, expected, atol=1e-12 * (1.0 + sum(body.moments[:3])))


@settings(deadline=None)
@given(entries)
def test_moments_and_second_moments_belong_together(matrix: Symmetric) -> None:
    body = MassDistribution(1.0, (0.0, 0.0, 0.0), moments_of(matrix))
    np.testing.assert_allclose(second_moments_about_com(body), matrix, atol=1e-9)


@settings(deadline=None)
@given(seeds, shapes)
def test_shift_and_back_changes_nothing(seed: int, shape: str) -> None:
    body = random_body(random.Random(seed), shape)
    np.testing.assert_allclose(shifted(shifted(body), -1.0).moments, body.moments, atol=1e-9)


@settings(deadline=None)
@given(entries)
def test_clearly_positive_matrices_are_positive(matrix: Symmetric) -> None:
    values = np.linalg.eigvalsh(matrix_of(matrix))
    if is_clearly_positive(matrix):
        assert values[0] > 0.0
    elif values[0] > 0.0:
        assert values[0] < 1e-3 * values[2]


@settings(deadline=None)
@given(entries)
def test_determinant_is_that_of_numpy(matrix: Symmetric) -> None:
    size = 1e-12 * max(map(abs, matrix)) ** 3 + 1e-300
    np.testing.assert_allclose(
        determinant(matrix), np.linalg.det(matrix_of(matrix)), atol=10.0 * size
    )


@settings(max_examples=50, deadline=None)
@given(seeds, st.floats(1e-4, 0.2))
def test_bounds_hold_for_all_bodies_within_the_widths(seed: int, width: float) -> None:
    generator = random.Random(seed)
    body = random_body(generator, "block")
    half = MassDistribution(
        width * body.mass,
        tuple(width * abs(c) for c in body.com),
        tuple(width * abs(m) for m in body.moments),
    )
    axis = np.array([generator.gauss(0.0, 1.0) for _ in range(3)])
    axis /= sqrt(axis @ axis)
    slack = 1e-12 * sum(map(abs, body.moments))
    for _ in range(40):
        near = MassDistribution(
            body.mass + generator.choice((-1, 1)) * half.mass,
            tuple(c + generator.uniform(-h, h) for c, h in zip(body.com, half.com, strict=True)),
            tuple(
                m + generator.choice((-1, 1)) * h
                for m, h in zip(body.moments, half.moments, strict=True)
            ),
        )
        second = axis @ matrix_of(second_moments_about_com(near)) @ axis
        moment = axis @ inertia_tensor_about_com(near) @ axis
        assert second <= greatest_second_moment(body, half, tuple(axis)) + slack
        assert moment <= greatest_moment(body, half, tuple(axis)) + slack


def test_density_of_a_homogeneous_ellipsoid_is_its_own() -> None:
    mass, axes = 3.0, (0.1, 0.2, 0.3)
    volume = 4.0 / 3.0 * np.pi * np.prod(axes)
    second_moments = tuple(mass * a * a / 5.0 for a in axes)
    np.testing.assert_allclose(equivalent_density(mass, second_moments), mass / volume)


@settings(max_examples=200, deadline=None, derandomize=True)
@given(
    seeds, shapes, st.tuples(*[st.floats(-4.0, 4.0)] * 3), st.tuples(*[st.floats(-2.0, 2.0)] * 3)
)
def test_a_body_moves_as_in_batches(
    seed: int, shape: str, angles: Vector3, translation: Vector3
) -> None:
    body, pose = random_body(random.Random(seed), shape), pose_from(translation, angles)
    moved = seen_from(body, pose)
    R, r = np.array(pose.rotation), np.array(pose.translation)
    com, inertia = move_inertia(np.array(body.mass), np.array(body.com), _tensor(body), R, r)
    size = max(map(abs, moved.moments))
    assert moved.mass == body.mass
    np.testing.assert_allclose(moved.com, com, rtol=0, atol=1e-14 * (1.0 + sqrt(r @ r)))
    np.testing.assert_allclose(_tensor(moved), inertia, rtol=0, atol=1e-13 * size)
    back = seen_from(moved, pose.inverse())
    np.testing.assert_allclose(back.moments, body.moments, rtol=0, atol=1e-12 * size)


def _tensor(body: MassDistribution) -> np.ndarray:
    ix, iy, iz, ixy, ixz, iyz = body.moments
    return np.array([[ix, -ixy, -ixz], [-ixy, iy, -iyz], [-ixz, -iyz, iz]])
