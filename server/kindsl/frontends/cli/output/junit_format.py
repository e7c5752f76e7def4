"""Findings as JUnit XML: each document is a test suite, each error a failed test.

Only what makes the run fail is a failure; another warning is a skipped test, the rest is output.
"""

import xml.etree.ElementTree as ET

from kindsl.frontends.cli.outcome import Failure, LintedFile, RunOutcome
from kindsl.frontends.cli.output.project_paths import project_path
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.rules.base import Severity
from kindsl.language.text.printable import printable


def render(outcome: RunOutcome) -> str:
    """Return an XML document."""
    suites = [_suite(file, outcome.failing) for file in outcome.files]
    suites += [_failed_suite(failure) for failure in outcome.failures]
    root = ET.Element("testsuites", {"name": "kdsl-lint", **_sums(suites)})
    root.extend(suites)
    ET.indent(root)
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{ET.tostring(root, encoding="unicode")}\n'


def _suite(file: LintedFile, failing: frozenset[Severity]) -> ET.Element:
    cases = [_case(file, finding, failing) for finding in file.findings]
    cases = cases or [ET.Element("testcase", {"name": "no findings", **_class(file.path)})]
    n_failures = sum(case.find("failure") is not None for case in cases)
    return _with_counts(file.path, cases, n_failures, 0)


def _case(file: LintedFile, finding: Diagnostic, failing: frozenset[Severity]) -> ET.Element:
    line, column = file.place(finding.start)
    message = printable(finding.message)
    case = ET.Element(
        "testcase", {"name": f"{finding.code} {finding.name} {line}:{column}", **_class(file.path)}
    )
    text = f"{project_path(file.path)}:{line}:{column}: {finding.severity.value}: {message}"
    attributes = {"message": message, "type": finding.severity.value}
    if finding.severity in failing:
        ET.SubElement(case, "failure", attributes).text = text
    elif finding.severity is Severity.WARNING:
        ET.SubElement(case, "skipped", attributes).text = text
    else:
        ET.SubElement(case, "system-out").text = text
    return case


def _failed_suite(failure: Failure) -> ET.Element:
    case = ET.Element("testcase", {"name": "readable", **_class(failure.path)})
    message = printable(failure.message)
    ET.SubElement(case, "error", {"message": message, "type": "unreadable"}).text = printable(
        str(failure)
    )
    return _with_counts(failure.path, [case], 0, 1)


def _with_counts(path: str, cases: list[ET.Element], n_failures: int, n_errors: int) -> ET.Element:
    counts = {"tests": str(len(cases)), "failures": str(n_failures), "errors": str(n_errors)}
    suite = ET.Element("testsuite", {"name": project_path(path), **counts})
    suite.extend(cases)
    return suite


def _class(path: str) -> dict[str, str]:
    return {"classname": project_path(path)}


def _sums(suites: list[ET.Element]) -> dict[str, str]:
    return {
        count: str(sum(int(suite.get(count, "0")) for suite in suites))
        for count in ("tests", "failures", "errors")
    }
