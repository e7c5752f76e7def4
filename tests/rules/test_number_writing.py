import pytest

from kindsl.rules.number_writing import decimals, rewritten, significant_digits
from kindsl.semantics.expressions import Expression
from kindsl.syntax.document import parse


def vector(*texts: str) -> list[Expression]:
    """Return the components of a translation as expressions."""
    source = f"r_joint j {{ ref_frame {{ translation = ({', '.join(texts)}) rotation = (0.0"
    (island,) = (i for i in parse(f"{source}, 0.0, 0.0) }} }}").islands if "r_joint" in i.text)
    pose = next(island.nodes[0].nodes("joint_frame"))
    (node,) = next(pose.nodes("translation")).nodes("vector")
    return [Expression(child, island) for child in node.nodes("number")]


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
