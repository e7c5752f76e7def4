"""The 6-D algebra keeps its laws."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.support.spatial import pseudo_inertia, rotation_from_intrinsic_xyz

from kindsl.mechanics.spatial.arrays import Array
from kindsl.mechanics.spatial.cross_products import cross, force_cross, motion_cross, skew
from kindsl.mechanics.spatial.inertia import (
    move_inertia,
    point_inertia,
    second_moment,
    spatial_inertia,
)
from kindsl.mechanics.spatial.transforms import homogeneous, plucker, rotation_about_z

coordinates = st.floats(-3.0, 3.0, allow_subnormal=False)
vectors = st.lists(coordinates, min_size=3, max_size=3).map(np.array)
motions = st.lists(coordinates, min_size=6, max_size=6).map(np.array)
rotations = vectors.map(rotation_from_intrinsic_xyz)
few = settings(max_examples=60, deadline=None, derandomize=True)


def _about(axis: int, angle: float) -> Array:
    """Return the rotation by an angle about one axis, written out."""
    c, s = np.cos(angle), np.sin(angle)
    i, j = (axis + 1) % 3, (axis + 2) % 3
    R = np.eye(3)
    R[i, i] = R[j, j] = c
    R[i, j], R[j, i] = -s, s
    return R


def _cloud(seed: int) -> tuple[Array, Array]:
    generator = np.random.default_rng(seed)
    return generator.uniform(0.1, 2.0, 5), generator.uniform(-1.0, 1.0, (5, 3))


def _properties(masses: Array, points: Array) -> tuple[Array, Array, Array]:
    com = masses @ points / masses.sum()
    return np.asarray(masses.sum()), com, point_inertia(masses, points).sum(axis=0)


@few
@given(vectors, vectors)
def test_cross_products_are_numpys(a: Array, b: Array) -> None:
    assert cross(a, b) == pytest.approx(np.cross(a, b))
    assert skew(a) @ b == pytest.approx(np.cross(a, b))


@few
@given(motions, motions, motions)
def test_power_is_carried_along(v: Array, m: Array, f: Array) -> None:
    assert (motion_cross(v) @ m) @ f == pytest.approx(-m @ (force_cross(v) @ f), abs=1e-9)
    assert motion_cross(v) @ v == pytest.approx(np.zeros(6), abs=1e-9)


@few
@given(rotations, vectors, rotations, vectors)
def test_transforms_chain(A_R_B: Array, A_r_B: Array, B_R_C: Array, B_r_C: Array) -> None:
    A_T_C = homogeneous(A_R_B, A_r_B) @ homogeneous(B_R_C, B_r_C)
    C_X_A = plucker(B_R_C.T, B_r_C) @ plucker(A_R_B.T, A_r_B)
    assert pytest.approx(plucker(A_T_C[:3, :3].T, A_T_C[:3, 3]), abs=1e-9) == C_X_A


@few
@given(rotations, vectors, motions, motions)
def test_power_is_frame_independent(A_R_B: Array, A_r_B: Array, v: Array, f_B: Array) -> None:
    B_X_A = plucker(A_R_B.T, A_r_B)
    assert (B_X_A @ v) @ f_B == pytest.approx(v @ (B_X_A.T @ f_B), abs=1e-9)


@few
@given(vectors)
def test_intrinsic_rotations_follow_one_another(angles: Array) -> None:
    expected = _about(0, angles[0]) @ _about(1, angles[1]) @ _about(2, angles[2])
    R = rotation_from_intrinsic_xyz(angles)
    assert pytest.approx(expected) == R
    assert pytest.approx(np.eye(3)) == R @ R.T
    assert rotation_about_z(angles[2]) == pytest.approx(_about(2, angles[2]))


@few
@given(st.integers(0, 1000), rotations, vectors)
def test_inertia_moves_with_the_mass(seed: int, A_R_B: Array, A_r_B: Array) -> None:
    masses, points = _cloud(seed)
    mass, com, inertia = _properties(masses, points)
    _, moved_com, moved = _properties(masses, points @ A_R_B.T + A_r_B)
    got_com, got = move_inertia(mass, com, inertia, A_R_B, A_r_B)
    assert got_com == pytest.approx(moved_com, abs=1e-9)
    assert got == pytest.approx(moved, abs=1e-8)
    A_X_B = plucker(A_R_B, -A_R_B.T @ A_r_B)
    B_X_A = np.linalg.inv(A_X_B)
    expected = B_X_A.T @ spatial_inertia(mass, com, inertia) @ B_X_A
    assert spatial_inertia(mass, got_com, got) == pytest.approx(expected, abs=1e-7)
    T = homogeneous(A_R_B, A_r_B)
    P = pseudo_inertia(mass, com, inertia)
    assert pseudo_inertia(mass, got_com, got) == pytest.approx(T @ P @ T.T, abs=1e-8)


@few
@given(st.integers(0, 1000), motions)
def test_kinetic_energy_is_that_of_the_points(seed: int, v: Array) -> None:
    masses, points = _cloud(seed)
    velocities = v[3:] + np.cross(v[:3], points)
    expected = 0.5 * masses @ (velocities**2).sum(axis=1)
    assert 0.5 * v @ spatial_inertia(*_properties(masses, points)) @ v == pytest.approx(expected)


def test_second_moments_are_sums_over_points() -> None:
    masses, points = _cloud(0)
    _, _, inertia = _properties(masses, points)
    assert second_moment(inertia) == pytest.approx((points.T * masses) @ points)
    assert np.linalg.eigvalsh(pseudo_inertia(*_properties(masses, points))).min() > 0.0


def test_all_take_batches() -> None:
    generator = np.random.default_rng(0)
    angles, r, v = generator.normal(size=(2, 3, 3)), generator.normal(size=(3, 3)), np.ones((4, 6))
    R = rotation_from_intrinsic_xyz(angles)
    assert plucker(R, r).shape == (2, 3, 6, 6)
    assert homogeneous(R, r)[1, 2] == pytest.approx(homogeneous(R[1, 2], r[2]))
    assert plucker(R, r)[1, 2] == pytest.approx(plucker(R[1, 2], r[2]))
    assert motion_cross(v).shape == (4, 6, 6)
    assert rotation_about_z(angles[..., 0]).shape == (2, 3, 3, 3)
    inertia = np.broadcast_to(np.eye(3), (2, 3, 3))
    assert spatial_inertia(np.ones(2), r[:2], inertia).shape == (2, 6, 6)
    assert pseudo_inertia(np.ones(2), r[:2], inertia).shape == (2, 4, 4)


leading = st.sampled_from(((), (1,), (4,), (2, 1), (2, 4), (1, 1, 4)))


@few
@given(leading, leading)
def test_leading_dimensions_of_both_arguments_are_broadcast(
    of_turns: tuple[int, ...], of_places: tuple[int, ...]
) -> None:
    generator = np.random.default_rng(5)
    A_R_B = rotation_from_intrinsic_xyz(generator.normal(size=(*of_turns, 3)))
    A_r_B = generator.normal(size=(*of_places, 3))
    batch = np.broadcast_shapes(of_turns, of_places)
    turns, places = np.broadcast_to(A_R_B, (*batch, 3, 3)), np.broadcast_to(A_r_B, (*batch, 3))
    for made in (homogeneous, plucker):
        together = made(A_R_B, A_r_B)
        assert together.shape[:-2] == batch
        for index in np.ndindex(batch):
            alone = made(turns[index], places[index])
            np.testing.assert_allclose(together[index], alone, rtol=0.0, atol=1e-14)
