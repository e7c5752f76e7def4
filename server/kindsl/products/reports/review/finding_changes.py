"""Findings that are new, gone, or still there."""

from collections import Counter
from collections.abc import Sequence
from typing import NamedTuple

from kindsl.judgement.analysis.analysis import Analysis
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.rules.base import Severity

_SHOWN = (Severity.ERROR, Severity.WARNING, Severity.INFORMATION)


class FindingChanges(NamedTuple):
    """Findings of the new document that the old has not, the reverse, and those of both."""

    new: list[Diagnostic]
    gone: list[Diagnostic]
    kept: list[Diagnostic]


def finding_changes(old: Analysis, new: Analysis) -> FindingChanges:
    """Match findings by rule and message, wherever they moved to; hints are left out."""
    before, after = ([f for f in a.findings if f.severity in _SHOWN] for a in (old, new))
    come, kept = _split(after, before)
    gone, _ = _split(before, after)
    return FindingChanges(come, gone, kept)


def _split(
    findings: Sequence[Diagnostic], others: Sequence[Diagnostic]
) -> tuple[list[Diagnostic], list[Diagnostic]]:
    left = Counter((f.code, f.message) for f in others)
    alone: list[Diagnostic] = []
    shared: list[Diagnostic] = []
    for finding in findings:
        key = finding.code, finding.message
        (shared if left[key] else alone).append(finding)
        left[key] -= bool(left[key])
    return alone, shared
