"""Trials of fixes: those that change a robot are offered only if they leave it no worse.

A trial makes the edits and runs every rule, whatever the user has selected. A fix stands it if its
finding is gone, if nothing new is found about what it changes nor about anything that was in order
before, and if no fault stays whose cause is no longer reported. Nothing is tried before somebody
asks for a fix.
"""

from bisect import bisect_right
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from typing import TypeAlias
from weakref import WeakKeyDictionary

from kindsl.judgement.analysis.analysis import Analysis
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.analysis.text_fix import TextFix, disjoint, edits_of
from kindsl.judgement.rules.base import Severity
from kindsl.judgement.rules.subject import Subject, subject_at
from kindsl.language.semantics.places import Place

# Fixes of syntax, names, parameters, the tree, comments: more is read then, so more may be found.
_OF_READING = ("KD0", "KD1", "KD201", "KD40", "KD7")
_FAULTS = (Severity.ERROR, Severity.WARNING)
# So many are tried one by one.
_FEW = 16
_Mending: TypeAlias = tuple[Diagnostic, TextFix]
_Trial: TypeAlias = tuple[Subject, str, TextFix]
_trials: "WeakKeyDictionary[Analysis, dict[_Trial, bool]]" = WeakKeyDictionary()
_judged: "WeakKeyDictionary[Analysis, Analysis]" = WeakKeyDictionary()


def offered(analysis: Analysis, findings: Iterable[Diagnostic]) -> list[Diagnostic]:
    """Return findings of a document, each with those of its fixes that stand their trial."""
    all_findings = list(findings)
    fixes = ((each, fix) for each in all_findings for fix in (each.fix, *each.choices) if fix)
    _try(analysis, fixes)
    return [_offered(analysis, finding) for finding in all_findings]


def _offered(analysis: Analysis, finding: Diagnostic) -> Diagnostic:
    if not (finding.fix or finding.choices):
        return finding
    fix = finding.fix if finding.fix and _stands(analysis, finding, finding.fix) else None
    choices = tuple(fix for fix in finding.choices if _stands(analysis, finding, fix))
    return finding._replace(fix=fix, choices=choices)


def _stands(analysis: Analysis, finding: Diagnostic, fix: TextFix) -> bool:
    return _trials.get(analysis, {}).get((finding.subject, finding.code, fix), True)


def _try(analysis: Analysis, fixes: Iterable[_Mending]) -> None:
    """Try fixes one by one; of many, those of single findings together, then halves of them."""
    known = _trials.setdefault(analysis, {})
    new = [
        (finding, fix)
        for finding, fix in fixes
        if not finding.code.startswith(_OF_READING)
        and not fix.is_safe
        and (finding.subject, finding.code, fix) not in known
    ]
    pending = [[each] for each in new] if len(new) <= _FEW else [new]
    while pending:
        some = pending.pop()
        stands = _is_no_worse(_under_every_rule(analysis), some)
        if stands or len(some) == 1:
            known.update({(finding.subject, finding.code, fix): stands for finding, fix in some})
        else:
            pending += [some[: len(some) // 2], some[len(some) // 2 :]]


def _under_every_rule(analysis: Analysis) -> Analysis:
    if analysis not in _judged:
        settings = analysis.settings._replace(select=(), ignore=(), known={})
        is_same = settings == analysis.settings
        _judged[analysis] = analysis if is_same else analysis.with_settings(settings)
    return _judged[analysis]


def _is_no_worse(analysis: Analysis, mendings: Sequence[_Mending]) -> bool:
    fixes = [fix for _, fix in mendings]
    if len(disjoint(fixes)) < len(fixes):
        return False
    tried = analysis.edited(edits_of(fixes))
    before, after = _by_subject(analysis.findings), _by_subject(tried.findings)
    for key, n in Counter((f.subject, f.code) for f, _ in mendings).items():
        if key in before and after[key] > before[key] - n:
            return False
    changed = {finding.subject for finding, _ in mendings}
    changed |= {subject for fix in fixes for subject in _changed(analysis, fix)}
    faulty = {subject for subject, _ in before}
    if any(who in changed or who not in faulty for who, _ in after - before):
        return False
    families = {finding.code[:3] for finding, _ in mendings}
    return not any(
        each.subject in changed and each.code[:3] in families and _is_unexplained(each)
        for each in tried.findings
    )


def _by_subject(findings: Iterable[Diagnostic]) -> Counter[tuple[Subject, str]]:
    return Counter((f.subject, f.code) for f in findings if f.severity is not Severity.HINT)


def _is_unexplained(finding: Diagnostic) -> bool:
    """Return whether a fault is reported without a way out of it."""
    return finding.severity in _FAULTS and not finding.fix and not finding.choices


def _changed(analysis: Analysis, fix: TextFix) -> Iterator[Subject]:
    """Yield what the edits of a fix are made in."""
    islands, starts = analysis.syntax.islands, analysis.syntax.starts
    for edit in fix.edits:
        n = bisect_right(starts, edit.start) - 1
        yield subject_at(Place(islands[n], edit.start - starts[n], edit.end - starts[n]))
