"""The density of a body's equivalent ellipsoid."""

from math import inf

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from kindsl.mechanics.rigid.body import Eigenpair
from kindsl.mechanics.rigid.matter import density_of
from kindsl.mechanics.rigid.pose import Vector3


def density(mass: float, values: Vector3) -> float:
    a, b, c = (Eigenpair(value, (0.0, 0.0, 1.0)) for value in values)
    return density_of(mass, (a, b, c))


@settings(max_examples=40, deadline=None, derandomize=True)
@given(st.floats(0.5, 9.0), st.floats(0.01, 4.0), st.floats(0.0, 1.0), st.floats(0.0, 1.0))
def test_thin_bodies_are_as_dense_as_if_they_were_a_tenth_as_thick_as_long(
    mass: float, length: float, one: float, other: float
) -> None:
    thick = 0.01 * length
    expected = density(mass, (thick, thick, length))
    thin = density(mass, (min(one, other) * thick, max(one, other) * thick, length))
    np.testing.assert_allclose(thin, expected)
    assert density(mass, (thick, 4.0 * thick, length)) < 0.6 * expected


def test_a_body_without_extent_is_dense_without_bound() -> None:
    assert density(1.0, (0.0, 0.0, 0.0)) == inf


def test_density_of_a_homogeneous_ellipsoid_is_its_own() -> None:
    mass, axes = 3.0, (0.1, 0.2, 0.3)
    volume = 4.0 / 3.0 * np.pi * np.prod(axes)
    second_moments = tuple(mass * a * a / 5.0 for a in axes)
    np.testing.assert_allclose(density(mass, second_moments), mass / volume)
