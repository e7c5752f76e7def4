"""Nothing is suppressed by a mistake: what is not understood is told, and suppresses nothing."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.rules.registry import all_codes
from kindsl.language.text.edits import apply_edits

TEXT = """Robot Arm {
RobotBase ground { children { upper via shoulder } }
link upper { // %s
    id = 1
    children {}
}
r_joint shoulder { ref_frame { translation = (0.0, 0.0, 0.1) rotation = (0.0, 0.0, 0.0) } }
}
"""
WITHOUT = {"KD304"}


def codes(comment: str) -> set[str]:
    return {f.code for f in analyse(TEXT % comment).findings}


@pytest.mark.parametrize(
    ("comment", "message", "written"),
    [
        ("kindsl: ignore-file[KD3O4]", "no rule has the code 'KD3O4'; did you mean 'KD304'?", None),
        ("kindsl: ignore[KD999]", "no rule has the code 'KD999'", ""),
        ("kindsl: ignore[304]", "did you mean 'KD304'?", None),
        ("kindsl: ignore[KD301 KD304]", "did you mean 'KD301, KD304'?", None),
        ("kindsl: ignroe[KD304]", "unknown comment 'kindsl: ignroe'; did you mean 'ignore'?", None),
        ("kindsl: ignore", "'ignore' names no code and suppresses nothing", None),
        ("kindsl: ignore[]", "'ignore' names no code and suppresses nothing", None),
        ("kindsl: off", "unknown comment 'kindsl: off'", ""),
        ("kindsl:", "unknown comment 'kindsl: '", ""),
    ],
)
def test_mistake_is_told_and_suppresses_nothing(
    comment: str, message: str, written: str | None
) -> None:
    found = analyse(TEXT % comment).findings
    assert {f.code for f in found} >= {"KD304", "KD706"}
    (told,) = [f for f in found if f.code == "KD706"]
    assert message in told.message
    assert told.fix is not None
    after = apply_edits(TEXT % comment, told.fix.edits)
    rest = {f.code for f in analyse(after).findings}
    assert "KD706" not in rest
    assert ("KD304" in rest) == (written == "")


@given(st.text("KD0123456789O, x[]", max_size=12))
def test_only_codes_of_rules_suppress(inside: str) -> None:
    found = codes(f"kindsl: ignore[{inside}]")
    tokens = [token.strip() for token in inside.partition("]")[0].split(",")]
    known = [t for t in tokens if t[:2] == "KD" and any(c.startswith(t) for c in all_codes())]
    is_suppressed = any("KD304".startswith(token) for token in known)
    assert ("KD304" not in found) == is_suppressed


def test_prose_about_kindsl_is_left_alone() -> None:
    assert codes("checked with kindsl: all well") == WITHOUT
    assert codes("fine, kindsl: ignore[KD304]") == set()
