"""The mathematics of rigid bodies, against NumPy and against its own definitions."""

import random
from collections.abc import Iterator
from itertools import product
from math import sqrt

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.support.bodies import SHAPES, random_body

import kindsl.mechanics.rigid.body as body_module
from kindsl.mechanics.rigid.body import (
    NO_BODY,
    MassDistribution,
    Symmetric,
    determinant,
    eigensystem,
    equivalent_box,
    greatest_moment,
    greatest_second_moment,
    is_clearly_positive,
    moments_of,
    principal_moments,
    second_moments_about_com,
    seen_from,
    shifted,
)
from kindsl.mechanics.rigid.pose import Vector3, pose_from
from kindsl.mechanics.spatial.inertia import move_inertia


def test_nothing_known_is_nothing_wherever_it_is() -> None:
    moved = seen_from(NO_BODY, pose_from((0.3, -0.2, 0.1), (0.4, 0.5, 0.6)))
    assert not any((moved.mass, *moved.moments, *NO_BODY.com))


def test_nothing_at_all_is_not_positive() -> None:
    assert not is_clearly_positive((0.0, 0.0, 0.0, 0.0, 0.0, 0.0))


@pytest.mark.parametrize(
    "turned", [(-1.0, -2.0, 3.0), (-1.0, 2.0, -3.0), (0.0, 0.0, -1.0), (1.0, 2.0, -3e-9)]
)
def test_a_negative_direction_is_not_positive(turned: Vector3) -> None:
    assert not is_clearly_positive((*turned, 0.0, 0.0, 0.0))


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


@pytest.mark.parametrize("diagonal", [(3.0, 1.0, 2.0), (1.0, 1.0, 1.0), (0.0, 0.0, 0.0)])
def test_what_is_diagonal_is_not_turned(diagonal: Vector3, monkeypatch: pytest.MonkeyPatch) -> None:
    turns: list[object] = []
    monkeypatch.setattr(body_module, "_rotate", lambda *given: turns.append(given))
    pairs = eigensystem((*diagonal, 0.0, 0.0, 0.0))
    assert [pair.value for pair in pairs] == sorted(diagonal)
    assert not turns


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


@settings(max_examples=60, deadline=None, derandomize=True)
@given(
    st.tuples(*[st.floats(1.0, 100.0)] * 3),
    st.tuples(*[st.floats(-0.45, 0.45)] * 3),
    st.integers(-60, 60),
    st.integers(0, 2),
)
def test_what_is_clearly_positive_is_so_in_any_unit(
    diagonal: Vector3, shares: Vector3, power: int, place: int
) -> None:
    x, y, z = np.sqrt(diagonal)
    products = (shares[0] * x * y, shares[1] * x * z, shares[2] * y * z)
    matrix = np.array([*diagonal, *products]) * 2.0**power
    assert is_clearly_positive(tuple(matrix))
    matrix[place] *= -1.0
    assert not is_clearly_positive(tuple(matrix))


@settings(max_examples=60, deadline=None, derandomize=True)
@given(st.floats(0.6, 20.0), st.tuples(*[st.sampled_from((-1.0, 1.0))] * 3), st.floats(0.1, 10.0))
def test_two_negative_directions_are_not_positive(
    share: float, signs: Vector3, size: float
) -> None:
    """With ones on the diagonal and the determinant positive, as an even count of them makes it."""
    a, b, c = signs
    between = (1.0 + share) * size
    matrix = (size, size, size, a * b * between, a * c * between, b * c * between)
    assert determinant(matrix) > 0.0
    assert sum(value < 0.0 for value in np.linalg.eigvalsh(matrix_of(matrix))) == 2
    assert not is_clearly_positive(matrix)


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


@settings(max_examples=40, deadline=None, derandomize=True)
@given(seeds, st.floats(0.0, 0.5), st.integers(0, 2), st.sampled_from((-1.0, 1.0)))
def test_bounds_are_met_by_one_of_the_bodies(
    seed: int, width: float, place: int, side: float
) -> None:
    """With the CoM on the axis or square to it nothing is given away."""
    body = random_body(random.Random(seed), "block")
    distance = 0.3 + abs(body.com[0])
    com = distance * side * np.eye(3)[place]
    body = MassDistribution(body.mass, tuple(com), body.moments)
    half = MassDistribution(
        width * body.mass, tuple(width * abs(com)), tuple(width * abs(m) for m in body.moments)
    )
    for direction in range(3):
        axis = np.eye(3)[direction]
        seconds, moments = zip(*(_about(near, axis) for near in _extremes(body, half)), strict=True)
        slack = 1e-12 * (1.0 + sum(map(abs, body.moments)))
        assert abs(max(seconds) - greatest_second_moment(body, half, tuple(axis))) <= slack
        assert abs(max(moments) - greatest_moment(body, half, tuple(axis))) <= slack


def _extremes(body: MassDistribution, half: MassDistribution) -> Iterator[MassDistribution]:
    """Yield bodies whose numbers are as far from the written ones as they may be."""
    numbers = np.array([body.mass, *body.com, *body.moments])
    widths = np.array([half.mass, *half.com, *half.moments])
    for signs in product((-1.0, 1.0), repeat=5):
        on_com, on_mass, *on_moments = signs
        chosen = np.array([on_mass, *(on_com * np.sign(body.com)), *on_moments, 0.0, 0.0, 0.0])
        mass, x, y, z, *moments = numbers + chosen * widths
        yield MassDistribution(mass, (x, y, z), tuple(moments))


def _about(body: MassDistribution, axis: np.ndarray) -> tuple[float, float]:
    """Return the second moment along an axis and the moment about it, both about the CoM."""
    second = matrix_of(second_moments_about_com(body))
    return axis @ second @ axis, axis @ inertia_tensor_about_com(body) @ axis


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


def test_a_box_is_told_by_its_inertia():
    sides, mass = (0.03, 0.04, 0.3), 1.5
    x, y, z = (mass * side * side / 12 for side in sides)
    box = MassDistribution(mass, (0.1, -0.2, 0.3), (y + z, x + z, x + y, 0.0, 0.0, 0.0))
    found = equivalent_box(shifted(box))
    assert found is not None
    assert found[0] == pytest.approx(sides)
    assert found[1] == pytest.approx(mass / (0.03 * 0.04 * 0.3))


@pytest.mark.parametrize(
    "body",
    [
        MassDistribution(1.0, (0.0, 0.0, 0.0), (1.0, 1.0, 2.1, 0.0, 0.0, 0.0)),  # impossible
        MassDistribution(1.0, (0.0, 0.0, 0.0), (1.0, 1.0, 2.0, 0.0, 0.0, 0.0)),  # flat
        NO_BODY,
    ],
)
def test_what_is_impossible_or_flat_is_like_no_box(body):
    assert equivalent_box(body) is None
