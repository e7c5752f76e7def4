"""Twenty reports in six layouts, each to the digit; `expected.json` has the numbers in SI units."""

import json
import re
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path

import pytest

import kindsl

FOLDER = Path(__file__).parent / "reports"
EXPECTED = json.loads((FOLDER / "expected.json").read_text(encoding="utf-8"))
REPORTS = {name: (FOLDER / f"{name}.txt").read_text(encoding="utf-8") for name in EXPECTED}
# A slug has no finite number of digits; a report of one tensor only is moved, with its digits.
EXACT = Fraction(0)
IN_SLUGS = Fraction(1, 10**16)
MOVED = Fraction(1, 10**5)


def numbers(properties: kindsl.MassProperties) -> list[Fraction]:
    texts = (properties.mass, *properties.com, *properties.moments)
    return [Fraction(text) for text in texts]


@pytest.mark.parametrize("name", EXPECTED)
def test_each_digit_is_kept(name: str) -> None:
    found, expected = kindsl.mass_properties(REPORTS[name]), EXPECTED[name]
    allowed = MOVED if "moved" in expected else IN_SLUGS if "slugs" in name else EXACT
    for number, right in zip(numbers(found), map(Fraction, expected["numbers"]), strict=True):
        assert abs(number - right) <= allowed * abs(right)


@pytest.mark.parametrize("name", EXPECTED)
def test_program_and_sign_are_found(name: str) -> None:
    found = kindsl.mass_properties(REPORTS[name])
    assert (found.program, found.sign) == (EXPECTED[name]["program"], EXPECTED[name]["sign"])


def _with_groups(mark: str) -> Callable[[str], str]:
    def group(match: re.Match[str]) -> str:
        return f"{int(match[1]):,}".replace(",", mark) + (match[2] or "")

    return lambda text: re.sub(r"(?<![\w.,^])(\d+)(\.\d+)?(?![\w.,]*\d)", group, text)


LAYOUTS: dict[str, Callable[[str], str]] = {
    "colons": lambda text: text.replace(" = ", ": "),
    "no blanks": lambda text: text.replace(" = ", "="),
    "tabs": lambda text: re.sub(r"  +", "\t", text),
    "blanks": lambda text: text.replace("\t", "    "),
    "blanks of print": lambda text: re.sub(r"[ \t]", "\N{NO-BREAK SPACE}", text),
    "capitals": str.upper,
    "one block": lambda text: re.sub(r"\n\s*\n", "\r\n", text),
    "a comment": lambda text: "\n".join(f"// {line}" for line in text.split("\n")),
    "British": lambda text: text.replace("enter of", "entre of"),
    "minus of print": lambda text: re.sub(r"-(?=\d)", "\N{MINUS SIGN}", text),
    "dots": lambda text: re.sub(r"(kg|lb|g|lbmass) (mm|in|m)(\^2|²)", r"\1·\2²", text),
    "commas in groups": _with_groups(","),
    "quotes in groups": _with_groups("'"),
    "thin blanks in groups": _with_groups("\u202f"),
    "page numbers": lambda text: text.replace("\n", "\n7\n"),
    "decimal commas": lambda text: re.sub(r"(?<=\d)\.(?=\d)", ",", text),
}
_WITH_MARKS = ("SolidWorks_komma", "Inventor_groups")


@pytest.mark.parametrize(
    ("name", "layout"),
    [
        (name, layout)
        for name in EXPECTED
        for layout in LAYOUTS
        if name not in _WITH_MARKS or not ("group" in layout or "commas" in layout)
    ],
)
def test_the_layout_does_not_matter(name: str, layout: str) -> None:
    found = kindsl.mass_properties(LAYOUTS[layout](REPORTS[name]))
    assert numbers(found) == numbers(kindsl.mass_properties(REPORTS[name]))
