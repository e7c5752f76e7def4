"""What stands between tokens and comments, wherever comments and blank lines are put."""

import re

import pytest
from tests.formatting.test_format import FORMATTED, comments, formatted, tokens

from kindsl.language.syntax.document import parse

ENDS = sorted(
    start + token.end
    for island, start in zip(parse(FORMATTED).islands, parse(FORMATTED).starts, strict=True)
    for token in island.tokens
)


def with_comment(end: int, comment: str) -> str:
    return f"{FORMATTED[:end]} {comment} {FORMATTED[end:]}"


@pytest.mark.parametrize("comment", ["/* new */", "// new\n", "\n/* new */", "\n// new\n"])
def test_a_comment_between_any_two_tokens_stays_apart_from_them(comment: str) -> None:
    for end in ENDS:
        before = parse(with_comment(end, comment))
        text = formatted(before.text)
        after = parse(text)
        assert tokens(after) == tokens(before)
        assert comments(after) == comments(before)
        assert formatted(text) == text
        assert re.search(r"[\s(<\[]" + re.escape(comment.strip()) + r"[\s,)>\]]", text), text


def test_blank_lines_stand_between_sections_only() -> None:
    lines = formatted(FORMATTED.replace("\n", "\n\n\n")).splitlines()
    open_parentheses = 0
    for number, line in enumerate(lines):
        if not line:
            assert lines[number - 1] != ""
            assert lines[number - 1] == "Robot R {" or not lines[number - 1].endswith("{")
            assert lines[number + 1].strip() != "}"
            assert open_parentheses == 0
        open_parentheses += line.count("(") - line.count(")")
    assert [line for line in lines if line] == [line for line in FORMATTED.splitlines() if line]


@pytest.mark.parametrize("blank", ["\n", "\n\n\n", " ", "\t", ""])
def test_blanks_at_both_ends_go(blank: str) -> None:
    assert formatted(f"{blank}{FORMATTED.strip()}{blank}") == FORMATTED
