"""What a suppression covers."""

import pytest

from kindsl.judgement.rules.suppression import (
    Suppression,
    covered_by,
    directives,
    is_known,
    suppressions,
)
from kindsl.language.semantics.places import Place
from kindsl.language.syntax.document import parse

PLACE = Place(parse("Robot R {}").islands[0], 0, 0)


@pytest.mark.parametrize(
    ("start", "end", "at", "is_covered"),
    [
        (5, 9, 4, False),
        (5, 9, 5, True),
        (5, 9, 8, True),
        (5, 9, 9, False),
        (5, 5, 5, True),
        (5, 5, 6, False),
    ],
)
def test_a_finding_is_covered_where_it_begins(
    start: int, end: int, at: int, is_covered: bool
) -> None:
    assert Suppression("KD3", PLACE, PLACE, start, end).covers("KD301", at) == is_covered


@pytest.mark.parametrize(
    ("code", "finding", "is_covered"),
    [
        ("KD301", "KD301", True),
        ("kd301", "KD301", True),
        ("KD3", "KD301", True),
        ("KD301", "KD302", False),
        ("KD3012", "KD301", False),
        ("KD", "KD001", False),
        ("KD001", "KD001", False),
    ],
)
def test_errors_of_syntax_are_never_covered(code: str, finding: str, is_covered: bool) -> None:
    assert Suppression(code, PLACE, PLACE, 0, 9).covers(finding, 0) == is_covered


HEAD = "Robot Arm {\nRobotBase ground {\n    children { upper via shoulder }\n}\n"
JOINT = """r_joint shoulder {
    ref_frame { translation = (0.0, 0.0, 0.1) rotation = (0.0, 0.0, 0.0) }
}
"""


LINK = "link upper {\n    id = 1\n    children {}\n}\n"


@pytest.mark.parametrize(
    ("link", "end"),
    [
        # Behind something: its line.
        ("link upper {\n<    id = 1 // kindsl: ignore[KD3]\n>    children {}\n}\n", "}\n"),
        ("link upper {\n<    id = 1 /* kindsl: ignore[KD3] */ \n>    children {}\n}\n", "}\n"),
        # Alone: the next line.
        ("link upper {\n    // kindsl: ignore[KD3]\n<    id = 1\n>    children {}\n}\n", "}\n"),
        # Behind the beginning of a block, or alone before it: the block.
        ("<link upper { // kindsl: ignore[KD3]\n    id = 1\n    children {}\n}>\n", "}\n"),
        ("// kindsl: ignore[KD3]\n<link upper {\n    id = 1\n    children {}\n}>\n", "}\n"),
        ("  /* kindsl: ignore[KD3] */\n<link upper {\n id = 1\n children {}\n}>\n", "}\n"),
        ("link upper {\n id = 1\n<    children { // kindsl: ignore[KD3]\n    }>\n}\n", "}\n"),
        # Of two blocks that begin in a line the outer one.
        (
            "link upper {\n id = 1\n // kindsl: ignore[KD3]\n< frames { tool {\n"
            "translation = (0.0, 0.0, 0.1) rotation = (0.0, 0.0, 0.0) } }>\n children {}\n}\n",
            "}\n",
        ),
        # A block that ends in the line, or begins behind it, is not meant.
        ("link upper {\n id = 1\n children {\n<    } // kindsl: ignore[KD3]\n>}\n", "}\n"),
        ("link upper {\n< id = 1 // kindsl: ignore[KD3]\n> children {\n    }\n}\n", "}\n"),
        # At the very end there is no next line.
        (LINK, "}\n// kindsl: ignore[KD3]\n<>"),
        (LINK, "}\n// kindsl: ignore[KD3]<>"),
        (LINK, "<} // kindsl: ignore[KD3]>"),
    ],
)
@pytest.mark.parametrize("line_end", ["\n", "\r\n", "\r"])
def test_what_a_comment_silences(link: str, end: str, line_end: str) -> None:
    marked = f"{HEAD}{link}{JOINT}{end}".replace("\n", line_end)
    covered = marked.index("<"), marked.index(">") - 1
    text = marked.replace("<", "").replace(">", "")
    document = parse(text)
    (found,) = suppressions(document.islands, document.starts, len(text))
    assert (found.start, found.end) == covered
    assert found.at.island.text[found.at.start : found.at.end] == found.code == "KD3"
    (directive,) = (d for island in document.islands for d in directives(island))
    assert covered_by(document.islands, document.starts, len(text), directive) == covered


def test_a_comment_silences_a_whole_document() -> None:
    text = f"{HEAD}// kindsl: ignore-file[KD3, KD4]\n{LINK}{JOINT}}}\n"
    document = parse(text)
    found = suppressions(document.islands, document.starts, len(text))
    assert [(each.code, each.start, each.end) for each in found] == [
        ("KD3", 0, len(text) + 1),
        ("KD4", 0, len(text) + 1),
    ]


@pytest.mark.parametrize("line_end", ["\n", "\r\n", "\r"])
def test_the_first_line_begins_behind_empty_ones(line_end: str) -> None:
    line = f"{line_end}arm // kindsl: ignore[KD3]{line_end}"
    text = f"{line}Robot Arm {{{line_end}}}{line_end}"
    document = parse(text)
    (found,) = suppressions(document.islands, document.starts, len(text))
    assert (found.start, found.end) == (len(line_end), len(line))


@pytest.mark.parametrize(
    ("comment", "silenced"),
    [
        ("kindsl: ignore[KD3, KX1, KD999, KD401]", ["KD3", "KD401"]),
        ("kindsl: ignore-file[KX1]", []),
        ("kindsl: ignore[]", []),
        ("kindsl: ignore", []),
        ("kindsl: ignored", []),
    ],
)
def test_only_codes_of_rules_silence_something(comment: str, silenced: list[str]) -> None:
    text = f"{HEAD}// {comment}\n{LINK}{JOINT}}}\n"
    document = parse(text)
    found = suppressions(document.islands, document.starts, len(text))
    assert [each.code for each in found] == silenced


@pytest.mark.parametrize(
    ("comment", "word", "codes"),
    [
        ("// kindsl: ignore[KD3, KD401]", "ignore", ["KD3", "KD401"]),
        ("// kindsl: ignore [KD3 ,KD401 ]", "ignore", ["KD3", "KD401"]),
        ("// kindsl:ignore-file[KD3]", "ignore-file", ["KD3"]),
        ("// kindsl: ignore[]", "ignore", []),
        ("// kindsl: ignore", "ignore", None),
        ("/* kindsl: ignore */", "ignore", None),
        ("// kindsl: ignored", "", None),
        ("// kindsl:", "", None),
        ("// so kindsl: ignore[KD3]", "ignore", ["KD3"]),
        ("// so kindsl: ignore", None, None),
        ("// nothing", None, None),
    ],
)
def test_directives_are_read(comment: str, word: str | None, codes: list[str] | None) -> None:
    found = [
        d for island in parse(f"Robot R {{\n{comment}\n}}").islands for d in directives(island)
    ]
    assert [d.word for d in found] == ([] if word is None else [word])
    for d in found:
        assert (None if d.codes is None else [code for code, _ in d.codes]) == codes
        assert d.comment.island.text[d.comment.start : d.comment.end] == comment
        assert d.at.island.text[d.at.start :].startswith("kindsl:")


@pytest.mark.parametrize(
    ("code", "expected"),
    [("KD301", True), ("kd301", True), ("KD3", True), ("KD", True), ("KD399", False), ("K", False)],
)
def test_codes_are_known_by_their_beginnings(code: str, expected: bool) -> None:
    assert is_known(code) == expected
