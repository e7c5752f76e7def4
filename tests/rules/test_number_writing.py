from math import pi

import pytest

from kindsl.judgement.rules.number_writing import (
    as_fraction_of_pi,
    decimals,
    rescaled,
    rewritten,
    significant_digits,
)
from kindsl.language.semantics.expressions import Expression
from kindsl.language.syntax.document import parse
from kindsl.language.syntax.tree import Node


def vector(*texts: str) -> list[Expression]:
    """Return the components of a translation as expressions."""
    source = f"r_joint j {{ ref_frame {{ translation = ({', '.join(texts)}) rotation = (0.0"
    (island,) = (i for i in parse(f"{source}, 0.0, 0.0) }} }}").islands if "r_joint" in i.text)
    pose = next(island.nodes[0].nodes("joint_frame"))
    (node,) = next(pose.nodes("translation")).nodes("vector")
    return [Expression(child, island) for child in node.children if isinstance(child, Node)]


@pytest.mark.parametrize(
    ("written", "values", "texts"),
    [
        (("0.0150", "0.0120", "0.0000"), (0.195, 0.012, -1e-9), ["0.1950", "0.0000"]),
        (("0.015", "0.01", "0.0"), (0.195, 0.2, 0.0), ["0.195", "0.2"]),
        (("0.015", "0.01", "0.0"), (-1.0, 0.01, 0.0125), ["-1.0", "0.013"]),
    ],
)
def test_numbers_are_written_in_the_authors_hand(
    written: tuple[str, ...], values: tuple[float, ...], texts: list[str]
) -> None:
    changes = rewritten(vector(*written), values)
    assert changes is not None
    assert [change.text for change in changes] in (
        texts,
        [t.replace("0.013", "0.012") for t in texts],
    )


@pytest.mark.parametrize(
    ("text", "places", "digits"),
    [("0.0150", 4, 3), ("-12.5", 1, 3), ("1.0", 1, 2), ("2.5e-3", 1, 2), ("0.0", 1, 1)],
)
def test_digits_are_counted(text: str, places: int, digits: int) -> None:
    assert decimals(text) == places
    assert significant_digits(text) == digits


@pytest.mark.parametrize(
    ("written", "value", "text"),
    [
        (("0.0015", "2.5e-3", "0.0"), 0.0012345678, "0.00123457"),
        (("0.0015", "2.5E-3", "0.0"), 1234.5678, "1234.57"),
        (("0.0015", "0.0025", "0.0"), 0.0012345678, "0.0012"),
    ],
)
def test_beside_an_exponent_six_digits_are_written(
    written: tuple[str, ...], value: float, text: str
) -> None:
    changes = rewritten(vector(*written), (value, *map(float, written[1:])))
    assert changes is not None
    assert [change.text for change in changes] == [text]


@pytest.mark.parametrize("other", ["reach", "2.0*0.1", "1e999"])
def test_only_plain_numbers_are_written_anew(other: str) -> None:
    assert rescaled(vector("0.1", other, "0.3"), (1.0, 2.0, 3.0)) is None
    if other != "1e999":
        assert rewritten(vector("0.1", other, "0.3"), (1.0, 2.0, 3.0)) is None


@pytest.mark.parametrize(
    ("written", "values", "texts"),
    [
        (("425.0", "0.0", "12.0"), (0.425, 0.0, 0.012), ["0.425", "0.012"]),
        (("1234.5", "0.1", "2.0"), (1.23456, 0.00012345678, 3.0), ["1.2346", "0.00012346", "3.0"]),
    ],
)
def test_rescaled_numbers_keep_the_digits_of_their_group(
    written: tuple[str, ...], values: tuple[float, ...], texts: list[str]
) -> None:
    changes = rescaled(vector(*written), values)
    assert changes is not None
    assert [change.text for change in changes] == texts


@pytest.mark.parametrize(
    ("part", "text"),
    [
        (1.0, "PI"),
        (2.0, "PI/2.0"),
        (3.0, "PI/3.0"),
        (4.0, "PI/4.0"),
        (6.0, "PI/6.0"),
        (8.0, "PI/8.0"),
        (12.0, "PI/12.0"),
        (1.5, "PI/1.5"),
        (0.5, "PI/0.5"),
        (5.0, None),
    ],
)
def test_fractions_of_pi_are_told(part: float, text: str | None) -> None:
    assert as_fraction_of_pi(pi / part, 0.0) == text
    assert as_fraction_of_pi(-pi / part, 0.0) == (text and f"-{text}")
    assert as_fraction_of_pi(pi / part + 1e-4, 1.1e-4) == text
    assert as_fraction_of_pi(pi / part + 1e-4, 0.9e-4) is None
