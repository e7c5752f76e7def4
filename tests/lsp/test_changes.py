"""A notification's changes, however many, do to the text what one after the other would."""

import re
from collections.abc import Sequence

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from lsprotocol import types

from kindsl.lsp.text.changes import Change, edits_of, split_lines
from kindsl.lsp.text.lines import Lines, PlainPiece
from kindsl.text.edits import apply_edits

steady = settings(deadline=None, derandomize=True)

ALPHABET = "ab \t\r\n\x0b\x0c\x1c\x85\u2028é😀"
texts = st.text(ALPHABET, max_size=40)
encodings = st.sampled_from(["utf-8", "utf-16", "utf-32"])
positions = st.builds(types.Position, st.integers(0, 8), st.integers(0, 12))
ranges = st.builds(types.Range, positions, positions)
changes = st.lists(
    st.builds(
        types.TextDocumentContentChangePartial, range=ranges, text=st.text(ALPHABET, max_size=5)
    )
    | st.builds(types.TextDocumentContentChangeWholeDocument, text=texts),
    min_size=1,
    max_size=6,
)


@steady
@given(texts, changes, encodings)
def test_changes_made_at_once_equal_changes_made_one_after_the_other(
    text: str, changes: Sequence[Change], encoding: str
) -> None:
    edits = edits_of(lines_of(text), changes, encoding)
    assert apply_edits(text, edits) == naively_changed(text, changes, encoding)


@steady
@given(texts, st.lists(st.integers(0, 7), min_size=1, max_size=6, unique=True), encodings)
def test_descending_changes_equal_changes_made_one_after_the_other(
    text: str, rows: list[int], encoding: str
) -> None:
    made = [
        types.TextDocumentContentChangePartial(
            range=types.Range(types.Position(row, 1), types.Position(row, 2)), text="\n"
        )
        for row in sorted(rows, reverse=True)
    ]
    assert apply_edits(text, edits_of(lines_of(text), made, encoding)) == naively_changed(
        text, made, encoding
    )


@steady
@given(texts)
def test_lines_have_the_ends_of_the_specification_only(text: str) -> None:
    lines = split_lines(text)
    assert "".join(lines) == text
    assert len(lines) == len(re.findall(r"\r\n|\n|\r", text)) + 1


@pytest.mark.parametrize("separator", ["\x0b", "\x0c", "\x1c", "\x85", "\u2028", "\u2029"])
def test_other_separators_do_not_end_a_line(separator: str) -> None:
    insertion = types.TextDocumentContentChangePartial(
        range=types.Range(types.Position(1, 0), types.Position(1, 0)), text="x"
    )
    text = f"a{separator}b\nc"
    assert (
        apply_edits(text, edits_of(lines_of(text), [insertion], "utf-16")) == f"a{separator}b\nxc"
    )


def lines_of(text: str) -> Lines:
    return Lines((PlainPiece(text),), (0,))


def naively_changed(text: str, changes: Sequence[Change], encoding: str) -> str:
    for change in changes:
        if isinstance(change, types.TextDocumentContentChangeWholeDocument):
            text = change.text
            continue
        start, end = sorted(
            naive_offset(text, position, encoding)
            for position in (change.range.start, change.range.end)
        )
        text = text[:start] + change.text + text[end:]
    return text


def naive_offset(text: str, position: types.Position, encoding: str) -> int:
    """The specification, word for word and character for character."""
    offset = 0
    for _ in range(position.line):
        match = re.compile(r"\r\n|\n|\r").search(text, offset)
        if match is None:
            return len(text)
        offset = match.end()
    units = 0
    while offset < len(text) and text[offset] not in "\r\n":
        units += len(text[offset].encode(f"{encoding}-le".replace("8-le", "8"))) // unit(encoding)
        if units > position.character:
            break
        offset += 1
    return offset


def unit(encoding: str) -> int:
    return int(encoding.split("-")[1]) // 8
