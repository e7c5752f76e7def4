"""Every rule's own examples, through the whole analysis."""

import re
from collections import Counter

import pytest
from tests.support.example_documents import bindings_of, document_of, examples_of, fixed_document_of
from tests.support.examples import Example

from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.analysis.settings import Settings
from kindsl.judgement.rules.base import Rule
from kindsl.judgement.rules.registry import all_rules, page_of
from kindsl.language.text.edits import apply_edits

DEFAULT = ("KD0", "KD1", "KD2", "KD3", "KD4", "KD5", "KD7")
# What they are about is in another file.
OF_FILES = {"KD800", "KD801", "KD802", "KD803", "KD804", "KD901", "KD902", "KD903"}
NEEDS_NO_EXAMPLE = {"KD404", *OF_FILES}
# A new link has no inertia yet, and a new pose is where another may be: that is to be filled in.
LEFT_BY_FIXES = {"KD006": {"KD508"}, "KD105": {"KD304", "KD705"}, "KD106": {"KD506"}}


def cases(kind: str) -> list[object]:
    return [
        pytest.param(rule, example, id=f"{rule.code}-{number}")
        for rule in all_rules()
        for number, example in enumerate(getattr(examples_of(rule), kind))
    ]


def analysed(rule: Rule, example: str | Example, text: str | None = None) -> Analysis:
    targets = () if isinstance(example, str) else example.targets
    settings = Settings(
        targets=frozenset(targets),
        select=() if rule.is_default else (*DEFAULT, rule.code),
        bindings=bindings_of(example),
    )
    return analyse(document_of(example) if text is None else text, settings)


def of_rule(rule: Rule, analysis: Analysis) -> list[Diagnostic]:
    assert analysis.faults == ()
    return [finding for finding in analysis.findings if finding.code == rule.code]


@pytest.mark.parametrize(("rule", "example"), cases("good"))
def test_good_example_has_no_finding_of_the_rule(rule: Rule, example: str | Example) -> None:
    analysis = analysed(rule, example)
    assert of_rule(rule, analysis) == []
    assert not [f for f in analysis.findings if f.severity == "error"]


@pytest.mark.parametrize(("rule", "example"), cases("bad"))
def test_bad_example_has_one_finding_of_the_rule(rule: Rule, example: str | Example) -> None:
    findings = of_rule(rule, analysed(rule, example))
    assert [f.code for f in findings] == [rule.code]
    assert not findings[0].message.endswith(".")


@pytest.mark.parametrize(("rule", "example"), cases("bad"))
def test_fix_writes_what_the_example_promises(rule: Rule, example: str | Example) -> None:
    before = analysed(rule, example)
    (finding,) = of_rule(rule, before)
    fixed = apply_edits(before.text, finding.fix.edits) if finding.fix else None
    assert fixed == fixed_document_of(example)


@pytest.mark.parametrize(("rule", "example"), cases("bad"))
def test_fix_is_as_safe_as_its_page_says(rule: Rule, example: str | Example) -> None:
    for finding in of_rule(rule, analysed(rule, example)):
        if finding.fix is not None:
            section = page_of(rule).partition("## Fix")[2].lower()
            assert re.search(r"\bsafe\b" if finding.fix.is_safe else r"\bunsafe\b", section)


@pytest.mark.parametrize(("rule", "example"), cases("bad"))
def test_fix_removes_the_finding_and_brings_none(rule: Rule, example: str | Example) -> None:
    before = analysed(rule, example)
    fixes = [finding.fix for finding in of_rule(rule, before) if finding.fix is not None]
    for fix in fixes[:1]:
        after = analysed(rule, example, apply_edits(before.text, fix.edits))
        assert of_rule(rule, after) == []
        new = Counter(f.code for f in after.findings) - Counter(f.code for f in before.findings)
        assert set(new) <= LEFT_BY_FIXES.get(rule.code, set())


@pytest.mark.parametrize("rule", all_rules(), ids=lambda rule: rule.code)
def test_rule_is_complete(rule: Rule) -> None:
    examples = examples_of(rule)
    assert rule.code in NEEDS_NO_EXAMPLE or (examples.good and examples.bad)
    page = page_of(rule)
    for heading in ("## What it does", "## Why is this bad?", "## Example"):
        assert heading in page
    has_fixed_example = any(fixed_document_of(example) is not None for example in examples.bad)
    assert has_fixed_example == ("## Fix" in page) or rule.code in OF_FILES


def test_codes_and_names_are_unique() -> None:
    rules = all_rules()
    assert len({rule.code for rule in rules}) == len({rule.name for rule in rules}) == len(rules)
