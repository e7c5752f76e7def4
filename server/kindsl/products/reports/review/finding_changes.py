"""Findings that are new, gone, or still there."""

from collections import Counter
from collections.abc import Sequence
from typing import NamedTuple

from kindsl.judgement.analysis.analysis import Analysis
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.rules.base import Severity
from kindsl.language.text.lines import LineIndex

_TOLD = (Severity.ERROR, Severity.WARNING, Severity.INFORMATION)


class ToldFinding(NamedTuple):
    """A finding with its place in its own document, both from 1."""

    line: int
    column: int
    severity: str
    code: str
    message: str


class FindingChanges(NamedTuple):
    """Findings of the new document that the old has not, the reverse, and those of both."""

    new: tuple[ToldFinding, ...]
    gone: tuple[ToldFinding, ...]
    kept: tuple[ToldFinding, ...]


def finding_changes(old: Analysis, new: Analysis) -> FindingChanges:
    """Match findings by rule and message, wherever they moved to; hints are left out."""
    before, after = ([f for f in a.findings if f.severity in _TOLD] for a in (old, new))
    come, kept = _split(after, before)
    gone, _ = _split(before, after)
    return FindingChanges(_told(come, new), _told(gone, old), _told(kept, new))


def _split(
    findings: Sequence[Diagnostic], others: Sequence[Diagnostic]
) -> tuple[list[Diagnostic], list[Diagnostic]]:
    """Return the findings that the others have not, and the rest."""
    left = Counter((f.code, f.message) for f in others)
    alone: list[Diagnostic] = []
    shared: list[Diagnostic] = []
    for finding in findings:
        key = finding.code, finding.message
        (shared if left[key] else alone).append(finding)
        left[key] -= bool(left[key])
    return alone, shared


def _told(findings: Sequence[Diagnostic], analysis: Analysis) -> tuple[ToldFinding, ...]:
    lines = LineIndex(analysis.text)
    places = (lines.position(finding.start) for finding in findings)
    return tuple(
        ToldFinding(line + 1, column + 1, finding.severity.value, finding.code, finding.message)
        for (line, column), finding in zip(places, findings, strict=True)
    )
