"""Numbers of XML formats: the shortest that are read as the same values."""

import pytest

from kindsl.robots.interchange.xml_writing import numbers


@pytest.mark.parametrize(
    ("value", "written"),
    [
        (2.0, "2"),
        (-0.0, "0"),
        (0.1 + 0.2, "0.30000000000000004"),
        (-999999999999999.0, "-999999999999999"),
        (1e15, "1000000000000000.0"),
        (-1.5e15, "-1500000000000000.0"),
        (1e300, "1e+300"),
    ],
)
def test_a_number_is_as_short_as_it_can_be(value: float, written: str) -> None:
    assert numbers([value, 1.0]) == f"{written} 1"
    assert float(written) == value
