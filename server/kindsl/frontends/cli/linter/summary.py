"""Counts of a run, in its last line and by rule, and the verdicts of the generators."""

from collections.abc import Sequence
from typing import Any

from kindsl.frontends.cli.outcome import LintedFile, RunOutcome
from kindsl.judgement.rules.base import Severity
from kindsl.language.text.groups import grouped
from kindsl.language.text.phrases import counted
from kindsl.language.text.printable import printable


def summary(outcome: RunOutcome) -> str:
    """Return the line that counts documents, findings and safe fixes."""
    n_files = len(outcome.files)
    if not n_files and not outcome.failures:
        return (
            "no documents (*.kindsl) found; a URDF or SDF is judged where it is named, "
            "in folders by 'include' in kindsl.toml\n"
        )
    numbers = ((severity, outcome.count(severity)) for severity in Severity)
    counts = ", ".join(counted(number, severity) for severity, number in numbers if number)
    line = f"{counts or 'no findings'} in {counted(n_files, 'document')}"
    if outcome.failures:
        line += f", {counted(len(outcome.failures), 'failure')}"
    n_known = sum(file.n_known for file in outcome.files)
    n_fixed = sum(file.n_fixed for file in outcome.files)
    n_fixable = sum(
        bool(finding.fix and finding.fix.is_safe)
        for file in outcome.files
        for finding in file.findings
    )
    line += f"; {n_known} known and silent" if n_known else ""
    line += f"; {n_fixed} fixed" if n_fixed else ""
    return line + (f"; {n_fixable} fixable with --fix\n" if n_fixable else "\n")


def verdict_lines(files: Sequence[LintedFile]) -> str:
    """Return a line for each generator, with the document's name where there are several."""
    documents = [file for file in files if file.verdicts]
    return "".join(
        f"{printable(f'{file.path}: ' if len(documents) > 1 else '')}{line}\n"
        for file in documents
        for line in file.verdicts
    )


def rule_counts(outcome: RunOutcome) -> list[dict[str, Any]]:
    """Return rules with their worst severity and how many findings they have, most first.

    Of the findings `count` are told and `fixable` have a safe fix.
    """
    by_rule = grouped((found.code, found) for file in outcome.files for found in file.findings)
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
