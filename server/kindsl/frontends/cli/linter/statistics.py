"""`--statistics`: the number of findings of each rule."""

from typing import Any

from kindsl.frontends.cli.outcome import RunOutcome
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.rules.base import Severity


def rule_counts(outcome: RunOutcome) -> list[dict[str, Any]]:
    """Return rules with their worst severity and how many findings they have, most first.

    Of the findings `count` are told and `fixable` have a safe fix.
    """
    by_rule: dict[str, list[Diagnostic]] = {}
    for file in outcome.files:
        for finding in file.findings:
            by_rule.setdefault(finding.code, []).append(finding)
    rows = [
        {
            "code": code,
            "name": findings[0].name,
            "severity": min((f.severity for f in findings), key=list(Severity).index).value,
            "count": len(findings),
            "fixable": sum(bool(f.fix and f.fix.is_safe) for f in findings),
        }
        for code, findings in by_rule.items()
    ]
    return sorted(rows, key=lambda row: (-row["count"], row["code"]))


def statistics(outcome: RunOutcome, *, is_json: bool) -> str:
    """Return a JSON array, or a table in which a star marks rules that `--fix` can fix."""
    rows = rule_counts(outcome)
    if is_json:
        import json

        return json.dumps(rows, indent=2) + "\n"
    width = max((len(str(row["count"])) for row in rows), default=0)
    form = f"{{count:{width}}}  {{code}}  [{{star}}] {{name}}\n"
    return "".join(form.format(star="*" if row["fixable"] else " ", **row) for row in rows)
