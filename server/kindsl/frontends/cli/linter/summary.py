"""The last lines of a run: its summary, and the verdicts of the generators if it is verbose."""

from collections.abc import Iterator, Sequence

from kindsl.frontends.cli.outcome import LintedFile, RunOutcome
from kindsl.judgement.config.robots import SUFFIX
from kindsl.judgement.rules.base import Severity
from kindsl.language.text.phrases import counted
from kindsl.language.text.printable import printable


def summary(outcome: RunOutcome) -> str:
    """Return the line that counts documents, findings and safe fixes."""
    n_files = len(outcome.files)
    if not n_files and not outcome.failures:
        return "no documents (*.kindsl) found\n"
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
    documents = [
        file
        for file in files
        if file.path.endswith(SUFFIX) or "." not in file.path.rpartition("/")[2]
    ]
    return "".join(
        f"{printable(f'{file.path}: ' if len(documents) > 1 else '')}{line}\n"
        for file in documents
        for line in _verdicts(file)
    )


def _verdicts(file: LintedFile) -> Iterator[str]:
    from kindsl.judgement.analysis.analysis import Analysis
    from kindsl.judgement.analysis.verdicts import verdicts
    from kindsl.robots.interchange.syntaxes import syntax_of

    syntax = syntax_of(file.path, file.text)
    return iter(()) if syntax.is_xml else map(str, verdicts(Analysis(syntax)))
