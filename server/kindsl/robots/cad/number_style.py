"""The style of a report's numbers: its decimal mark, and the mark that groups digits."""

import re
from collections.abc import Iterator
from decimal import Decimal
from fractions import Fraction
from functools import cache
from typing import NamedTuple

from kindsl.robots.cad.quantity import Quantity

_APART = "'’\xa0\u202f\u2009"
_LIKE = re.compile(rf"(?<![\w.,^])[-+]?\.?\d(?:[\d.,]|[{_APART}](?=\d{{3}}))*(?:[eE][-+]?\d+)?")
_GROUPED_BY_BLANKS = re.compile(
    r"(?<=[=:])(?P<number>\s*[-+]?\d{1,3}(?: \d{3})+)(?=[.,]\d|\s*(?:[^\d\s.,+-]|$))"
)
_GROUPED_BEFORE_UNIT = re.compile(r"(?<![\d.,])\d{1,3}(?: \d{3})+(?:[.,]\d+)?(?= *[a-zA-Zµ])")
# Behind a mark, a bracket, a number, labels in a row or nothing: behind a word it may be a dash.
_SIGN_APART = re.compile(
    r"(^\s*|[^\w\s.)\]]\s*|[\d.]\s+|\b(?:[LIJ]\w{2}\s+){2}|\bX\s+Y\s+Z\s+)([-+])\s+(?=[.,]?\d)",
    re.IGNORECASE,
)
_SINGLE = re.compile(r"\b(?:mass|[LIJP]\w{1,3}|[XYZ])\s*[=:]", re.IGNORECASE)
_GROUPS = re.compile(r"[1-9]\d{0,2}(?:[.,]\d{3})+")


class NumberStyle(NamedTuple):
    """Marks in numbers.

    Attributes:
        point: The decimal mark.
        has_commas: Whether decimal commas were seen.
        has_groups: Whether digits stand in groups.
    """

    point: str
    has_commas: bool = False
    has_groups: bool = False

    def numbers(self, line: str) -> Iterator[tuple[int, int, Quantity]]:
        """Yield begin and end of each number of a line, and the number without name or unit."""
        for match in _pattern(self.point).finditer(line):
            plain = re.sub(rf"[{_APART}]", "", match[0])
            plain = plain.replace("," if self.point == "." else ".", "").replace(",", ".")
            yield match.start(), match.end(), _quantity(plain)


def number_styles(lines: list[str]) -> tuple[NumberStyle, ...]:
    """Return how the numbers of some lines may be written, none where they contradict."""
    points: set[str] = set()
    doubtful: set[str] = set()
    has_groups = False
    for line in lines:
        for match in _LIKE.finditer(line):
            point, is_grouped, is_doubtful = _marks(match[0])
            has_groups |= is_grouped
            (doubtful if is_doubtful else points).add(point)
    points.discard("")
    if len(points) > 1:
        return ()
    if points:
        point = points.pop()
        other = "," if point == "." else "."
        return (NumberStyle(point, point == ",", has_groups or other in doubtful),)
    if "," in doubtful and "." not in doubtful:
        return NumberStyle(",", True, has_groups), NumberStyle(".", False, True)
    return (NumberStyle(".", False, has_groups),) if "," not in doubtful else ()


def with_joined_numbers(line: str) -> str:
    """Return a line without blanks behind signs, and none that group digits taken for gaps."""
    line = _SIGN_APART.sub(r"\1\2", line)
    line = _GROUPED_BEFORE_UNIT.sub(_joined, line)
    return line if _SINGLE.search(line) is None else _GROUPED_BY_BLANKS.sub(_joined, line)


def _joined(match: re.Match[str]) -> str:
    return re.sub(r"(?<=\d) (?=\d)", "\xa0", match[0])


def _marks(text: str) -> tuple[str, bool, bool]:
    """Return the decimal mark of a number, whether it has groups, whether the mark is doubtful."""
    mantissa, _, exponent = text.lstrip("+-").lower().partition("e")
    mantissa = mantissa.rstrip(".,")
    apart = any(mark in mantissa for mark in _APART)
    mantissa = re.sub(rf"[{_APART}]", "", mantissa)
    commas, points = mantissa.count(","), mantissa.count(".")
    if commas and points:
        return _of_both(mantissa, commas, points)
    mark = "," if commas else "." if points else ""
    if not mark:
        return "", apart, False
    if commas + points > 1:
        is_grouped = _GROUPS.fullmatch(mantissa) is not None
        return ("." if mark == "," else ",") if is_grouped else "", is_grouped, False
    is_doubtful = _GROUPS.fullmatch(mantissa) is not None and not exponent and not apart
    return mark, apart, is_doubtful


def _of_both(mantissa: str, commas: int, points: int) -> tuple[str, bool, bool]:
    last = max(mantissa.rfind(","), mantissa.rfind("."))
    point, whole = mantissa[last], mantissa[:last]
    is_number = (commas if point == "," else points) == 1 and _GROUPS.fullmatch(whole)
    return (point, True, False) if is_number else (".", False, False)


@cache
def _pattern(point: str) -> re.Pattern[str]:
    other = "," if point == "." else "."
    whole = rf"\d{{1,3}}(?:[{other}{_APART}]\d{{3}})+(?!\d)|\d+"
    number = rf"(?:{whole})(?:[{point}]\d*)?|[{point}]\d+"
    return re.compile(rf"(?<![\w^])[-+]?(?:{number})(?:[eE][-+]?\d+)?(?![\d%])")


def _quantity(plain: str) -> Quantity:
    number = Decimal(plain.rstrip(".") if "e" not in plain.lower() else plain)
    exponent = number.as_tuple().exponent
    assert isinstance(exponent, int)
    return Quantity("", number, Fraction(10) ** exponent / 2)
