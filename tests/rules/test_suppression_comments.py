"""KD704 and KD706: what a comment `kindsl:` is told to be, and what its fix leaves of it."""

import pytest
from tests.support.example_documents import document_of
from tests.support.examples import link
from tests.support.one_rule import found

from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.text.edits import apply_edits

LINK = document_of(link("upper", 1, inertia=""))


def commented(comment: str, blanks: str = " ") -> str:
    """Return a document that ends with a link without inertia, KD304, with a comment."""
    return LINK.replace("link upper {", f"link upper {{{blanks}{comment}", 1)


def fixed(code: str, comment: str) -> list[tuple[str, bool, str | None]]:
    """Return messages, whether the fixes are safe, and the comments that they leave."""
    text = commented(comment)
    results: list[tuple[str, bool, str | None]] = []
    for finding in found(code, text):
        assert finding.fix is not None
        after = apply_edits(text, finding.fix.edits)
        left = after.partition("link upper {")[2].partition("\n")[0]
        assert after.replace(left, "", 1) == LINK.replace("link upper {", "link upper {", 1)
        results.append((finding.message, finding.fix.is_safe, left.removeprefix(" ") or None))
    return results


@pytest.mark.parametrize(
    ("inside", "expected"),
    [
        ("KD304", []),
        ("KD301", [("KD301", None)]),
        ("kd301", [("kd301", None)]),
        ("KD301,", [("KD301", None)]),
        (" KD301 , ", [("KD301", None)]),
        ("KD301, KD304", [("KD301", "KD304")]),
        ("KD301,KD304", [("KD301", "KD304")]),
        ("KD301 ,  KD304", [("KD301", "KD304")]),
        ("KD304, KD301", [("KD301", "KD304")]),
        ("KD304 , KD301 ", [("KD301", "KD304")]),
        ("KD304,KD301,KD303", [("KD301", "KD304,KD303"), ("KD303", "KD304,KD301")]),
        ("KD3", []),
        ("KD2", [("KD2", None)]),
    ],
)
def test_what_a_comment_keeps_without_a_vain_code(
    inside: str, expected: list[tuple[str, str | None]]
) -> None:
    results = [
        (f"unused suppression of {code}", True, left and f"// kindsl: ignore[{left}]")
        for code, left in expected
    ]
    assert fixed("KD704", f"// kindsl: ignore[{inside}]") == results


@pytest.mark.parametrize(
    ("comment", "wrong", "meant", "left"),
    [
        ("ignroe[KD304]", "comment 'kindsl: ignroe'", "ignore", "ignore[KD304]"),
        ("ignore-fiel[KD3]", "comment 'kindsl: ignore-fiel'", "ignore-file", "ignore-file[KD3]"),
        ("ignorefile[KD3]", "comment 'kindsl: ignorefile'", "ignore-file", "ignore-file[KD3]"),
        ("ignor all", "comment 'kindsl: ignor'", "ignore", "ignore all"),
        ("elsewhere", "comment 'kindsl: elsewhere'", "", None),
        ("", "comment 'kindsl: '", "", None),
        ("ignore[KD3O4]", "code 'KD3O4'", "KD304", "ignore[KD304]"),
        ("ignore[KD304;]", "code 'KD304;'", "KD304", "ignore[KD304]"),
        ("ignore[KD304; KD3]", "code 'KD304; KD3'", "KD304, KD3", "ignore[KD304, KD3]"),
        ("ignore[KD304 KD999]", "code 'KD304 KD999'", "", None),
        ("ignore[304]", "code '304'", "KD304", "ignore[KD304]"),
        ("ignore[3]", "code '3'", "", None),
        ("ignore[999]", "code '999'", "", None),
        ("ignore[;]", "code ';'", "", None),
        ("ignore[Missing-Inertia]", "code 'Missing-Inertia'", "KD304", "ignore[KD304]"),
        ("ignore[KD304, KD999]", "code 'KD999'", "", "ignore[KD304]"),
        ("ignore[KD999,KD304]", "code 'KD999'", "", "ignore[KD304]"),
    ],
)
def test_what_a_comment_was_meant_to_be(
    comment: str, wrong: str, meant: str, left: str | None
) -> None:
    """It is only safe to remove a directive that means nothing; others may be remarks."""
    message = f"unknown {wrong}" if "kindsl" in wrong else f"no rule has the {wrong}"
    message += f"; did you mean '{meant}'?" if meant else ""
    written = None if left is None else f"// kindsl: {left}"
    assert fixed("KD706", f"// kindsl: {comment}") == [
        (message, not meant and comment[:6] == "ignore", written)
    ]


@pytest.mark.parametrize(
    ("text", "left"),
    [
        (LINK.replace("link upper {", "link upper { // kindsl: ignore"), "ignore[KD304]"),
        (LINK.replace("link upper {", "link upper { // kindsl: ignore-file"), "ignore-file[KD304]"),
        (LINK.replace("\nr_joint", "\n// kindsl: ignore\nr_joint"), None),
    ],
)
def test_a_comment_without_codes_is_given_those_of_its_findings(
    text: str, left: str | None
) -> None:
    (finding,) = [f for f in analyse(text).findings if f.code == "KD706"]
    assert finding.fix is not None and finding.fix.is_safe == (left is None)
    after = apply_edits(text, finding.fix.edits)
    assert (f"// kindsl: {left}" in after) if left else ("kindsl" not in after)


def test_brackets_before_a_suppression_hold_no_codes() -> None:
    text = commented("// as in [1] kindsl: ignore[KD304, KD301]")
    (finding,) = found("KD704", text)
    assert finding.fix is not None
    assert apply_edits(text, finding.fix.edits) == text.replace(", KD301", "")


@pytest.mark.parametrize(
    ("settings", "count"),
    [(Settings(), 1), (Settings(ignore=("KD301",)), 0), (Settings(ignore=("KD302",)), 1)],
)
def test_a_rule_that_does_not_run_needs_no_suppression_and_may_have_one(
    settings: Settings, count: int
) -> None:
    text = commented("// kindsl: ignore[KD301]")
    assert [f.code for f in analyse(text, settings).findings].count("KD704") == count


@pytest.mark.parametrize("blanks", [" ", "\t ", "", "\n    "])
@pytest.mark.parametrize(
    "comment", ["// kindsl: ignore[KD301]", "/* kindsl: ignore[KD301] */", "// kindsl: off"]
)
def test_a_comment_is_removed_with_the_blanks_before_it(blanks: str, comment: str) -> None:
    text = commented(comment, blanks)
    (finding,) = [f for f in analyse(text).findings if f.code in ("KD704", "KD706")]
    assert finding.fix is not None and finding.tag == ("unnecessary" if "[" in comment else None)
    after = apply_edits(text, finding.fix.edits)
    assert after == text.replace(blanks.lstrip("\n") + comment, "")


def test_an_unknown_word_may_end_the_document() -> None:
    analysis = analyse("Robot R { RobotBase b { children {} } } // kindsl: ignroe")
    assert analysis.faults == ()
    (finding,) = [f for f in analysis.findings if f.code == "KD706"]
    assert finding.message == "unknown comment 'kindsl: ignroe'; did you mean 'ignore'?"
