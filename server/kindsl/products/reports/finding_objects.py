"""Findings for programs, as plain objects; docs/ci.md describes them."""

from typing import Any

from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.analysis.text_fix import TextFix
from kindsl.language.text.lines import LineIndex
from kindsl.language.text.printable import printable


def finding_object(path: str, finding: Diagnostic, lines: LineIndex) -> dict[str, Any]:
    """Return a finding in the text of these lines, the path as it is shown.

    Lines and columns count from 1, offsets from 0, in code points.
    """
    return {
        "path": path,
        "code": finding.code,
        "name": finding.name,
        "severity": finding.severity.value,
        "message": printable(finding.message),
        "subject": {"kind": finding.subject.kind.value, "name": finding.subject.name},
        "probability": finding.probability,
        "start": position_object(lines, finding.start),
        "end": position_object(lines, finding.end),
        "related": [
            {
                "path": path,
                "start": position_object(lines, related.start),
                "end": position_object(lines, related.end),
                "message": printable(related.message),
            }
            for related in finding.related
        ],
        "fix": _fix(lines, finding.fix) if finding.fix else None,
        "url": finding.url,
    }


def _fix(lines: LineIndex, fix: TextFix) -> dict[str, Any]:
    return {
        "title": printable(fix.title),
        "safe": fix.is_safe,
        "edits": [
            {
                "start": position_object(lines, edit.start),
                "end": position_object(lines, edit.end),
                "text": edit.text,
            }
            for edit in fix.edits
        ],
    }


def position_object(lines: LineIndex, offset: int) -> dict[str, int]:
    """Return line and column of an offset from 1, and the offset from 0."""
    line, column = lines.place(offset)
    return {"line": line, "column": column, "offset": offset}
