"""Every quick fix for every rule's bad example and every defect file fixes and harms nothing."""

import re
from collections import Counter
from pathlib import Path

import pytest
from tests.support.example_documents import examples_of
from tests.support.markers import marked_files

from kindsl.frontends.features.actions.code_actions import quick_fixes
from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.rules.base import Severity
from kindsl.judgement.rules.registry import all_rules
from kindsl.language.text.edits import apply_edits

FIXTURES = sorted((Path(__file__).parents[2] / "fixtures" / "rules").glob("*.kindsl"))
EXAMPLES = [
    example if isinstance(example, str) else example.text
    for rule in all_rules()
    for example in examples_of(rule).bad
]
SOURCES = [path.read_text() for path in FIXTURES] + EXAMPLES
DOCUMENTS = [document.text for source in SOURCES for document in marked_files(source)]
# That no generator reads a document is told only where no other error is: a fix may uncover it.
BESIDE_NO_ERROR = {"KD604"}
NUMBER = re.compile(r"(?<![\w.])\d+(?:\.\d+)?")


def fixes(analysis):
    found = {}
    for finding in analysis.findings:
        for action in quick_fixes(analysis, finding.start, finding.end):
            if action.edits and action.diagnostics and not is_beside(action):
                found[action.edits] = action
    return found.values()


def is_beside(action):
    """Whether it creates a name beside another that is probably meant, which then is unused."""
    (finding, *_) = action.diagnostics
    return action.title.startswith("Create ") and "did you mean" in finding.message


def told(analysis):
    return Counter((finding.code, finding.message) for finding in analysis.findings)


def errors(analysis):
    """Count the errors by code; that a fragment is no robot is told once it can be read."""
    is_fragment = "RobotBase" not in analysis.text
    return Counter(
        finding.code
        for finding in analysis.findings
        if finding.severity is Severity.ERROR
        and not (is_fragment and finding.code == "KD008")
        and finding.code not in BESIDE_NO_ERROR
    )


def warnings(analysis):
    """Count errors and warnings by code."""
    worse = (Severity.ERROR, Severity.WARNING)
    return Counter(f.code for f in analysis.findings if f.severity in worse)


def test_there_are_fixes_to_hold():
    assert sum(len(list(fixes(analyse(text)))) for text in DOCUMENTS) > 50
    assert any(list(fixes(analyse(text))) for text in EXAMPLES)


@pytest.mark.parametrize("text", DOCUMENTS)
def test_a_fix_mends_its_finding_and_makes_no_error(text):
    before = analyse(text)
    for action in fixes(before):
        after = analyse(apply_edits(text, action.edits))
        for finding in action.diagnostics:
            key = (finding.code, finding.message)
            assert told(after)[key] < told(before)[key], action.title
        assert not errors(after) - errors(before), action.title


@pytest.mark.parametrize("text", EXAMPLES)
def test_a_fix_of_meaning_leads_into_no_other_rule(text):
    before = analyse(text)
    for action in fixes(before):
        if not any(finding.code.startswith("KD0") for finding in action.diagnostics):
            after = analyse(apply_edits(text, action.edits))
            # A link that is added has no inertia yet, which only its author knows.
            new = warnings(after) - warnings(before)
            assert not new.keys() - {"KD304", *BESIDE_NO_ERROR}, action.title


@pytest.mark.parametrize("text", DOCUMENTS)
def test_no_number_vanishes_but_what_a_finding_calls_wrong(text):
    for action in fixes(analyse(text)):
        new = apply_edits(text, action.edits)
        lost = len(NUMBER.findall(text)) - len(NUMBER.findall(new))
        called_wrong = sum(
            len(NUMBER.findall(text[finding.start : text.find("\n", finding.end)]))
            for finding in action.diagnostics
        )
        assert lost <= called_wrong, action.title
