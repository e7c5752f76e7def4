"""Places and positions: there and back, in every encoding, however the text is cut."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kindsl.frontends.lsp.text.lines import Lines
from kindsl.frontends.lsp.text.row import PlainPiece
from kindsl.language.text.lines import LineIndex

steady = settings(deadline=None, derandomize=True)

ALPHABET = "ab \r\n\x0c\x85\u2028é😀"
texts = st.text(ALPHABET, max_size=60)
encodings = st.sampled_from(["utf-8", "utf-16", "utf-32"])
cuts = st.lists(st.integers(0, 60), max_size=6)


@steady
@given(texts, cuts, encodings)
def test_an_offset_comes_back_from_its_position(text: str, cuts: list[int], encoding: str) -> None:
    lines = cut(text, cuts)
    for offset in range(len(text) + 1):
        if text[offset - 1 : offset + 1] == "\r\n" and offset:
            continue
        assert lines.offset(*lines.position(offset, encoding), encoding) == offset


@steady
@given(texts, cuts)
def test_lines_do_not_depend_on_the_pieces(text: str, cuts: list[int]) -> None:
    lines, whole = cut(text, cuts), LineIndex(text)
    assert lines.last == len(whole.starts) - 1
    assert [lines.start(line) for line in range(lines.last + 1)] == whole.starts
    for offset in range(len(text) + 1):
        assert lines.position(offset, "utf-32") == whole.position(offset)


@steady
@given(texts, cuts, st.integers(0, 60), st.integers(0, 60))
def test_a_stretch_of_text_does_not_depend_on_the_pieces(
    text: str, cuts: list[int], start: int, end: int
) -> None:
    assert cut(text, cuts).text(start, end) == text[start:end]


@pytest.mark.parametrize(("encoding", "units"), [("utf-8", 6), ("utf-16", 3), ("utf-32", 2)])
def test_columns_count_code_units(encoding: str, units: int) -> None:
    assert cut("😀é", []).position(2, encoding) == (0, units)


@pytest.mark.parametrize("encoding", ["utf-8", "utf-16", "utf-32"])
@pytest.mark.parametrize("text", ["ab", "ab\n", "ab\r\ncd", ""])
def test_places_past_the_end_are_clamped(text: str, encoding: str) -> None:
    lines = cut(text, [])
    assert lines.offset(0, 999, encoding) == len(text.splitlines()[0] if text else "")
    assert lines.offset(999, 0, encoding) == len(text)


def test_a_column_inside_a_character_is_its_beginning() -> None:
    assert cut("a😀b", []).offset(0, 2, "utf-16") == 1


def cut(text: str, cuts: list[int]) -> Lines:
    """The lines of a text held in pieces, no CR LF cut in two."""
    places = sorted({0, *(c for c in cuts if c < len(text) and text[c - 1 : c + 1] != "\r\n")})
    pieces = [text[a:b] for a, b in zip(places, [*places[1:], len(text)], strict=True)]
    return Lines([PlainPiece(piece) for piece in pieces])
