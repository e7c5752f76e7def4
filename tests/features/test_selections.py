"""Selections that grow, the token at the cursor, addresses in comments."""

import pytest
from tests.support.cursor import at_cursor

from kindsl.frontends.features.ranges import selection_ranges
from kindsl.frontends.features.tree_path import is_word, token_at
from kindsl.judgement.analysis.analysis import analyse
from kindsl.language.syntax.tree import Token

TIP = "tip { translation = (1.0, -x/2.0, <k=3.0>) }"
FRAME = f"frames {{ {TIP} }}"


def selected(marked: str) -> list[str]:
    analysis, offset = at_cursor(marked)
    spans = selection_ranges(analysis, offset)
    assert all(span.start <= offset <= span.end for span in spans)
    return [analysis.text[span.start : span.end] for span in spans]


VECTOR = ["1.0, -x/2.0, <k=3.0>", "(1.0, -x/2.0, <k=3.0>)", "translation = (1.0, -x/2.0, <k=3.0>)"]
AROUND = [TIP, f"{{ {TIP} }}", FRAME, f"link l {{ {FRAME} }}"]


@pytest.mark.parametrize(
    ("marked", "smallest"),
    [
        ("$01.0", ["1.0", *VECTOR]),
        ("1.0$0", [",", *VECTOR]),
        ("-$0x", ["x", "-x", "-x/2.0", *VECTOR]),
        ("x$0/2.0", ["/", "-x/2.0", *VECTOR]),
        ("/$02.0", ["2.0", "-x/2.0", *VECTOR]),
        ("<k$0=3.0>", ["=", "k=3.0", "<k=3.0>", *VECTOR]),
        ("<k=$03.0>", ["3.0", "k=3.0", "<k=3.0>", *VECTOR]),
        ("$0(1.0", ["(", *VECTOR[1:]]),
        ("($01.0", ["1.0", *VECTOR]),
        ("3.0>)$0", [")", *VECTOR[1:]]),
        (" $0=", ["=", VECTOR[2]]),
        (" = $0", ["(", *VECTOR[1:]]),
        ("transl$0ation", ["translation", VECTOR[2]]),
    ],
)
def test_a_selection_grows_from_the_word_over_its_brackets(
    marked: str, smallest: list[str]
) -> None:
    text = FRAME.replace(marked.replace("$0", ""), marked, 1)
    assert "$0" in text
    if " = " in marked:
        text = FRAME.replace(" = (", f"{marked}(")
    found = selected(f"link l {{ {text} }}")
    assert found == [*smallest, *AROUND]


@pytest.mark.parametrize(
    ("marked", "found"),
    [
        ("link l {$0}", ["}", "link l {}"]),
        ("link l { $0 }", ["link l {  }"]),
        ("link l { id = 1 $0 }", ["id = 1", "link l { id = 1  }"][1:]),
        (
            "link l { id = 1 children $0{} }",
            ["{", "children {}", "id = 1 children {}", "link l { id = 1 children {} }"],
        ),
        ("link l { id = $01", ["1", "id = 1", "link l { id = 1"]),
        ("$0", [""]),
        (" $0 ", ["  "]),
        ("// a$0 b\nlink l {}", ["// a b", "// a b\nlink l {}"]),
        ("link l { /* $0a */ id = 1 }", ["/* a */", "link l { /* a */ id = 1 }"]),
        ("link l { /* a */$0 }", ["/* a */", "link l { /* a */ }"]),
        ("link l { $0/* a */ }", ["/* a */", "link l { /* a */ }"]),
    ],
)
def test_selections_of_blocks_and_comments(marked: str, found: list[str]) -> None:
    assert selected(marked) == found


@pytest.mark.parametrize(
    ("marked", "token"),
    [
        ("$0link l { }", "link"), ("link$0 l { }", "link"), ("link l$0{ }", "l"),
        ("link l {$0", "{"),
        ("link l {$0}", "}"),
        ("link l { $0 }", None), ("link a$0{", "a"), ("r_joint ^j$0{", "^j"),
        ("{ x =$0-1.0", "-1.0"),
        ("(a$0,b)", "a"), ("(a,$0b)", "b"), ("()$0)", ")"), ("($0)", ")"), ("$0", None),
        ("link $0", None),
        ("_a$0{", "_a"), (".5$0,", ".5"), ("($0.5", ".5"),
    ],
)  # fmt: skip
def test_of_two_tokens_at_the_cursor_the_word_is_meant_else_the_second(
    marked: str, token: str | None
) -> None:
    analysis, offset = at_cursor(marked)
    found = token_at(analysis.syntax, offset)
    assert (found and found.token.text) == token
    if found is not None:
        assert analysis.text[found.start : found.end] == token
        assert found.start <= offset <= found.end


def test_before_the_text_is_where_it_begins() -> None:
    analysis = analyse(" }")
    assert token_at(analysis.syntax, -3) is None
    assert token_at(analysis.syntax, 1) == token_at(analysis.syntax, 9) is not None
    assert selection_ranges(analysis, -3) == selection_ranges(analysis, 0) == ((0, 2),)


@pytest.mark.parametrize(
    ("text", "answer"),
    [("link", True), ("_x", True), ("^x", True), ("1.0", True), ("-1.0", True), (".5", True),
     ("ü", True),
     ("{", False), ("-", False), ("=", False), ("", False), ("<", False)],
)  # fmt: skip
def test_names_keywords_and_numbers_are_words(text: str, answer: bool) -> None:
    assert is_word(Token("NAME", text, 0, 0, len(text))) == answer


def test_a_token_that_fits_nowhere_lies_in_no_construct() -> None:
    for marked in ("link l { $0? id = 1 }", "link l { id = 1 $0= }", "$0) link l {}"):
        analysis, offset = at_cursor(marked)
        found = token_at(analysis.syntax, offset)
        assert found is not None and found.path == ()
    found = token_at(*(lambda a: (a[0].syntax, a[1]))(at_cursor("link l { $0id = 1 }")))
    assert found is not None and [node.kind for node in found.path] == ["link", "id"]
