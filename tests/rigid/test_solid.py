"""The uniform solid of a body has its mass and inertia, and is a shape that one knows."""

import math
import random

import pytest

from kindsl.mechanics.rigid.body import MassDistribution
from kindsl.mechanics.rigid.pose import dot
from kindsl.mechanics.rigid.solid import equivalent_solid

SPHERE = (0.4, 0.4, 0.4)
DISC = (0.25, 0.25, 0.5)
ROD = (1.0, 1.0, 0.01)
BOX = (0.9, 0.7, 0.4)
PLATE = (1.0, 0.3, 0.72)


def body(moments, mass=2.0, com=(0.1, -0.2, 0.3)):
    """Return a body with principal moments about its centre of mass."""
    x, y, z = com
    ix, iy, iz = moments
    steiner = (y * y + z * z, x * x + z * z, x * x + y * y)
    shifted = [own + mass * more for own, more in zip((ix, iy, iz), steiner, strict=True)]
    return MassDistribution(mass, com, (*shifted, mass * x * y, mass * x * z, mass * y * z))


def sampled(solid, count=20_000):
    """Return the means of the squares along the axes, by points in its box."""
    rng, (e1, e2) = random.Random(1), solid.exponents
    inside, sums = 0, [0.0, 0.0, 0.0]
    for _ in range(count):
        x, y, z = (rng.uniform(-1.0, 1.0) for _ in range(3))
        ring = (abs(x) ** (2 / e2) + abs(y) ** (2 / e2)) ** (e2 / e1)
        if ring + abs(z) ** (2 / e1) <= 1.0:
            inside += 1
            sums = [s + v * v for s, v in zip(sums, (x, y, z), strict=True)]
    a, b, c = solid.semi_axes
    means = [s / inside * h * h for s, h in zip(sums, (a, b, c), strict=True)]
    return 8.0 * a * b * c * inside / count, means


@pytest.mark.parametrize("moments", [SPHERE, DISC, ROD, BOX, PLATE])
def test_a_solid_has_the_bodys_mass_and_second_moments(moments):
    solid = equivalent_solid(body(moments))
    volume, means = sampled(solid)
    assert solid.density * volume == pytest.approx(2.0, rel=0.03)
    half = 0.5 * sum(moments)
    for axis, mean in zip(solid.axes, means, strict=True):
        second = [half - moment for moment in moments]
        wanted = sum(s * n * n for s, n in zip(second, axis, strict=True))
        assert 2.0 * mean == pytest.approx(wanted, rel=0.03, abs=1e-4)


@pytest.mark.parametrize(
    ("moments", "exponents"), [(SPHERE, (1, 1)), (DISC, (0.12, 1)), (ROD, (0.12, 1))]
)
def test_equal_moments_make_round_shapes(moments, exponents):
    assert equivalent_solid(body(moments)).exponents == pytest.approx(exponents, abs=0.15)


@pytest.mark.parametrize("moments", [SPHERE, DISC, ROD, BOX, PLATE])
def test_no_point_of_the_surface_is_farther_than_the_support(moments):
    solid, rng = equivalent_solid(body(moments)), random.Random(2)
    directions = [tuple(rng.gauss(0, 1) for _ in range(3)) for _ in range(40)]
    points = [solid.support(n) for n in directions]
    for n, own in zip(directions, points, strict=True):
        assert dot(n, own) >= max(dot(n, other) for other in points) - 1e-9
        local = [p - c for p, c in zip(own, solid.center, strict=True)]
        x, y, z = (abs(dot(local, k)) / h for k, h in zip(solid.axes, solid.semi_axes, strict=True))
        e1, e2 = solid.exponents
        level = (x ** (2 / e2) + y ** (2 / e2)) ** (e2 / e1) + z ** (2 / e1)
        assert level == pytest.approx(1.0, abs=1e-6)


def test_what_is_no_body_says_so():
    wrong = equivalent_solid(body((1.0, 0.1, 0.1)))
    assert not wrong.is_possible
    assert math.isfinite(wrong.density)
    assert equivalent_solid(body((0.0, 0.0, 0.0), mass=0.0)) is None
    assert equivalent_solid(MassDistribution(1.0, (0.0, 0.0, 0.0), (0.0,) * 6)) is None


def test_a_rod_is_longest_along_itself():
    rod = equivalent_solid(body(ROD))
    _, along = max(zip(rod.semi_axes, rod.axes, strict=True))
    assert abs(along[2]) == pytest.approx(1.0)
    assert rod.reach == pytest.approx(math.sqrt(3 * 0.995 / 2.0), rel=0.01)
