"""Findings for programs: a JSON array, described in docs/ci.md."""

import json

from kindsl.frontends.cli.outcome import RunOutcome
from kindsl.language.text.printable import printable
from kindsl.products.reports.finding_objects import finding_object


def render(outcome: RunOutcome) -> str:
    """Return a JSON array with one object a finding."""
    findings = [
        finding_object(printable(file.path), finding, file.lines)
        for file in outcome.files
        for finding in file.findings
    ]
    return json.dumps(findings, indent=2) + "\n"
