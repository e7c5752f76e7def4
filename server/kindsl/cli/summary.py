"""The last line of a run, for people."""

from kindsl.cli.outcome import Outcome
from kindsl.rules.base import Severity


def summary(outcome: Outcome) -> str:
    """Return a line that counts documents and findings, and tells what `--fix` could do."""
    n_files = len(outcome.files)
    if not n_files and not outcome.failures:
        return "no documents (*.kindsl) found\n"
    counts = [
        counted(outcome.count(Severity.ERROR), "error"),
        counted(outcome.count(Severity.WARNING), "warning"),
        counted(_n_remarks(outcome), "remark"),
    ]
    told = ", ".join(text for text in counts if not text.startswith("0 ")) or "no findings"
    line = f"{told} in {counted(n_files, 'document')}"
    if outcome.failures:
        line += f", {counted(len(outcome.failures), 'failure')}"
    n_fixed = sum(file.n_fixed for file in outcome.files)
    if n_fixed:
        line += f"; {n_fixed} fixed"
    n_fixable = sum(
        bool(finding.fix and finding.fix.is_safe)
        for file in outcome.files
        for finding in file.findings
    )
    if n_fixable:
        line += f"; {n_fixable} can be mended with --fix"
    return line + "\n"


def counted(number: int, noun: str) -> str:
    """Return a number with its noun, in the plural unless it is one."""
    return f"{number} {noun}" if number == 1 else f"{number} {noun}s"


def _n_remarks(outcome: Outcome) -> int:
    return outcome.count(Severity.INFORMATION) + outcome.count(Severity.HINT)
