"""The formats for other programs, held to their schemas."""

import json
import os
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from lxml import etree
from tests.cli.conftest import Runner
from tests.cli.samples import GOOD, INTEGER, UNBOUND, arm
from tests.support.amount import usually

import kindsl
from kindsl.frontends.cli.outcome import Failure, LintedFile, RunOutcome
from kindsl.frontends.cli.output import FORMATS, renderer, sarif_format
from kindsl.judgement.analysis.diagnostics import Diagnostic, RelatedPlace
from kindsl.judgement.rules.base import Severity
from kindsl.judgement.rules.registry import all_rules

SCHEMAS = Path(__file__).parent / "schemas"
SARIF = jsonschema.Draft4Validator(json.loads((SCHEMAS / "sarif-2.1.0.json").read_text()))
JUNIT = etree.XMLSchema(etree.parse(SCHEMAS / "junit-10.xsd"))
GITLAB = jsonschema.Draft202012Validator(
    {
        "type": "array",
        "items": {
            "type": "object",
            "required": ["description", "check_name", "fingerprint", "severity", "location"],
            "properties": {
                "description": {"type": "string", "minLength": 1},
                "check_name": {"type": "string"},
                "fingerprint": {"type": "string", "pattern": "^[0-9a-f]{64}$"},
                "severity": {"enum": ["info", "minor", "major", "critical", "blocker"]},
                "location": {
                    "type": "object",
                    "required": ["path", "lines"],
                    "properties": {
                        "path": {"type": "string", "pattern": "^(?!\\./)"},
                        "lines": {
                            "type": "object",
                            "required": ["begin"],
                            "properties": {"begin": {"type": "integer", "minimum": 1}},
                        },
                    },
                },
            },
        },
    }
)


@pytest.fixture
def strange_folder(folder: Path) -> Path:
    """A folder with every kind of thing that a report can tell of."""
    (folder / "a b%,:é.kindsl").write_text(INTEGER)
    (folder / "unbound.kindsl").write_text(UNBOUND)
    (folder / "good.kindsl").write_text(GOOD)
    (folder / "twice.kindsl").write_text(GOOD.replace("id = 2", "id = 1"))
    (folder / "half.kindsl").write_text(GOOD[:300])
    (folder / "latin.kindsl").write_bytes(GOOD.replace("arm", "ärm").encode("latin-1"))
    (folder / "utf16.kindsl").write_bytes(GOOD.encode("utf-16"))
    (folder / "gone.kindsl").symlink_to("nowhere")
    return folder


def test_sarif_is_valid(kdsl_lint: Runner, strange_folder: Path) -> None:
    log = json.loads(kdsl_lint("--output-format", "sarif").out)
    SARIF.validate(log)
    (run,) = log["runs"]
    rules = run["tool"]["driver"]["rules"]
    assert [rule["id"] for rule in rules] == [rule.code for rule in all_rules()]
    for result in run["results"]:
        assert rules[result["ruleIndex"]]["id"] == result["ruleId"]
    notified = run["invocations"][0]
    assert notified["executionSuccessful"] is False
    (notification,) = notified["toolExecutionNotifications"]
    assert "broken symbolic link" in notification["message"]["text"]


def test_sarif_tells_place_fix_and_related_places(kdsl_lint: Runner, folder: Path) -> None:
    (folder / "a b.kindsl").write_text(INTEGER)
    (folder / "twice.kindsl").write_text(GOOD.replace("id = 2", "id = 1"))
    log = json.loads(kdsl_lint("--output-format", "sarif").out)
    by_rule = {result["ruleId"]: result for result in log["runs"][0]["results"]}
    integer = by_rule["KD005"]
    offset = INTEGER.index("(1,") + 1
    region = integer["locations"][0]["physicalLocation"]["region"]
    assert region == {
        "startLine": 21, "startColumn": 32, "endLine": 21, "endColumn": 33,
        "charOffset": offset, "charLength": 1,
    }  # fmt: skip
    place = integer["locations"][0]["physicalLocation"]["artifactLocation"]
    assert place == {"uri": "a%20b.kindsl", "uriBaseId": "SRCROOT"}
    assert log["runs"][0]["originalUriBaseIds"]["SRCROOT"]["uri"] == f"{folder.as_uri()}/"
    replacement = integer["fixes"][0]["artifactChanges"][0]["replacements"][0]
    assert replacement["insertedContent"]["text"] == ".0"
    assert by_rule["KD101"]["relatedLocations"][0]["physicalLocation"]["region"]["startLine"] == 7


def test_sarif_of_a_folder_whose_name_is_not_utf_8(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path / os.fsdecode(b"\xff")
    folder.mkdir()
    monkeypatch.chdir(folder)
    log = json.loads(renderer("sarif")(RunOutcome([LintedFile("arm.kindsl", GOOD, [])], [])))
    (run,) = log["runs"]
    assert run["originalUriBaseIds"]["SRCROOT"]["uri"] == f"{tmp_path.as_uri()}/%FF/"


def test_the_probability_of_a_cause_is_told() -> None:
    weighed = [
        Diagnostic("KD308", "inertia-scale", Severity.WARNING, "it", 0, 1, probability=p)
        for p in (0.93, None)
    ]
    outcome = RunOutcome([LintedFile("arm.kindsl", GOOD, weighed)], [])
    sarif = json.loads(renderer("sarif")(outcome))
    SARIF.validate(sarif)
    told, silent = sarif["runs"][0]["results"]
    assert told["properties"] == {"probability": 0.93}
    assert "properties" not in silent
    objects = json.loads(renderer("json")(outcome))
    assert [each["probability"] for each in objects] == [0.93, None]


def test_gitlab_is_valid_and_its_fingerprints_survive_moving_lines(
    kdsl_lint: Runner, strange_folder: Path
) -> None:
    issues = json.loads(kdsl_lint("--output-format", "gitlab").out)
    GITLAB.validate(issues)
    fingerprints = [issue["fingerprint"] for issue in issues]
    assert len(set(fingerprints)) == len(fingerprints)
    moved = strange_folder / "unbound.kindsl"
    moved.write_text(f"\n// moved\n\n{UNBOUND}")
    again = json.loads(kdsl_lint("--output-format", "gitlab").out)
    assert fingerprints == [issue["fingerprint"] for issue in again]


def test_paths_count_from_the_project_of_ci(
    kdsl_lint: Runner, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (folder / "models").mkdir()
    (folder / "models" / "arm.kindsl").write_text(INTEGER)
    monkeypatch.chdir(folder / "models")
    monkeypatch.setenv("CI_PROJECT_DIR", str(folder))
    (issue,) = json.loads(kdsl_lint("--output-format", "gitlab").out)
    assert issue["location"]["path"] == "models/arm.kindsl"


def test_junit_is_valid(kdsl_lint: Runner, strange_folder: Path) -> None:
    text = kdsl_lint("--output-format", "junit").out
    root = etree.fromstring(text.encode())
    JUNIT.assertValid(root)
    suites = {suite.get("name"): suite for suite in root}
    assert suites["good.kindsl"].get("failures") == "0"
    assert suites["unbound.kindsl"].find("testcase/skipped").get("type") == "warning"
    assert suites["utf16.kindsl"].find("testcase/failure").get("type") == "error"
    assert suites["gone.kindsl"].get("errors") == "1"
    assert int(root.get("tests")) == len(root.findall(".//testcase"))
    assert int(root.get("failures")) == len(root.findall(".//failure"))


def test_junit_fails_where_the_run_does(kdsl_lint: Runner, folder: Path) -> None:
    (folder / "unbound.kindsl").write_text(UNBOUND)
    for arguments in ((), ("--max-warnings", "0"), ("--max-warnings", "0", "--exit-zero")):
        run = kdsl_lint("--output-format", "junit", *arguments)
        root = etree.fromstring(run.out.encode())
        JUNIT.assertValid(root)
        assert bool(root.findall(".//failure")) == (run.status == 1)


def test_sarif_keeps_the_worst_of_more_findings_than_github_takes(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    assert sarif_format.MOST_RESULTS == 25_000
    monkeypatch.setattr(sarif_format, "MOST_RESULTS", 25)
    text = arm(reach="1")
    findings = kindsl.parse(text).findings
    worst = min(findings, key=lambda f: f.severity != "error")
    hint = worst._replace(severity=Severity.HINT)
    file = LintedFile("arm.kindsl", text, [*[hint] * 25, worst])
    (run,) = json.loads(renderer("sarif")(RunOutcome([file], [])))["runs"]
    assert len(run["results"]) == 25
    assert run["results"][0]["level"] == "error"
    (note,) = run["invocations"][0]["toolExecutionNotifications"]
    assert note["message"]["text"] == "1 further finding left out: GitHub takes 25"


def test_sarif_has_what_github_requires_within_its_limits() -> None:
    text = arm(reach="1")
    finding = kindsl.parse(text).findings[0]
    related = tuple(RelatedPlace(0, 5, "another") for _ in range(2000))
    file = LintedFile("arm.kindsl", text, [finding._replace(related=related, message="m" * 9000)])
    log = json.loads(renderer("sarif")(RunOutcome([file], [])))
    SARIF.validate(log)
    (run,) = log["runs"]
    for rule in run["tool"]["driver"]["rules"]:
        assert len(rule["name"]) <= 255
        assert 0 < len(rule["shortDescription"]["text"]) <= 1024
        assert 0 < len(rule["fullDescription"]["text"]) <= 1024
        assert rule["help"]["text"]
    (result,) = run["results"]
    assert len(result["message"]["text"]) <= 1024
    assert len(result["locations"]) + len(result["relatedLocations"]) <= 1000
    assert result["partialFingerprints"]
    region = result["locations"][0]["physicalLocation"]["region"]
    assert {"startLine", "startColumn", "endLine", "endColumn"} <= set(region)


def test_github_commands_are_escaped(kdsl_lint: Runner, strange_folder: Path) -> None:
    lines = kdsl_lint("--output-format", "github").out.splitlines()
    assert lines[0].startswith("::error file=a b%25%2C%3Aé.kindsl,line=21,endLine=21,col=32,")
    assert "title=KD005 invalid-number::a b%25,:é.kindsl:21:32: KD005 " in lines[0]
    assert all(line.startswith(("::error ", "::warning ", "::notice ")) for line in lines)
    assert any("utf16.kindsl" in line and "not UTF-8" in line for line in lines)


@pytest.mark.parametrize("name", FORMATS)
def test_nothing_to_report_is_a_report_too(name: str) -> None:
    text = renderer(name)(RunOutcome([], []))
    if name in ("json", "gitlab"):
        assert json.loads(text) == []
    elif name == "sarif":
        SARIF.validate(json.loads(text))
    elif name == "junit":
        JUNIT.assertValid(etree.fromstring(text.encode()))
    else:
        assert text == ""


@settings(
    max_examples=usually(50, thoroughly=150),
    deadline=None,
    suppress_health_check=[HealthCheck.function_scoped_fixture],
)
@given(
    text=st.text(max_size=60) | st.text(max_size=40).map(lambda junk: arm(reach=junk)),
    path=st.text(
        st.characters(exclude_characters="\0", exclude_categories=["Cs"]) | st.just("\udce4"),
        min_size=1,
        max_size=20,
    ),
)
def test_every_report_of_any_text_is_well_formed(text: str, path: str) -> None:
    file = LintedFile(path, text, kindsl.parse(text).findings)
    outcome = RunOutcome([file], [Failure(path, "is odd\n", 1, 1)])
    reports: dict[str, Any] = {name: renderer(name)(outcome) for name in FORMATS}
    for report in reports.values():
        report.encode()
    findings = json.loads(reports["json"])
    for finding, known in zip(findings, file.findings, strict=True):
        start = finding["start"]
        assert start["offset"] == known.start
        lines = text.replace("\r\n", "\n ").replace("\r", "\n").split("\n")
        assert start["column"] - 1 <= len(lines[start["line"] - 1]) + 1
    SARIF.validate(json.loads(reports["sarif"]))
    GITLAB.validate(json.loads(reports["gitlab"]))
    JUNIT.assertValid(etree.fromstring(reports["junit"].encode()))
    assert reports["text"].count("\n") >= 3 * len(findings)
