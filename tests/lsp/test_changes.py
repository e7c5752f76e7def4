"""A notification's changes, however many, do to the text what one after the other would."""

import re
from collections.abc import Sequence

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from lsprotocol import types

from kindsl.frontends.lsp.text.lines import ContentChange, Lines, changed
from kindsl.frontends.lsp.text.row import PlainPiece
from kindsl.language.text.lines import LineIndex

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
def test_changes_are_made_one_after_the_other(
    text: str, changes: Sequence[ContentChange], encoding: str
) -> None:
    lines, (start, end) = changed(lines_of(text), changes, encoding)
    made = naively_changed(text, changes, encoding)
    assert lines.text(0, lines.length) == made
    assert [lines.start(line) for line in range(lines.last + 1)] == LineIndex(made).starts
    assert 0 <= start <= end <= len(made)
    assert made[:start] == text[:start]
    assert made[end:] == text[len(text) - (len(made) - end) :]


@steady
@given(texts, st.lists(st.integers(0, 7), min_size=1, max_size=6, unique=True), encodings)
def test_descending_changes_are_made_one_after_the_other(
    text: str, rows: list[int], encoding: str
) -> None:
    made = [
        types.TextDocumentContentChangePartial(
            range=types.Range(types.Position(row, 1), types.Position(row, 2)), text="\n"
        )
        for row in sorted(rows, reverse=True)
    ]
    lines, _ = changed(lines_of(text), made, encoding)
    assert lines.text(0, lines.length) == naively_changed(text, made, encoding)


def test_what_was_changed_is_a_stretch_of_the_new_text() -> None:
    made = [
        types.TextDocumentContentChangePartial(
            range=types.Range(types.Position(0, column), types.Position(0, column)), text="xy"
        )
        for column in (5, 1)
    ]
    lines, touched = changed(lines_of("0123456789"), made, "utf-16")
    assert lines.text(*touched) == "xy1234xy"


@pytest.mark.parametrize("separator", ["\x0b", "\x0c", "\x1c", "\x85", "\u2028", "\u2029"])
def test_other_separators_do_not_end_a_line(separator: str) -> None:
    insertion = types.TextDocumentContentChangePartial(
        range=types.Range(types.Position(1, 0), types.Position(1, 0)), text="x"
    )
    text = f"a{separator}b\nc"
    lines, touched = changed(lines_of(text), [insertion], "utf-16")
    assert lines.text(0, lines.length) == f"a{separator}b\nxc"
    assert lines.text(*touched) == "x"


def lines_of(text: str) -> Lines:
    return Lines([PlainPiece(text)])


def naively_changed(text: str, changes: Sequence[ContentChange], encoding: str) -> str:
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
