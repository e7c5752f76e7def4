"""Findings for programs: a JSON array, described in docs/ci.md."""

import json

from kindsl.cli.outcome import RunOutcome
from kindsl.reports.finding_objects import finding_object
from kindsl.text.printable import printable


def render(outcome: RunOutcome) -> str:
    """Return a JSON array with one object a finding."""
    findings = [
        finding_object(printable(file.path), finding, file.lines)
        for file in outcome.files
        for finding in file.findings
    ]
    return json.dumps(findings, indent=2) + "\n"
