"""How a report writes its numbers, and how a number is written into a document."""

from decimal import Decimal
from fractions import Fraction

import pytest

from kindsl.robots.cad.mesh import ShapeError, _check_closed
from kindsl.robots.cad.number_style import NumberStyle, number_styles, with_joined_numbers
from kindsl.robots.cad.quantity import Quantity, Rounded, decimal_text
from kindsl.robots.cad.unit import unit

POINT, COMMA = NumberStyle("."), NumberStyle(",", has_commas=True)


@pytest.mark.parametrize(
    ("line", "styles"),
    [
        ("12", [POINT]),
        ("1.5", [POINT]),
        ("1.500", [POINT]),
        ("1,5", [COMMA]),
        ("1,500", [COMMA, POINT._replace(has_groups=True)]),
        ("1,500e3", [COMMA]),
        ("12 1,500", [COMMA, POINT._replace(has_groups=True)]),
        ("1.5 2,5", []),
        ("1.500 1,500", []),
        ("1.5 1,500", [POINT._replace(has_groups=True)]),
        ("1,5 1.500", [COMMA._replace(has_groups=True)]),
        ("1,234.5", [POINT._replace(has_groups=True)]),
        ("1.234,5", [COMMA._replace(has_groups=True)]),
        ("1'500.25", [POINT._replace(has_groups=True)]),
        ("1'500,250", [COMMA._replace(has_groups=True)]),
        ("1.234.567,8", [COMMA._replace(has_groups=True)]),
        ("1,234,567.8", [POINT._replace(has_groups=True)]),
        ("1.234.567", [COMMA._replace(has_groups=True)]),
        ("1,234,567", [POINT._replace(has_groups=True)]),
        ("1,23,456", [POINT]),
    ],
)
def test_the_style_of_numbers_is_what_they_allow(line: str, styles: list[NumberStyle]) -> None:
    assert number_styles([line]) == tuple(styles)
    assert number_styles(line.split()) == tuple(styles)


@pytest.mark.parametrize(
    ("line", "joined"),
    [
        ("Mass = 1 234.5", "Mass = 1\xa0234.5"),
        ("Lxx: 1 234 567", "Lxx: 1\xa0234\xa0567"),
        ("Volume = 1 234", "Volume = 1 234"),
        ("1 234 567 mm", "1\xa0234\xa0567 mm"),
        ("0.1 234 500 mm", "0.1 234\xa0500 mm"),
        ("Lxx = 1 234 0.5", "Lxx = 1 234 0.5"),
    ],
)
def test_groups_are_joined_where_no_gap_can_be(line: str, joined: str) -> None:
    assert with_joined_numbers(line) == joined


@pytest.mark.parametrize(
    ("printed", "factor", "text"),
    [
        ("-0.000", Fraction(1), "0.0"),
        ("1.50", Fraction(1), "1.50"),
        ("150", Fraction(1, 1000), "0.150"),
        ("1.5", Fraction(1000), "1500.0"),
        ("2", Fraction(1, 3), "0.66666666666666667"),
        ("3", Fraction(3, 8), "1.125"),
        ("-7", Fraction(1), "-7.0"),
    ],
)
def test_a_quantity_keeps_its_digits(printed: str, factor: Fraction, text: str) -> None:
    assert Quantity("x", Decimal(printed), Fraction(1, 2), factor).text() == text


def test_a_computed_value_has_the_digits_that_its_error_leaves() -> None:
    value = Rounded(Fraction(2, 3), Fraction(1, 2000))
    assert [value.text(), value.text(-1)] == ["0.667", "-0.667"]
    assert Rounded(Fraction(2, 3), Fraction(0)).text() == decimal_text(Fraction(2, 3))
    assert Rounded(Fraction(7), Fraction(1, 2)).text() == "7.0"


@pytest.mark.parametrize(
    ("count", "said"),
    [(1, "an edge has triangles on one side, it is from"),
     (2, "2 edges have triangles on one side, the first is from")],
)  # fmt: skip
def test_open_edges_are_counted(count: int, said: str) -> None:
    edges = [((0, 0, 0), (number, 0, 0)) for number in range(1, count + 1)]
    with pytest.raises(ShapeError, match=said):
        _check_closed(edges, Fraction(1))
    _check_closed([], Fraction(1))


@pytest.mark.parametrize(
    ("text", "factor", "dimension"),
    [
        ("g·mm²", "1e-9", (1, 2, 0)),
        ("kg * square millimeters", "1e-6", (1, 2, 0)),
        ("metric tons", "1000", (1, 0, 0)),
        ("oz", "0.028349523125", (1, 0, 0)),
        ("slug", "14.593902937206364", (1, 0, 0)),
        ("slinch", "175.12683524647637", (1, 0, 0)),
        ("lbf s^2/in", "175.12683524647637", (1, 0, 0)),
        ("µm", "1e-6", (0, 1, 0)),
        ("cubic yards", "0.764554857984", (0, 3, 0)),
        ("kg per cubic metre", "1", (1, -3, 0)),
    ],
)
def test_units(text: str, factor: str, dimension: tuple[int, int, int]) -> None:
    found = unit(text)
    assert found is not None
    assert found.dimension == dimension
    assert float(found.factor) == pytest.approx(float(factor), rel=1e-14)


@pytest.mark.parametrize("text", ["", "furlong", "square", "kg 5"])
def test_what_is_no_unit(text: str) -> None:
    assert unit(text) is None
