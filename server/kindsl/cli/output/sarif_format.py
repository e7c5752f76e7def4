"""Findings as SARIF 2.1.0, with the rules' pages, related places and fixes.

Of more findings than GitHub takes in one run, the worst are kept.
"""

import json
import os
from typing import Any
from urllib.parse import quote

from kindsl import __version__
from kindsl.analysis.diagnostics import Diagnostic, TextFix
from kindsl.cli.outcome import Failure, LintedFile, Outcome
from kindsl.cli.output.project_paths import fingerprints
from kindsl.cli.output.rule_pages import summary_of
from kindsl.rules.base import Rule, Severity
from kindsl.rules.registry import all_rules, page_of
from kindsl.text.printable import printable

_SCHEMA = "https://json.schemastore.org/sarif-2.1.0.json"
_LEVELS = {
    Severity.ERROR: "error",
    Severity.WARNING: "warning",
    Severity.INFORMATION: "note",
    Severity.HINT: "note",
}
_ROOT = "SRCROOT"
_ORDER = (Severity.ERROR, Severity.WARNING, Severity.INFORMATION, Severity.HINT)
# GitHub refuses a run with more results than this.
_MOST_RESULTS = 25_000


def render(outcome: Outcome) -> str:
    """Return a SARIF log with one run."""
    found = list(fingerprints(outcome))
    if len(found) > _MOST_RESULTS:
        found = sorted(found, key=lambda f: _ORDER.index(f[1].severity))[:_MOST_RESULTS]
    run = {
        "tool": {"driver": _driver()},
        "columnKind": "unicodeCodePoints",
        "originalUriBaseIds": {_ROOT: {"uri": f"file://{quote(os.getcwd())}/"}},
        "invocations": [_invocation(outcome)],
        "results": [_result(*each) for each in found],
    }
    return json.dumps({"$schema": _SCHEMA, "version": "2.1.0", "runs": [run]}, indent=2) + "\n"


def _driver() -> dict[str, Any]:
    return {
        "name": "kdsl-lint",
        "version": __version__,
        "rules": [_rule(rule) for rule in all_rules()],
    }


def _rule(rule: Rule) -> dict[str, Any]:
    page = page_of(rule)
    return {
        "id": rule.code,
        "name": "".join(word.capitalize() for word in rule.name.split("-")),
        "shortDescription": {"text": summary_of(rule)},
        "help": {"text": page, "markdown": page},
        "defaultConfiguration": {"level": _LEVELS[rule.severity], "enabled": rule.is_default},
    }


def _invocation(outcome: Outcome) -> dict[str, Any]:
    return {
        "executionSuccessful": not outcome.failures,
        "toolExecutionNotifications": [_notification(failure) for failure in outcome.failures],
    }


def _notification(failure: Failure) -> dict[str, Any]:
    place: dict[str, Any] = {"artifactLocation": _artifact(failure.path)}
    if failure.line is not None:
        place["region"] = {"startLine": failure.line, "startColumn": failure.column}
    return {
        "level": "error",
        "message": {"text": printable(failure.message)},
        "locations": [{"physicalLocation": place}],
    }


def _result(file: LintedFile, finding: Diagnostic, fingerprint: str) -> dict[str, Any]:
    codes = [rule.code for rule in all_rules()]
    result: dict[str, Any] = {
        "ruleId": finding.code,
        "ruleIndex": codes.index(finding.code),
        "level": _LEVELS[finding.severity],
        "message": {"text": printable(finding.message)},
        "locations": [{"physicalLocation": _place(file, finding.start, finding.end)}],
        "partialFingerprints": {"kindsl/v1": fingerprint},
    }
    if finding.related:
        result["relatedLocations"] = [
            {
                "id": number,
                "message": {"text": printable(related.message)},
                "physicalLocation": _place(file, related.start, related.end),
            }
            for number, related in enumerate(finding.related, 1)
        ]
    if finding.fix is not None and finding.fix.edits:
        result["fixes"] = [_fix(file, finding.fix)]
    return result


def _fix(file: LintedFile, fix: TextFix) -> dict[str, Any]:
    replacements = [
        {
            "deletedRegion": _region(file, edit.start, edit.end),
            "insertedContent": {"text": edit.text},
        }
        for edit in fix.edits
    ]
    change = {"artifactLocation": _artifact(file.path), "replacements": replacements}
    return {"description": {"text": printable(fix.title)}, "artifactChanges": [change]}


def _place(file: LintedFile, start: int, end: int) -> dict[str, Any]:
    return {"artifactLocation": _artifact(file.path), "region": _region(file, start, end)}


def _artifact(path: str) -> dict[str, str]:
    absolute = os.path.abspath(path)
    relative = os.path.relpath(absolute)
    if relative.startswith(".."):
        return {"uri": f"file://{_quoted(absolute)}"}
    return {"uri": _quoted(relative), "uriBaseId": _ROOT}


def _quoted(path: str) -> str:
    return quote(os.fsencode(path.replace(os.sep, "/")))


def _region(file: LintedFile, start: int, end: int) -> dict[str, int]:
    line, column = file.place(start)
    end_line, end_column = file.place(end)
    return {
        "startLine": line,
        "startColumn": column,
        "endLine": end_line,
        "endColumn": end_column,
        "charOffset": start,
        "charLength": end - start,
    }
