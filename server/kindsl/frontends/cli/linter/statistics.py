"""`--statistics`: the number of findings of each rule."""

from typing import NamedTuple

from kindsl.frontends.cli.outcome import RunOutcome
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.rules.base import Severity


class RuleCount(NamedTuple):
    """A rule's findings: the worst severity, their number, and how many have a safe fix."""

    code: str
    name: str
    severity: str
    n_found: int
    n_fixable: int


def rule_counts(outcome: RunOutcome) -> list[RuleCount]:
    """Return the rules with findings, the most frequent first."""
    by_rule: dict[str, list[Diagnostic]] = {}
    for file in outcome.files:
        for finding in file.findings:
            by_rule.setdefault(finding.code, []).append(finding)
    rows = (_rule_count(code, findings) for code, findings in by_rule.items())
    return sorted(rows, key=lambda row: (-row.n_found, row.code))


def _rule_count(code: str, findings: list[Diagnostic]) -> RuleCount:
    levels = list(Severity)
    worst = min((finding.severity for finding in findings), key=levels.index)
    n_fixable = sum(bool(finding.fix and finding.fix.is_safe) for finding in findings)
    return RuleCount(code, findings[0].name, worst.value, len(findings), n_fixable)


def render_text(outcome: RunOutcome) -> str:
    """Return a table; a star marks rules that `--fix` can fix."""
    rows = rule_counts(outcome)
    width = max((len(str(row.n_found)) for row in rows), default=0)
    return "".join(
        f"{row.n_found:{width}}  {row.code}  {'[*]' if row.n_fixable else '[ ]'} {row.name}\n"
        for row in rows
    )


def render_json(outcome: RunOutcome) -> str:
    """Return a JSON array."""
    import json

    rows = [
        {
            "code": row.code,
            "name": row.name,
            "severity": row.severity,
            "count": row.n_found,
            "fixable": row.n_fixable,
        }
        for row in rule_counts(outcome)
    ]
    return json.dumps(rows, indent=2) + "\n"
