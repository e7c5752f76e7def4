"""Bodies are taken for matter from ten to thirty thousand kg/m³, however they lie."""

from math import inf, pi

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from tests.support.bodies import document_of_bodies

from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.diagnosis.judgements import is_placeholder
from kindsl.mechanics.rigid.body import (
    MassDistribution,
    eigensystem,
    moments_of,
    second_moments_about_com,
    seen_from,
)
from kindsl.mechanics.rigid.matter import density_of, is_dense_as_matter, is_plainly_dense_as_matter
from kindsl.mechanics.rigid.pose import Vector3, pose_from

SECTION = "inertia_params {{ mass = {:.17f} CoM = ({:.17f}, {:.17f}, {:.17f}) {} }}"
NAMES = ("Ix", "Iy", "Iz", "Ixy", "Ixz", "Iyz")
steady = settings(max_examples=60, deadline=None, derandomize=True)
densities = st.floats(0.0, 6.0).map(lambda power: 10.0**power)
semi_axes = st.tuples(*[st.floats(0.05, 0.4)] * 3)
turns = st.tuples(*[st.floats(-3.0, 3.0)] * 3)
places = st.tuples(*[st.floats(-0.2, 0.2)] * 3)


def ellipsoid(density: float, axes: Vector3, turned: Vector3, place: Vector3) -> MassDistribution:
    """A homogeneous ellipsoid, turned and put somewhere."""
    a, b, c = axes
    mass = density * 4.0 / 3.0 * pi * a * b * c
    second = (mass * a * a / 5.0, mass * b * b / 5.0, mass * c * c / 5.0, 0.0, 0.0, 0.0)
    return seen_from(
        MassDistribution(mass, (0.0, 0.0, 0.0), moments_of(second)), pose_from(place, turned)
    )


@steady
@given(densities, semi_axes, turns, places)
def test_the_density_of_an_ellipsoid_is_judged(
    density: float, axes: Vector3, turned: Vector3, place: Vector3
) -> None:
    assume(all(abs(density / edge - 1.0) > 1e-6 for edge in (10.0, 30_000.0)))
    body = ellipsoid(density, axes, turned, place)
    second = second_moments_about_com(body)
    pairs = eigensystem(second)
    assert abs(density_of(body.mass, pairs) / density - 1.0) < 1e-6
    expected = 10.0 < density < 30_000.0
    assert is_dense_as_matter(body.mass, pairs) == expected
    assert is_plainly_dense_as_matter(body.mass, second) == expected


@steady
@given(densities, semi_axes, turns, places)
def test_what_is_no_matter_is_reported_and_nothing_else(
    density: float, axes: Vector3, turned: Vector3, place: Vector3
) -> None:
    assume(all(abs(density / edge - 1.0) > 1e-3 for edge in (10.0, 30_000.0)))
    body = ellipsoid(density, axes, turned, place)
    moments = " ".join(f"{n} = {v:.17f}" for n, v in zip(NAMES, body.moments, strict=True))
    found = analyse(document_of_bodies([SECTION.format(body.mass, *body.com, moments)])).findings
    # With a cause the density is its evidence.
    is_reported = any(f.code in ("KD308", "KD310", "KD311", "KD314") for f in found)
    assert is_reported == (not 10.0 < density < 30_000.0)


@pytest.mark.parametrize(
    ("density", "expected"), [(9.99, False), (10.01, True), (29_990.0, True), (30_010.0, False)]
)
def test_matter_ends_at_foam_and_at_the_heaviest_metal(density: float, expected: bool) -> None:
    body = ellipsoid(density, (0.1, 0.2, 0.3), (0.3, 0.2, 0.1), (0.1, 0.0, 0.0))
    second = second_moments_about_com(body)
    assert is_dense_as_matter(body.mass, eigensystem(second)) == expected
    assert is_plainly_dense_as_matter(body.mass, second) == expected


@pytest.mark.parametrize("value", [0.0, -0.1])
def test_what_has_no_extent_is_dense_without_bound(value: float) -> None:
    pairs = eigensystem((value, value, value, 0.0, 0.0, 0.0))
    assert density_of(1.0, pairs) == inf
    assert not is_dense_as_matter(1.0, pairs)


@steady
@given(st.integers(0, 3), st.sampled_from((0.5, 2.0, -1.0)))
def test_a_placeholder_has_ones_throughout(place: int, other: float) -> None:
    numbers = [1.0] * 4
    ones = MassDistribution(1.0, (0.0, 0.0, 0.0), (1.0, 1.0, 1.0, 0.0, 0.0, 0.0))
    assert is_placeholder(ones)
    numbers[place] = other
    mass, ix, iy, iz = numbers
    assert not is_placeholder(MassDistribution(mass, (0.0, 0.0, 0.0), (ix, iy, iz, 0.0, 0.0, 0.0)))
