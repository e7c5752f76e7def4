"""Findings as workflow commands of GitHub Actions, which shows them beside the lines."""

from collections.abc import Iterator

from kindsl.frontends.cli.outcome import LintedFile, RunOutcome
from kindsl.frontends.cli.output.project_paths import project_path
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.rules.base import Severity
from kindsl.language.text.printable import printable

_COMMANDS = {
    Severity.ERROR: "error",
    Severity.WARNING: "warning",
    Severity.INFORMATION: "notice",
    Severity.HINT: "notice",
}


def render(outcome: RunOutcome) -> str:
    """Return one command a line."""
    return "".join(_commands(outcome))


def _commands(outcome: RunOutcome) -> Iterator[str]:
    for file in outcome.files:
        path = project_path(file.path)
        for finding in file.findings:
            yield _command(file, path, finding)
    for failure in outcome.failures:
        properties = f"file={_property(project_path(failure.path))}"
        yield f"::error {properties},title=unreadable::{_data(failure.message)}\n"


def _command(file: LintedFile, path: str, finding: Diagnostic) -> str:
    line, column = file.place(finding.start)
    end_line, end_column = file.place(finding.end)
    properties = {"file": path, "line": str(line), "endLine": str(end_line)}
    if line == end_line:
        properties |= {"col": str(column), "endColumn": str(end_column)}
    properties["title"] = f"{finding.code} {finding.name}"
    listed = ",".join(f"{key}={_property(value)}" for key, value in properties.items())
    message = f"{path}:{line}:{column}: {finding.code} {printable(finding.message)}"
    return f"::{_COMMANDS[finding.severity]} {listed}::{_data(message)}\n"


def _data(text: str) -> str:
    return text.replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")


def _property(text: str) -> str:
    return _data(text).replace(":", "%3A").replace(",", "%2C")
