"""`--statistics`: how often each rule found something."""

from collections import Counter
from typing import NamedTuple

from kindsl.cli.outcome import Outcome


class RuleCount(NamedTuple):
    """A rule's findings: how many, and how many of them a safe fix would mend."""

    code: str
    name: str
    severity: str
    n_found: int
    n_fixable: int


def rule_counts(outcome: Outcome) -> list[RuleCount]:
    """Return the rules that found something, the most frequent first."""
    findings = [finding for file in outcome.files for finding in file.findings]
    counts = Counter((f.code, f.name, f.severity.value) for f in findings)
    fixable = Counter(
        (f.code, f.name, f.severity.value) for f in findings if f.fix and f.fix.is_safe
    )
    found = [RuleCount(*key, count, fixable[key]) for key, count in counts.items()]
    return sorted(found, key=lambda row: (-row.n_found, row.code))


def render_text(outcome: Outcome) -> str:
    """Return a table; a star marks what `--fix` would mend."""
    rows = rule_counts(outcome)
    width = max((len(str(row.n_found)) for row in rows), default=0)
    return "".join(
        f"{row.n_found:{width}}  {row.code}  {'[*]' if row.n_fixable else '[ ]'} {row.name}\n"
        for row in rows
    )


def render_json(outcome: Outcome) -> str:
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
