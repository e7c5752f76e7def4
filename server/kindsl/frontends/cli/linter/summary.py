"""The summary line of a run."""

from kindsl.frontends.cli.outcome import RunOutcome
from kindsl.judgement.rules.base import Severity
from kindsl.language.text.phrases import counted


def summary(outcome: RunOutcome) -> str:
    """Return the line that counts documents, findings and safe fixes."""
    n_files = len(outcome.files)
    if not n_files and not outcome.failures:
        return "no documents (*.kindsl) found\n"
    line = f"{_counts(outcome) or 'no findings'} in {counted(n_files, 'document')}"
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


def _counts(outcome: RunOutcome) -> str:
    counts = ((severity, outcome.count(severity)) for severity in Severity)
    return ", ".join(counted(number, severity) for severity, number in counts if number)
