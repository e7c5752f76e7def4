"""The health of a document, as in `kindsl info`."""

from collections import Counter
from collections.abc import Callable, Sequence
from typing import Any

from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.rules.base import Severity
from kindsl.language.text.phrases import counted
from kindsl.products.reports.columns import aligned

_SUBJECTS = {
    "KD0": "syntax",
    "KD1": "names and ids",
    "KD2": "kinematic tree",
    "KD3": "inertia",
    "KD4": "parameters",
    "KD5": "geometry",
    "KD6": "generators",
    "KD7": "style",
}
_MOST_TOLD = 10


def health_facts(
    findings: Sequence[Diagnostic], place: Callable[[int], dict[str, int]]
) -> dict[str, Any]:
    """Return a verdict and what it rests on.

    Args:
        findings: Findings of the rules.
        place: Line, column and offset of an absolute offset.
    """
    serious = [f for f in findings if f.severity in (Severity.ERROR, Severity.WARNING)]
    return {
        "verdict": _verdict(serious),
        "subjects": {
            name: severity_counts([f for f in findings if f.code.startswith(prefix)])
            for prefix, name in _SUBJECTS.items()
        },
        "findings": [
            {
                "code": finding.code,
                "severity": finding.severity.value,
                "message": finding.message,
                **place(finding.start),
            }
            for finding in sorted(serious, key=lambda f: f.severity is Severity.WARNING)
        ],
    }


def health_text(health: dict[str, Any]) -> str:
    """Return the section for people: the verdict, counts by subject, the gravest findings."""
    rows = [("health", health["verdict"])]
    for name, counts in health["subjects"].items():
        if counts["error"] or counts["warning"]:
            parts = (counted(counts[kind], kind) for kind in ("error", "warning") if counts[kind])
            rows.append((f"  {name}", ", ".join(parts)))
    gravest = health["findings"][:_MOST_TOLD]
    lines = [f"  {f['line']}:{f['column']}  [{f['code']}] {f['message']}\n" for f in gravest]
    left = len(health["findings"]) - len(gravest)
    if left:
        lines.append(f"  and {left} more, see kindsl lint\n")
    return aligned(rows) + "".join(lines)


def _verdict(serious: Sequence[Diagnostic]) -> str:
    if any(finding.severity is Severity.ERROR for finding in serious):
        return "broken"
    return "suspect" if serious else "good"


def severity_counts(findings: Sequence[Diagnostic]) -> dict[str, int]:
    """Return how many findings there are of each severity."""
    counts = Counter(finding.severity for finding in findings)
    return {severity.value: counts[severity] for severity in Severity}
