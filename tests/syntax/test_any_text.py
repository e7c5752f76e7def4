"""Any text whatever is read, losslessly, and any row of edits gives what reading anew gives."""

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from tests.support.models import LAYOUTS, Style, random_model
from tests.support.syntax_checks import assert_lossless, assert_same

from kindsl.language.syntax.document import parse
from kindsl.language.syntax.expected import expected_at
from kindsl.language.syntax.portability import portability
from kindsl.language.text.edits import TextEdit, apply_edits

PIECES = (
    "link", "{", "}", "/*", "*/", "//", "\n", "\r", "\r\n", " ", "r_joint", "RobotBase", "Robot",
    "via", "l1", "linkl2 {", "= 1.0", "(", "children", "frames { a {", "translation",
    "ref_frame {", "id = 1", '"', "#", "\u00a0", "\ufeff", "é", "^x", "pi", "|i", "1", ".", "-",
    "*", "link l1 { id", "floating", "\x00", "\ud800", "link link", "r_joint j\n{", "\nlink a {\n",
    "\n}\n", "[1.0, 2.0]", "0,5", "x-1.0",
)  # fmt: skip
FRAGMENTS = st.lists(st.sampled_from(PIECES) | st.text(max_size=6), max_size=40).map("".join)
MODELS = st.builds(
    lambda links, seed, layout: random_model(links, seed, Style(layout=layout)),
    st.integers(1, 4),
    st.integers(0, 50),
    st.sampled_from(LAYOUTS),
)
EDITS = st.lists(
    st.tuples(st.floats(0, 1), st.sampled_from([0, 0, 1, 3, 20, 200]), FRAGMENTS | st.just("")),
    min_size=1,
    max_size=5,
)


@settings(max_examples=150, deadline=None)
@given(st.text(max_size=300) | FRAGMENTS)
@example("")
@example("/*")
@example("link")
@example(
    "link l { frames { f { rotation = ((1.0 + 90000000000.0)*PI, 0.0, 90000000000.0 deg) } } }"
)
@example("Robot Q { RobotBase b { children { } } link /* l { id = 1")
def test_any_text_is_read_without_loss(text: str) -> None:
    document = parse(text)
    assert_lossless(document, text)
    assert len(document.problems) <= 1 + len(text)


@settings(max_examples=80, deadline=None)
@given(FRAGMENTS | MODELS, st.floats(0, 1), st.integers(0, 30))
def test_everything_derived_from_any_text(text: str, place: float, length: int) -> None:
    start = int(place * len(text))
    document = parse(text[:start] + text[start + length :])
    for island in document.islands:
        for note in portability(island):
            assert 0 <= note.start <= note.end <= len(island.text)
    found = document.island_at(start)
    expected = expected_at(found.island, min(start - found.start, len(found.island.text)))
    assert expected.kinds


@settings(max_examples=120, deadline=None)
@given(FRAGMENTS | MODELS, EDITS)
def test_edits_give_what_reading_anew_gives(text: str, edits: list[tuple[float, int, str]]) -> None:
    document = parse(text)
    for place, length, new in edits:
        start = int(place * len(text))
        edit = TextEdit(start, min(start + length, len(text)), new)
        text = apply_edits(text, [edit])
        document = document.edited([edit])
        assert_same(document, parse(text))


@settings(max_examples=40, deadline=None)
@given(MODELS, st.lists(st.integers(0, 3000), min_size=2, max_size=100, unique=True))
def test_edits_made_at_once(text: str, places: list[int]) -> None:
    edits = [TextEdit(place, place, "\n/* x */") for place in places if place <= len(text)]
    assert_same(parse(text).edited(edits), parse(apply_edits(text, edits)))


@pytest.mark.parametrize("first", ["0x1", "0x1f", "-0X1_F", "0x", "0x_", "1'000", "0x1e+3"])
@pytest.mark.parametrize("second", ["", "0.0", "1", "0x2", "1'000"])
def test_numbers_of_other_languages_beside_each_other(first: str, second: str) -> None:
    text = f"r_joint j {{ ref_frame {{ translation = ({first}, {second}, 0.0) rotation = (0"
    assert parse(text).text == text
