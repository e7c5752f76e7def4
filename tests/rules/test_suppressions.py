"""What a suppression covers."""

import pytest

from kindsl.rules.suppression import Suppression
from kindsl.semantics.places import Place
from kindsl.syntax.document import parse

PLACE = Place(parse("Robot R {}").islands[0], 0, 0)


@pytest.mark.parametrize(
    ("start", "end", "at", "is_covered"),
    [
        (5, 9, 4, False),
        (5, 9, 5, True),
        (5, 9, 8, True),
        (5, 9, 9, False),
        (5, 5, 5, True),
        (5, 5, 6, False),
    ],
)
def test_a_finding_is_covered_where_it_begins(
    start: int, end: int, at: int, is_covered: bool
) -> None:
    assert Suppression("KD3", PLACE, PLACE, start, end).covers("KD301", at) == is_covered


@pytest.mark.parametrize(
    ("code", "finding", "is_covered"),
    [
        ("KD301", "KD301", True),
        ("kd301", "KD301", True),
        ("KD3", "KD301", True),
        ("KD301", "KD302", False),
        ("KD3012", "KD301", False),
        ("KD", "KD001", False),
        ("KD001", "KD001", False),
    ],
)
def test_errors_of_syntax_are_never_covered(code: str, finding: str, is_covered: bool) -> None:
    assert Suppression(code, PLACE, PLACE, 0, 9).covers(finding, 0) == is_covered
