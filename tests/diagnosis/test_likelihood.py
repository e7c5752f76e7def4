"""How likely second moments are: each part of the prior by its formula, at shapes of one's own."""

from math import exp, inf, log, pi, sqrt

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kindsl.judgement.diagnosis.likelihood import (
    MassShape,
    density,
    log_likelihood,
    shape_of,
    vanishing_products,
)
from kindsl.mechanics.rigid.body import (
    MassDistribution,
    Symmetric,
    eigensystem,
    second_moments_about_com,
)

steady = settings(max_examples=60, deadline=None, derandomize=True)
EXACT: Symmetric = (0.0,) * 6  # type: ignore[assignment]
numbers = st.floats(-2.0, 2.0)
halves = st.floats(0.0, 0.5)
WORTHLESS = log(1e-9)


def shape(*matrix: float, errors: Symmetric = EXACT) -> MassShape:
    return MassShape(matrix, errors, eigensystem(matrix))  # type: ignore[arg-type]


def log_normal(z: float, spread: float) -> float:
    """Nineteen in twenty log-normal; the others spread over ten units, falling off slowly."""
    return log(0.95 / (spread * sqrt(2.0 * pi)) * exp(-z * z / 2.0) + 0.005 * exp(-z * z / 20.0))


def mass_of(density: float, *values: float) -> float:
    """Return the mass of an ellipsoid with these second moments: `m^5 = (4/3 pi d)^2 125 s1 s2 s3`.

    It has the semi-axes `sqrt(5 s / m)`.
    """
    a, b, c = values
    return ((4.0 / 3.0 * pi * density) ** 2 * 125.0 * a * b * c) ** 0.2


OBLONG = shape(0.2, 0.5, 1.0, 0.0, 0.0, 0.0)


@pytest.mark.parametrize(
    ("wanted", "z"),
    [
        (1500.0, 0.0),
        (1500.0 * exp(1.2), 1.0),
        (1500.0 * exp(-1.2), -1.0),
        (1500.0 * exp(2.4), 2.0),
        (1500.0 * exp(-4.8), -4.0),
        (1500.0 * exp(12.0), 10.0),
    ],
)
def test_density_is_log_normal_around_that_of_plastic_and_light_metal(
    wanted: float, z: float
) -> None:
    mass, usual = mass_of(wanted, 0.2, 0.5, 1.0), mass_of(1500.0, 0.2, 0.5, 1.0)
    assert density(mass, OBLONG) == pytest.approx(wanted)
    told = log_likelihood(mass, OBLONG, 0.0) - log_likelihood(usual, OBLONG, 0.0)
    assert told == pytest.approx(log_normal(z, 1.2) - log_normal(0.0, 1.2), abs=1e-9)


@pytest.mark.parametrize("z", [0.0, 1.0, -1.0, 2.0, -4.0, 8.0])
def test_a_link_reaches_about_twice_its_radius_of_gyration(z: float) -> None:
    """The radius squared is the sum of the second moments by the mass: here 1.7 by 10."""
    reach = sqrt(1.7 / 10.0) / (0.5 * exp(z))
    told = log_likelihood(10.0, OBLONG, reach) - log_likelihood(10.0, OBLONG, 0.0)
    assert told == pytest.approx(log_normal(z, 1.0), abs=1e-9)


@pytest.mark.parametrize("mass", [1e-300, 1e300])
def test_a_density_beyond_all_floats_is_worth_next_to_nothing(mass: float) -> None:
    usual = mass_of(1500.0, 0.2, 0.5, 1.0)
    assert density(mass, OBLONG) in (0.0, inf)
    told = log_likelihood(mass, OBLONG, 0.0) - log_likelihood(usual, OBLONG, 0.0)
    assert told == pytest.approx(WORTHLESS - log_normal(0.0, 1.2))


def of_orientation(of: MassShape) -> float:
    """Return what is left of the likelihood besides density and the volume of the eigenvalues."""
    values = [max(pair.value, max(of.errors[:3])) for pair in of.pairs]
    mass = mass_of(1500.0, *values)
    return (
        log_likelihood(mass, of, 0.0)
        - log_normal(0.0, 1.2)
        + log(values[0] * values[1] * values[2])
    )


def mixed(aligned: float, turned: float, tilted: float, anyhow: float) -> float:
    return log(0.35 * aligned + 0.15 * turned + 0.25 * tilted + 0.25 * anyhow)


def tilted(*products_by_gaps: tuple[float, float]) -> float:
    """A sixth of three normal densities, each a fifth of a gap wide."""
    density = 1.0 / 6.0
    for product, gap in products_by_gaps:
        width = 0.2 * gap
        density *= exp(-0.5 * (product / width) ** 2) / (width * sqrt(2.0 * pi))
    return density


def test_along_the_axes_all_four_ways_to_lie_count() -> None:
    """Zeros are as wide as a thousandth of the greatest second moment to either side."""
    turned = sum(1.0 / (9.0 * 0.002**2 * pi / 2.0 * gap) for gap in (0.3, 0.8, 0.5))
    expected = mixed(
        aligned=1.0 / (6.0 * 0.002**3),
        turned=turned,
        tilted=tilted((0.0, 0.3), (0.0, 0.8), (0.0, 0.5)),
        anyhow=1.0 / (0.3 * 0.8 * 0.5 * 2.0 * pi**2),
    )
    assert of_orientation(OBLONG) == pytest.approx(expected, abs=1e-12)


@pytest.mark.parametrize(("place", "gap"), [(3, 0.3), (4, 0.8), (5, 0.5)])
def test_with_one_product_a_body_is_not_aligned(place: int, gap: float) -> None:
    """One product is turned about one axis; the eigenvalues of its 2x2 block move apart."""
    matrix = [0.2, 0.5, 1.0, 0.0, 0.0, 0.0]
    matrix[place] = 0.25 * gap
    of = shape(*matrix)
    a, b, c = (pair.value for pair in of.pairs)
    gaps = {3: 0.3, 4: 0.8, 5: 0.5}
    expected = mixed(
        aligned=0.0,
        turned=1.0 / (9.0 * (0.002 * c) ** 2 * pi / 2.0 * gap),
        tilted=tilted(*((matrix[k], g) for k, g in gaps.items())),
        anyhow=1.0 / ((b - a) * (c - b) * (c - a) * 2.0 * pi**2),
    )
    assert of_orientation(of) == pytest.approx(expected, abs=1e-9)


@pytest.mark.parametrize("zero", [3, 4, 5])
def test_with_two_products_a_body_is_tilted_or_lies_anyhow(zero: int) -> None:
    gaps = {3: 0.3, 4: 0.8, 5: 0.5}
    matrix = [0.2, 0.5, 1.0, 0.06, -0.1, 0.08]
    matrix[zero] = 0.0
    of = shape(*matrix)
    a, b, c = (pair.value for pair in of.pairs)
    expected = mixed(
        aligned=0.0,
        turned=0.0,
        tilted=tilted(*((matrix[k], g) for k, g in gaps.items())),
        anyhow=1.0 / ((b - a) * (c - b) * (c - a) * 2.0 * pi**2),
    )
    assert of_orientation(of) == pytest.approx(expected, abs=1e-9)


def test_products_far_beyond_the_gaps_leave_only_anyhow() -> None:
    """Equal on the diagonal: each gap is a fiftieth of the greatest second moment."""
    of = shape(1.0, 1.0, 1.0, 0.3, 0.3, 0.2)
    a, b, c = (pair.value for pair in of.pairs)
    least = 0.02 * c
    expected = mixed(0.0, 0.0, 0.0, 1.0 / (max(b - a, least) * (c - b) * (c - a) * 2.0 * pi**2))
    assert of_orientation(of) == pytest.approx(expected, abs=1e-9)


@pytest.mark.parametrize(
    ("product", "error", "width"),
    [
        (0.0, 0.6, 0.002),  # zero whatever is true: how exactly it is known says nothing
        (0.0009, 0.0001, 0.002),
        (0.015, 0.01, 0.04),
        (-0.02, 0.01, 0.04),
        (-0.0201, 0.01, None),
        (0.0011, 0.0001, None),
    ],
)
@pytest.mark.parametrize("place", [3, 4, 5])
def test_a_product_is_zero_within_twice_its_error(
    place: int, product: float, error: float, width: float | None
) -> None:
    """The other two products are zero, so that what this one is decides about an aligned body."""
    matrix, errors = [0.2, 0.5, 1.0, 0.0, 0.0, 0.0], [0.0] * 6
    matrix[place], errors[place] = product, error
    of = shape(*matrix, errors=tuple(errors))  # type: ignore[arg-type]
    gap = (0.3, 0.8, 0.5)[place - 3]
    own = 1.0 / (9.0 * 0.002**2 * pi / 2.0 * gap)
    expected = 0.15 * own
    if width is not None:
        others = [g for g in (0.3, 0.8, 0.5) if g != gap]
        expected += 0.35 / (6.0 * 0.002**2 * width)
        expected += sum(0.15 / (9.0 * 0.002 * width * pi / 2.0 * g) for g in others)
    found = exp(of_orientation(of))
    assert found == pytest.approx(expected, rel=1e-2)


@pytest.mark.parametrize(("error", "least"), [(0.0, 0.02), (0.1, 0.1)])
def test_nearly_equal_moments_are_told_apart_no_finer_than_their_digits(
    error: float, least: float
) -> None:
    """Second moments of 0.5, 0.501 and 1: of the two gaps only that to the last is told."""
    of = shape(0.5, 0.501, 1.0, 0.0, 0.0, 0.0, errors=(error, error / 2.0, 0.0, 0.0, 0.0, 0.0))
    turned = sum(1.0 / (9.0 * 0.002**2 * pi / 2.0 * gap) for gap in (least, 0.5, 0.499))
    expected = mixed(
        aligned=1.0 / (6.0 * 0.002**3),
        turned=turned,
        tilted=tilted((0.0, least), (0.0, 0.5), (0.0, 0.499)),
        anyhow=1.0 / (least * 0.5 * 0.499 * 2.0 * pi**2),
    )
    assert of_orientation(of) == pytest.approx(expected, abs=1e-9)


def test_gaps_between_eigenvalues_have_a_least_width_each() -> None:
    """Around 45 degrees the diagonal is equal; `a`, `b` and `c` are told apart by the least gap."""
    for values in ((0.5, 0.5, 1.0), (0.5, 1.0, 1.0), (1.0, 1.0, 1.0)):
        a, b, c = values
        of = shape(*values, 0.0, 0.0, 0.0, errors=(0.0, 0.0, 0.3, 0.0, 0.0, 0.0))
        gaps = [max(abs(x - y), 0.3) for x, y in ((a, b), (a, c), (b, c))]
        expected = mixed(
            aligned=1.0 / (6.0 * 0.002**3),
            turned=sum(1.0 / (9.0 * 0.002**2 * pi / 2.0 * gap) for gap in gaps),
            tilted=tilted(*((0.0, gap) for gap in gaps)),
            anyhow=1.0 / (gaps[0] * gaps[1] * gaps[2] * 2.0 * pi**2),
        )
        assert of_orientation(of) == pytest.approx(expected, abs=1e-9)


@pytest.mark.parametrize(
    ("smallest", "error", "is_thin"),
    [(0.0001, 0.0002, True), (0.0002, 0.0002, True), (0.0003, 0.0002, False)],
)
def test_what_may_be_thinner_than_it_seems_is_not_too_light(
    smallest: float, error: float, is_thin: bool
) -> None:
    """Seemingly 500 kg/m3: a plate that thin may be three times as dense.

    How exactly its products are known says nothing of that.
    """
    values = (max(smallest, error), 0.5, 1.0)
    of = shape(smallest, 0.5, 1.0, 0.0, 0.0, 0.0, errors=(error, 0.0, 0.0, 0.3, 0.0, 0.0))
    light, usual = (mass_of(wanted, *values) for wanted in (500.0, 1500.0))
    assert density(light, of) == pytest.approx(500.0)
    told = log_likelihood(light, of, 0.0) - log_likelihood(usual, of, 0.0)
    z = 0.0 if is_thin else log(1.0 / 3.0) / 1.2
    assert told == pytest.approx(log_normal(z, 1.2) - log_normal(0.0, 1.2), abs=1e-9)


def test_what_is_thin_and_seems_too_heavy_is() -> None:
    of = shape(0.0, 0.5, 1.0, 0.0, 0.0, 0.0, errors=(0.0, 0.0, 0.0001, 0.0, 0.0, 0.0))
    heavy, usual = (mass_of(wanted, 0.0001, 0.5, 1.0) for wanted in (15_000.0, 1500.0))
    told = log_likelihood(heavy, of, 0.0) - log_likelihood(usual, of, 0.0)
    expected = log_normal(log(10.0) / 1.2, 1.2) - log_normal(0.0, 1.2)
    assert told == pytest.approx(expected, abs=1e-9)


def test_a_point_is_taken_to_have_next_to_no_extent() -> None:
    """Of 1e-30 kg·m²; of four times that everything that has its unit is four times as wide."""
    point, larger = shape(*EXACT), shape(4e-30, 4e-30, 4e-30, 0.0, 0.0, 0.0)
    assert density(1.0, point) == pytest.approx(1.0 / (4.0 / 3.0 * pi * 5e-30**1.5))
    assert density(1.0, larger) == pytest.approx(density(1.0, point) / 8.0)
    z, other = (log(density(1.0, of) / 1500.0) / 1.2 for of in (point, larger))
    told = log_likelihood(1.0, larger, 0.0) - log_likelihood(1.0, point, 0.0)
    expected = log_normal(other, 1.2) - log_normal(z, 1.2) - 6.0 * log(4.0)
    assert told == pytest.approx(expected, abs=1e-9)


@pytest.mark.parametrize(
    "of",
    [
        OBLONG,
        shape(0.5, 0.501, 1.0, 0.0, 0.0, 0.0),
        shape(1.0, 1.0, 1.0, 0.3, 0.3, 0.2),
        shape(0.2, 0.5, 1.0, 0.06, -0.1, 0.0, errors=(0.1, 0.1, 0.1, 0.04, 0.04, 0.04)),
    ],
)
def test_the_unit_does_not_matter(of: MassShape) -> None:
    """A density over three products and three differences, less those of the eigenvalues."""
    matrix, errors = (tuple(4.0 * entry for entry in group) for group in (of.matrix, of.errors))
    fourfold = shape(*matrix, errors=errors)  # type: ignore[arg-type]
    assert of_orientation(fourfold) == pytest.approx(of_orientation(of) - 3.0 * log(4.0), abs=1e-9)


@pytest.mark.parametrize(
    ("products", "vanishing"),
    [
        ((0.0, 0.0, 0.0), (True, True, True)),
        ((0.002, -0.004, 0.006), (True, True, True)),
        ((0.0021, -0.004, 0.006), (False, True, True)),
        ((0.002, -0.0041, 0.006), (True, False, True)),
        ((0.002, -0.004, 0.0061), (True, True, False)),
    ],
)
def test_products_vanish_within_twice_their_errors(
    products: tuple[float, float, float], vanishing: tuple[bool, bool, bool]
) -> None:
    errors = (0.5, 0.5, 0.5, 0.001, 0.002, 0.003)
    assert vanishing_products(shape(1.0, 1.0, 1.0, *products, errors=errors)) == vanishing


@steady
@given(
    st.floats(0.5, 3.0),
    st.tuples(numbers, numbers, numbers),
    st.tuples(*[numbers] * 6),
    st.lists(halves, min_size=10, max_size=10),
)
def test_errors_are_those_of_the_numbers_written_to_first_order(
    mass: float, com: tuple[float, ...], moments: tuple[float, ...], half: list[float]
) -> None:
    """Second moments are quadratic in each number: a difference of two is their exact slope."""
    tall = tuple(moment + 50.0 for moment in moments[:3])
    ten = [mass, *com, *tall, *moments[3:]]
    found = shape_of(as_body(ten), as_body(half))
    assert found is not None
    assert found.matrix == second_moments_about_com(as_body(ten))
    assert found.pairs == eigensystem(found.matrix)
    for place in range(6):
        expected = sum(abs(slope(ten, n, place)) * half[n] for n in range(10))
        assert found.errors[place] == pytest.approx(expected, abs=1e-8)


def slope(ten: list[float], number: int, place: int) -> float:
    high, low = ([*ten], [*ten])
    high[number] += 0.5
    low[number] -= 0.5
    both = (second_moments_about_com(as_body(numbers))[place] for numbers in (high, low))
    return next(both) - next(both)


def as_body(ten: list[float]) -> MassDistribution:
    mass, x, y, z, *moments = ten
    return MassDistribution(mass, (x, y, z), tuple(moments))  # type: ignore[arg-type]


def test_exact_numbers_are_known_but_for_the_rounding_of_arithmetic() -> None:
    """The sum of `|Ix| ... |Iyz|` is 60, `m c.c` is `0.5 (1 + 4 + 9) = 7`."""
    body = MassDistribution(0.5, (1.0, -2.0, 3.0), (20.0, 18.0, 19.0, 1.0, -1.0, 1.0))
    found = shape_of(body, MassDistribution(0.0, (0.0, 0.0, 0.0), EXACT))
    assert found is not None
    assert found.errors == pytest.approx((67e-12,) * 6, rel=1e-9)


@pytest.mark.parametrize("place", [0, 1, 2])
@pytest.mark.parametrize(("value", "is_shape"), [(-0.29, True), (-0.31, False)])
def test_a_body_negative_beyond_its_digits_has_no_shape(
    place: int, value: float, is_shape: bool
) -> None:
    """Each moment known to 0.2: each second moment to `(0.2 + 0.2 + 0.2) / 2`."""
    second = [1.0, 1.0, 1.0]
    second[place] = value
    xx, yy, zz = second
    body = MassDistribution(1.0, (0.0, 0.0, 0.0), (yy + zz, xx + zz, xx + yy, -5.0, 0.0, 0.0))
    half = MassDistribution(0.0, (0.0, 0.0, 0.0), (0.2, 0.2, 0.2, 0.0, 0.0, 0.0))
    assert (shape_of(body, half) is not None) == is_shape


def test_a_point_known_exactly_has_a_shape() -> None:
    nothing = MassDistribution(0.0, (0.0, 0.0, 0.0), EXACT)
    assert shape_of(nothing._replace(mass=1.0), nothing) is not None
