"""A defect of ours in one rule costs what that rule would have found, and is told."""

from collections.abc import Iterator

import pytest

from kindsl.judgement.analysis import analysis as analyses
from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.rules.base import Finding, Rule, Severity
from kindsl.judgement.rules.registry import checking_rules

DUPLICATES = """Robot R {
RobotBase base { inertia_params { mass = 1.0 CoM = (0.0, 0.0, 0.0) Ix = 1.0 Iy = 1.0 Iz = 1.0
  Ixy = 0.0 Ixz = 0.0 Iyz = 0.0 } children { one via first } }
link one { id = 1 children {} }
link two { id = 1 children {} }
r_joint first { ref_frame { translation = (0.0, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } }
}
"""


def failing(*_: object) -> Iterator[Finding]:
    raise ZeroDivisionError("oh")
    yield


@pytest.fixture(params=["check_document", "check_island"])
def faulty(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> Rule:
    """A rule that fails, the first of all."""
    rule = Rule("kd999_faulty", Severity.ERROR, **{request.param: failing})
    monkeypatch.setattr(analyses, "checking_rules", lambda: (rule, *checking_rules()))
    monkeypatch.setattr(analyses, "running_rules", analyses.running_rules.__wrapped__)
    return rule


def test_the_other_rules_still_find(faulty: Rule, monkeypatch: pytest.MonkeyPatch) -> None:
    spoilt = analyse(DUPLICATES)
    found = spoilt.findings
    assert {fault.rule for fault in spoilt.faults} == {faulty}
    assert spoilt.faults[0].message == "KD999 failed: ZeroDivisionError: oh"
    monkeypatch.undo()
    whole = analyse(DUPLICATES)
    assert found == whole.findings != ()
    assert whole.faults == ()


def test_what_was_found_in_spite_of_a_fault_is_not_remembered(faulty: Rule) -> None:
    spoilt = analyse(DUPLICATES)
    n_faults = len(spoilt.faults)
    assert n_faults > 0
    assert len(spoilt.with_settings(spoilt.settings).faults) == n_faults


class StoppedError(Exception):
    pass


def test_a_check_that_is_stopped_can_be_made_again() -> None:
    document = analyse(DUPLICATES)
    calls = []

    def stop_at_the_third() -> None:
        calls.append(len(calls))
        if len(calls) == 3:
            raise StoppedError

    with pytest.raises(StoppedError):
        document.check(stop_at_the_third)
    assert len(calls) == 3
    assert document.findings == analyse(DUPLICATES).findings
