"""`--statistics`: how often each rule found something."""

from collections import Counter
from typing import NamedTuple

from kindsl.cli.outcome import Outcome


class RuleCount(NamedTuple):
    """A rule's findings: how many, and how many of them a safe fix would mend."""

    code: str
    name: str
    severity: str
    count: int
    fixable: int


def rule_counts(outcome: Outcome) -> list[RuleCount]:
    """Return the rules that found something, the most frequent first."""
    findings = [finding for file in outcome.files for finding in file.findings]
    counts = Counter((f.code, f.name, f.severity.value) for f in findings)
    fixable = Counter(
        (f.code, f.name, f.severity.value) for f in findings if f.fix and f.fix.is_safe
    )
    found = [RuleCount(*key, count, fixable[key]) for key, count in counts.items()]
    return sorted(found, key=lambda row: (-row.count, row.code))


def render_text(outcome: Outcome) -> str:
    """Return a table; a star marks what `--fix` would mend."""
    rows = rule_counts(outcome)
    width = max((len(str(row.count)) for row in rows), default=0)
    return "".join(
        f"{row.count:{width}}  {row.code}  {'[*]' if row.fixable else '[ ]'} {row.name}\n"
        for row in rows
    )


def render_json(outcome: Outcome) -> str:
    """Return a JSON array."""
    import json

    return json.dumps([row._asdict() for row in rule_counts(outcome)], indent=2) + "\n"
