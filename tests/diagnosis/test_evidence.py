"""What is looked up of a body, and how its axes lie: by formula, at shapes of one's own."""

from math import exp, log, pi, sqrt

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kindsl.judgement.diagnosis.evidence import (
    MassShape,
    density,
    of_anything,
    of_matter,
    of_spread,
    quantities_of,
    shape_of,
    vanishing_products,
    ways_to_lie,
)
from kindsl.judgement.diagnosis.fitted import LIES, TABLES, TRUST
from kindsl.judgement.diagnosis.tables import LikelihoodTable
from kindsl.mechanics.rigid.body import (
    MassDistribution,
    Symmetric,
    eigensystem,
    second_moments_about_com,
)
from kindsl.mechanics.rigid.pose import Vector3

steady = settings(max_examples=60, deadline=None, derandomize=True)
EXACT: Symmetric = (0.0,) * 6  # type: ignore[assignment]
numbers = st.floats(-2.0, 2.0)
halves = st.floats(0.0, 0.5)


def shape(*matrix: float, errors: Symmetric = EXACT) -> MassShape:
    return MassShape(matrix, errors, eigensystem(matrix))  # type: ignore[arg-type]


def mass_of(density: float, *values: float) -> float:
    """Return the mass of an ellipsoid with these second moments: `m^5 = (4/3 pi d)^2 125 s1 s2 s3`.

    It has the semi-axes `sqrt(5 s / m)`.
    """
    a, b, c = values
    return ((4.0 / 3.0 * pi * density) ** 2 * 125.0 * a * b * c) ** 0.2


def of_orientation(of: MassShape) -> float:
    """Return how likely a body lies so, if it lies each way as often as `mixed` says."""
    return log(sum(w * d for w, d in zip((0.35, 0.15, 0.25, 0.25), ways_to_lie(of), strict=True)))


OBLONG = shape(0.2, 0.5, 1.0, 0.0, 0.0, 0.0)


END = (0.3, 0.0, 0.4)


def looked_up(
    of: MassShape, mass: float = 10.0, com: Vector3 = (0.0, 0.0, 0.0), other: float = 0.0
) -> dict[str, float]:
    """Return what is looked up of a link that ends at half a metre."""
    return dict(quantities_of(MassDistribution(mass, com, EXACT), of, END, other))


def test_quantities_of_a_link_whose_end_is_known() -> None:
    """The radius of gyration squared is the sum of the second moments by the mass: 1.7 by 10."""
    found = looked_up(OBLONG, com=(0.15, 0.2, 0.0), other=5.0)
    assert {name: pytest.approx(value) for name, value in found.items()} == {
        "density": log(density(10.0, OBLONG)),
        "thickness": log(0.2),
        "width": log(0.5),
        "mass": log(2.0),
        "gyration": log(sqrt(0.17)),
        "distance": log(0.25),
        "size": log(sqrt(0.17) / 0.5),
        "reach": log(0.5),
        "place": log(0.25 / sqrt((0.36 * 0.2 + 0.64 * 0.5) / 10.0)),
        "side": 0.15 * 0.3 / (0.25 * 0.5),
    }
    assert set(found) | {"direction"} == set(TABLES)


def test_without_an_end_the_place_is_told_by_the_extent_along_it() -> None:
    body = MassDistribution(10.0, (0.0, 0.3, 0.0), EXACT)
    found = dict(quantities_of(body, OBLONG, None, 0.0))
    assert found["place"] == pytest.approx(log(0.3 / sqrt(0.05)))
    assert {"size", "reach", "side", "mass"}.isdisjoint(found)


@pytest.mark.parametrize(("long", "cosine"), [(2.4, None), (2.6, 0.8)])
def test_a_long_body_has_a_direction(long: float, cosine: float | None) -> None:
    assert looked_up(shape(0.2, 1.0, long, 0.0, 0.0, 0.0)).get("direction") == (
        None if cosine is None else pytest.approx(cosine)
    )


@pytest.mark.parametrize(
    ("smallest", "error", "told"),
    [(0.0001, 0.0002, 1500.0), (0.0002, 0.0002, 1500.0), (0.0003, 0.0002, 500.0)],
)
def test_what_may_be_thinner_than_it_seems_is_not_too_light(
    smallest: float, error: float, told: float
) -> None:
    values = (max(smallest, error), 0.5, 1.0)
    of = shape(smallest, 0.5, 1.0, 0.0, 0.0, 0.0, errors=(error, 0.0, 0.0, 0.3, 0.0, 0.0))
    light = mass_of(500.0, *values)
    assert density(light, of) == pytest.approx(500.0)
    assert looked_up(of, light)["density"] == pytest.approx(log(told))
    assert looked_up(of, light)["thickness"] == pytest.approx(log(values[0]))


def test_what_is_thin_and_seems_too_heavy_is() -> None:
    of = shape(0.0, 0.5, 1.0, 0.0, 0.0, 0.0, errors=(0.0, 0.0, 0.0001, 0.0, 0.0, 0.0))
    heavy = mass_of(15_000.0, 0.0001, 0.5, 1.0)
    assert looked_up(of, heavy)["density"] == pytest.approx(log(15_000.0))


@pytest.mark.parametrize("mass", [1e-300, 1e300])
def test_a_density_beyond_all_floats_is_not_looked_up(mass: float) -> None:
    assert "density" not in looked_up(OBLONG, mass)


def test_a_point_is_taken_to_have_next_to_no_extent() -> None:
    """Of 1e-30 kg·m²; of four times that everything that has its unit is four times as wide."""
    point, larger = shape(*EXACT), shape(4e-30, 4e-30, 4e-30, 0.0, 0.0, 0.0)
    assert density(1.0, point) == pytest.approx(1.0 / (4.0 / 3.0 * pi * 5e-30**1.5))
    assert density(1.0, larger) == pytest.approx(density(1.0, point) / 8.0)


def test_all_evidence_is_added() -> None:
    body = MassDistribution(10.0, (0.15, 0.2, 0.0), EXACT)
    known = dict(quantities_of(body, OBLONG, END, 5.0))
    told = sum(TABLES[name].at(value) for name, value in known.items())
    lie = log(sum(w * d for w, d in zip(LIES, ways_to_lie(OBLONG), strict=True)))
    assert of_spread(OBLONG) == pytest.approx(lie - log(0.2 * 0.5 * 1.0))
    assert of_matter(body, OBLONG, END, 5.0) == pytest.approx(told + TRUST * of_spread(OBLONG))


@pytest.mark.parametrize(
    ("moments", "expected"),
    [
        ((4.0, 3.0, 2.0, 1.0, -1.0, 0.5), -6.0 * log(4.0)),
        ((4.0, -5.0, 2.0, 1.0, -1.0, 0.5), -6.0 * log(5.0)),
        # What is written as zero is so within a thousandth to either side.
        ((4.0, 3.0, 2.0, 0.0, 0.0, 0.5), -6.0 * log(4.0) - 2.0 * log(0.002)),
    ],
)
def test_any_moments_are_of_their_size(moments: Symmetric, expected: float) -> None:
    assert of_anything(moments) == pytest.approx(expected)


@pytest.mark.parametrize(
    ("quantity", "expected"),
    [(1.0, 3.0), (1.5, 5.0), (1.25, 4.0), (2.0, -1.0), (0.0, 2.0), (2.5, -1.5), (-9.0, -7.0)],
)
def test_a_table_is_read_between_its_steps_and_falls_outside(
    quantity: float, expected: float
) -> None:
    assert LikelihoodTable(1.0, 0.5, (3.0, 5.0, -1.0)).at(quantity) == pytest.approx(expected)


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
