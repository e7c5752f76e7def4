"""The document as a value: what an edit shares with its predecessor, and places in it."""

import re

import pytest
from tests.support.models import random_model
from tests.support.syntax_checks import assert_same

from kindsl.language.syntax.document import SyntaxDocument, parse
from kindsl.language.text.edits import TextEdit


def edited_islands(before: SyntaxDocument, after: SyntaxDocument) -> int:
    known = {id(island) for island in before.islands}
    return sum(id(island) not in known for island in after.islands)


def test_a_digit_touches_one_island() -> None:
    document = parse(random_model(300))
    place = [match.start(1) for match in re.finditer(r"mass = (\d)", document.text)][150]
    after = document.edited([TextEdit(place, place + 1, "7")])
    assert edited_islands(document, after) == 1
    assert_same(after, parse(after.text))


@pytest.mark.parametrize("new", ["{", "}", "(", "link ", "\n", "// ", "/* x */"])
def test_a_stray_sign_touches_its_neighbourhood(new: str) -> None:
    document = parse(random_model(300))
    place = document.text.index("link segment_150") - 3
    after = document.edited([TextEdit(place, place, new)])
    assert edited_islands(document, after) <= 2
    assert_same(after, parse(after.text))


def test_an_open_comment_ends_at_the_next_block() -> None:
    document = parse(random_model(300))
    place = document.text.index("inertia_params", document.text.index("link segment_150"))
    opened = document.edited([TextEdit(place, place, "/*")])
    assert edited_islands(document, opened) == 1
    assert [p.code for i in opened.islands for p in i.problems] == ["KD003"]
    end = opened.text.index("link segment_152")
    closed = opened.edited([TextEdit(end, end, "*/")])
    assert_same(closed, parse(closed.text))


def test_the_old_document_stays_as_it_was() -> None:
    text = random_model(5)
    document = parse(text)
    document.edited([TextEdit(0, 40, "")])
    assert_same(document, parse(text))


def test_overlapping_edits_are_refused() -> None:
    with pytest.raises(ValueError, match="overlap"):
        parse("Robot Q {}").edited([TextEdit(0, 4, ""), TextEdit(3, 6, "")])


def test_islands_by_offset() -> None:
    document = parse(random_model(200))
    for index in (0, 1, 57, len(document) - 1):
        start = document.starts[index]
        assert document.island_at(start).index == index
        assert document.island_at(start).island is document.islands[index]
        assert document.island(index).start == start
    assert document.island_at(10**9).index == len(document) - 1
    assert document.island_at(-5).index == 0
