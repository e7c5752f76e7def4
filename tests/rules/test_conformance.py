"""What the generators accept is accepted, with and without a target named."""

import pytest
from tests.support.conformance import Case, accepted_cases, cases

from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.settings import Settings

LOADING = ("KD0", "KD105", "KD106", "KD107", "KD108", "KD6")


@pytest.mark.parametrize("case", accepted_cases(), ids=lambda case: case.name)
def test_what_a_generator_accepts_has_no_error_of_syntax(case: Case) -> None:
    found = analyse(case.text).findings
    assert [f.message for f in found if f.code.startswith("KD0")] == []


@pytest.mark.parametrize("target", ["robcogen", "robcogen2"])
def test_with_a_target_named_its_verdict_is_ours(target: str) -> None:
    settings = Settings(targets=frozenset([target]))
    differing = []
    for case in cases():
        found = analyse(case.text, settings).findings
        errors = [f for f in found if f.severity == "error" and f.code.startswith(LOADING)]
        if bool(errors) == (target in case.accepted_by):
            differing.append(case.name)
    assert differing == []
