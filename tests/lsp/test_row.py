"""A text in pieces: whatever is put where, it is that text, and says what of it is new."""

from collections.abc import Sequence
from itertools import accumulate

from hypothesis import given
from hypothesis import strategies as st

from kindsl.frontends.lsp.text.lines import Lines
from kindsl.frontends.lsp.text.row import PlainPiece, Row, edits_between, replace_in_sums
from kindsl.language.text.edits import apply_edits, in_common, n_same
from kindsl.language.text.lines import LineIndex

ALPHABET = "ab\r\né😀"
rows = st.lists(st.text(ALPHABET, min_size=1, max_size=6), min_size=1, max_size=8)
replacements = st.lists(
    st.tuples(st.integers(0, 50), st.integers(0, 12), st.text(ALPHABET, max_size=6)), max_size=8
)
numbers = st.lists(st.integers(0, 4), max_size=8)


@given(rows, replacements)
def test_a_row_is_the_text_that_was_put(
    pieces: list[str], made: list[tuple[int, int, str]]
) -> None:
    row, text = row_of(pieces), "".join(pieces)
    for start, length, new in made:
        start = min(start, len(text))
        end = min(start + length, len(text))
        row.replace(start, end, new)
        text = text[:start] + new + text[end:]
        check(row, text)


@given(rows, replacements)
def test_the_row_it_was_copied_from_stays(
    pieces: list[str], made: list[tuple[int, int, str]]
) -> None:
    first, text = row_of(pieces), "".join(pieces)
    changed(first, made)
    check(first, text)


@given(rows, replacements)
def test_the_edits_between_two_rows_lead_from_one_to_the_other(
    pieces: list[str], made: list[tuple[int, int, str]]
) -> None:
    old = row_of(pieces)
    new = changed(old, made)
    edits = list(between(old, new))
    text, expected = whole(old), whole(new)
    assert apply_edits(text, edits) == expected
    for edit in edits:
        removed = text[edit.start : edit.end]
        assert removed != edit.text
        assert not (removed and edit.text and removed[0] == edit.text[0])
        assert not (removed and edit.text and removed[-1] == edit.text[-1])


def test_edits_far_from_each_other_stay_apart() -> None:
    old = row_of(["aa", "bb", "cc", "dd", "ef"])
    new = changed(old, [(1, 0, "x"), (9, 1, "")])
    assert list(between(old, new)) == [(1, 1, "x"), (8, 9, "")]


def test_pieces_that_were_not_touched_are_kept() -> None:
    old = row_of(["aa", "bb", "cc"])
    new = changed(old, [(2, 1, "x")])
    assert new.pieces[0] is old.pieces[0]
    assert new.pieces[2] is old.pieces[2]
    assert old.pieces[1].text == "bb"


@given(st.integers(0, 700), st.sets(st.integers(0, 700), max_size=3))
def test_rows_are_the_same_up_to_the_first_place_that_is_not(
    limit: int, different: set[int]
) -> None:
    def are_same(first: int, end: int) -> bool:
        assert 0 <= first < end <= limit
        return different.isdisjoint(range(first, end))

    assert n_same(limit, are_same) == min({limit, *different})


@given(st.integers(1, 600), st.integers(0, 600), st.integers(0, 600), st.integers(0, 3))
def test_long_rows_share_all_but_what_was_replaced(
    length: int, first: int, last: int, n_new: int
) -> None:
    first, last = sorted((min(first, length), min(last, length)))
    old = [PlainPiece("a") for _ in range(length)]
    new = [*old[:first], *(PlainPiece("a") for _ in range(n_new)), *old[last:]]
    expected = (length, 0) if new == old else (first, length - last)
    assert in_common(old, new) == expected


@given(rows, replacements, st.lists(st.integers(1, 30), max_size=4))
def test_a_row_can_be_held_in_other_pieces(
    pieces: list[str], made: list[tuple[int, int, str]], cuts: Sequence[int]
) -> None:
    row = changed(row_of(pieces), made)
    text = whole(row)
    places = sorted({0, *(c for c in cuts if c < len(text) and text[c - 1 : c + 1] != "\r\n")})
    held = [PlainPiece(text[a:b]) for a, b in zip(places, [*places[1:], len(text)], strict=True)]
    shared = [*row.pieces[:1], *held[1:]] if row.pieces[0].text == held[0].text else held
    other = row.held_in(shared)
    check(other, text)
    assert other.pieces == shared
    check(row, text)


@given(numbers, st.lists(st.tuples(st.integers(0, 8), st.integers(0, 3), numbers), max_size=6))
def test_sums_are_those_of_the_numbers(
    row: list[int], made: list[tuple[int, int, list[int]]]
) -> None:
    sums = [0, *accumulate(row)]
    for first, count, new in made:
        first = min(first, len(row))
        last = min(first + count, len(row))
        replace_in_sums(sums, first, last, new)
        row = [*row[:first], *new, *row[last:]]
        assert sums == [0, *accumulate(row)]


def row_of(pieces: list[str]) -> Row:
    """A row of some texts, those joined that would share a CR LF."""
    joined = [pieces[0]]
    for piece in pieces[1:]:
        if joined[-1].endswith("\r") and piece.startswith("\n"):
            joined[-1] += piece
        else:
            joined.append(piece)
    return Row([PlainPiece(piece) for piece in joined])


def changed(row: Row, made: list[tuple[int, int, str]]) -> Row:
    row = row.copy()
    for start, length, new in made:
        start = min(start, row.length)
        row.replace(start, min(start + length, row.length), new)
    return row


def between(old: Row, new: Row):
    starts = [0, *accumulate(len(piece.text) for piece in old.pieces)]
    return edits_between(old.pieces, starts, new)


def whole(row: Row) -> str:
    return "".join(piece.text for piece in row.pieces)


def check(row: Row, text: str) -> None:
    """See that a row is a text, by every way of asking it."""
    assert whole(row) == text
    assert row.length == len(text)
    assert row.is_ascii == text.isascii()
    assert all(piece.text for piece in row.pieces) or len(row.pieces) == 1
    pairs = zip(row.pieces, row.pieces[1:], strict=False)
    assert not any(a.text[-1] == "\r" and b.text[0] == "\n" for a, b in pairs)
    lines, index = Lines(row.pieces), LineIndex(text)
    assert lines.last == len(index.starts) - 1
    assert [lines.start(line) for line in range(lines.last + 1)] == index.starts
    for offset in range(len(text) + 1):
        assert lines.position(offset, "utf-32") == index.position(offset)
        assert row.text(offset // 2, offset) == text[offset // 2 : offset]
