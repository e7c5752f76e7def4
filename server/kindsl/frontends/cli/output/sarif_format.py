"""Findings as SARIF 2.1.0, with the rules' pages, related places and fixes.

GitHub's limits hold: of more findings than it takes in one run the worst are kept, of more related
places the first, and long texts are cut; a notification tells how many findings are left out.
"""

import json
import os
from typing import Any
from urllib.parse import quote

from kindsl import __version__
from kindsl.frontends.cli.outcome import Failure, LintedFile, RunOutcome
from kindsl.frontends.cli.output.project_paths import fingerprints
from kindsl.frontends.cli.output.rule_pages import summary_of
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.analysis.text_fix import TextFix
from kindsl.judgement.rules.base import Rule, Severity
from kindsl.judgement.rules.registry import all_rules, page_of
from kindsl.language.text.phrases import counted
from kindsl.language.text.printable import printable

_SCHEMA = "https://json.schemastore.org/sarif-2.1.0.json"
_LEVELS = {
    Severity.ERROR: "error",
    Severity.WARNING: "warning",
    Severity.INFORMATION: "note",
    Severity.HINT: "note",
}
_ROOT = "SRCROOT"
_ORDER = list(_LEVELS)
# GitHub refuses a run with more results than this, shows so many places of one result, and takes
# names and descriptions of that length.
MOST_RESULTS = 25_000
_MOST_PLACES = 100
_LONGEST_TEXT = 1024


def render(outcome: RunOutcome) -> str:
    """Return a SARIF log with one run."""
    found = list(fingerprints(outcome))
    n_found = len(found)
    if len(found) > MOST_RESULTS:
        found = sorted(found, key=lambda f: _ORDER.index(f[1].severity))[:MOST_RESULTS]
    rules = [_rule(rule) for rule in all_rules()]
    run = {
        "tool": {"driver": {"name": "kdsl-lint", "version": __version__, "rules": rules}},
        "columnKind": "unicodeCodePoints",
        "originalUriBaseIds": {_ROOT: {"uri": f"file://{_quoted(os.getcwd())}/"}},
        "invocations": [_invocation(outcome, n_found - len(found))],
        "results": [_result(*each) for each in found],
    }
    return json.dumps({"$schema": _SCHEMA, "version": "2.1.0", "runs": [run]}, indent=2) + "\n"


def _rule(rule: Rule) -> dict[str, Any]:
    page = page_of(rule)
    purpose = page.partition("## What it does")[2].partition("\n## ")[0]
    return {
        "id": rule.code,
        "name": "".join(word.capitalize() for word in rule.name.split("-")),
        "shortDescription": {"text": _shortened(summary_of(rule))},
        "fullDescription": {"text": _shortened(" ".join(purpose.split()))},
        "help": {"text": page, "markdown": page},
        "defaultConfiguration": {"level": _LEVELS[rule.severity], "enabled": rule.is_default},
    }


def _shortened(text: str) -> str:
    return text if len(text) <= _LONGEST_TEXT else text[: _LONGEST_TEXT - 3] + "..."


def _invocation(outcome: RunOutcome, n_left_out: int) -> dict[str, Any]:
    notifications = [_notification(failure) for failure in outcome.failures]
    if n_left_out:
        text = f"{counted(n_left_out, 'further finding')} left out: GitHub takes {MOST_RESULTS}"
        notifications.append({"level": "note", "message": {"text": text}})
    return {
        "executionSuccessful": not outcome.failures,
        "toolExecutionNotifications": notifications,
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
        "message": {"text": _shortened(printable(finding.message))},
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
            for number, related in enumerate(finding.related[:_MOST_PLACES], 1)
        ]
    if finding.probability is not None:
        result["properties"] = {"probability": finding.probability}
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
