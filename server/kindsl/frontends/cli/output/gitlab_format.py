"""Findings as a GitLab Code Quality report."""

import json

from kindsl.frontends.cli.outcome import RunOutcome
from kindsl.frontends.cli.output.project_paths import fingerprints, project_path
from kindsl.judgement.rules.base import Severity
from kindsl.language.text.printable import printable

_SEVERITIES = {
    Severity.ERROR: "critical",
    Severity.WARNING: "major",
    Severity.INFORMATION: "minor",
    Severity.HINT: "info",
}


def render(outcome: RunOutcome) -> str:
    """Return a JSON array with one issue a finding."""
    issues = []
    for file, finding, fingerprint in fingerprints(outcome):
        start, end = file.place(finding.start), file.place(finding.end)
        issues.append(
            {
                "description": f"{finding.code} {printable(finding.message)}",
                "check_name": finding.code,
                "fingerprint": fingerprint,
                "severity": _SEVERITIES[finding.severity],
                "location": {
                    "path": project_path(file.path),
                    "lines": {"begin": start[0], "end": end[0]},
                    "positions": {
                        "begin": {"line": start[0], "column": start[1]},
                        "end": {"line": end[0], "column": end[1]},
                    },
                },
            }
        )
    return json.dumps(issues, indent=2) + "\n"
