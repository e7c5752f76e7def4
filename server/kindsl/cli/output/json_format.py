"""Findings for programs: a JSON array, described in docs/ci.md."""

import json
from typing import Any

from kindsl.analysis.diagnostics import Diagnostic
from kindsl.analysis.text_fix import TextFix
from kindsl.cli.outcome import LintedFile, RunOutcome
from kindsl.text.printable import printable


def render(outcome: RunOutcome) -> str:
    """Return a JSON array with one object a finding."""
    findings = [
        finding_object(file, finding) for file in outcome.files for finding in file.findings
    ]
    return json.dumps(findings, indent=2) + "\n"


def finding_object(file: LintedFile, finding: Diagnostic) -> dict[str, Any]:
    """Return a finding; lines and columns from 1, offsets from 0, in code points."""
    path = printable(file.path)
    return {
        "path": path,
        "code": finding.code,
        "name": finding.name,
        "severity": finding.severity.value,
        "message": printable(finding.message),
        "start": _position(file, finding.start),
        "end": _position(file, finding.end),
        "related": [
            {
                "path": path,
                "start": _position(file, related.start),
                "end": _position(file, related.end),
                "message": printable(related.message),
            }
            for related in finding.related
        ],
        "fix": _fix(file, finding.fix) if finding.fix else None,
        "url": finding.url,
    }


def _fix(file: LintedFile, fix: TextFix) -> dict[str, Any]:
    return {
        "title": printable(fix.title),
        "safe": fix.is_safe,
        "edits": [
            {
                "start": _position(file, edit.start),
                "end": _position(file, edit.end),
                "text": edit.text,
            }
            for edit in fix.edits
        ],
    }


def _position(file: LintedFile, offset: int) -> dict[str, int]:
    line, column = file.place(offset)
    return {"line": line, "column": column, "offset": offset}
