"""Whether a body can have the inertia that is written, in the words of the rules."""

from kindsl.analysis.analysis import Analysis
from kindsl.rules.base import Severity
from kindsl.rules.registry import all_rules
from kindsl.semantics.declarations import Link
from kindsl.semantics.lowering import declarations

_CODES = ("KD301", "KD302", "KD303", "KD305", "KD306", "KD307", "KD308")
_MARKS = {Severity.ERROR: "✗ ", Severity.WARNING: "⚠ "}
_CONSISTENT = "✓ physically consistent"


def inertia_verdict(analysis: Analysis, body: Link) -> str:
    """Return what the rules of single bodies say of a link's inertia, the worst first."""
    declared = declarations(body.island)
    for rule in all_rules():
        if rule.code not in _CODES or rule.check_island is None:
            continue
        for finding in rule.check_island(declared, analysis.context):
            if body.start <= finding.at.start < body.end:
                severity = finding.severity or rule.severity
                return f"{_MARKS.get(severity, '')}{finding.message} ({rule.code})"
    return _CONSISTENT
