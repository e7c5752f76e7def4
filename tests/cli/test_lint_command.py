"""`kdsl-lint`: what is reported, and with which status."""

import io
import json
import re
from pathlib import Path

import pytest
from tests.cli.conftest import Runner
from tests.cli.samples import GOOD, INTEGER, UNBOUND, arm

from kindsl.frontends.cli import lint
from kindsl.frontends.cli.lint import only_paths

ROOT = Path(__file__).parents[2]


def test_clean_document_says_nothing_on_stdout(kdsl_lint: Runner, folder: Path) -> None:
    (folder / "good.kindsl").write_text(GOOD)
    told = kdsl_lint("good.kindsl")
    assert (told.status, told.out) == (0, "")
    assert told.err == "no findings in 1 document\n"


def test_error_exits_with_1_and_shows_the_place(kdsl_lint: Runner, folder: Path) -> None:
    (folder / "bad.kindsl").write_text(INTEGER)
    told = kdsl_lint("bad.kindsl")
    assert told.status == 1
    first, source, carets, fix = told.out.splitlines()
    assert first.startswith("bad.kindsl:21:32: error[KD005] ")
    assert (
        source == " 21 |     ref_frame { translation = (1, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) }"
    )
    assert carets.index("^") == source.index("(1,") + 1
    assert carets.count("^") == 1
    assert fix == "  fix: Write 1.0 (--fix)"


def test_json_is_exact(kdsl_lint: Runner, folder: Path) -> None:
    (folder / "bad.kindsl").write_text(INTEGER)
    told = kdsl_lint("bad.kindsl", "--output-format", "json")
    (finding,) = json.loads(told.out)
    offset = INTEGER.index("(1,") + 1
    message = finding.pop("message")
    assert message
    assert finding == {
        "path": "bad.kindsl",
        "code": "KD005",
        "name": "invalid-number",
        "severity": "error",
        "subject": {"kind": "joint", "name": "elbow"},
        "probability": None,
        "start": {"line": 21, "column": 32, "offset": offset},
        "end": {"line": 21, "column": 33, "offset": offset + 1},
        "related": [],
        "fix": {
            "title": "Write 1.0",
            "safe": True,
            "edits": [
                {
                    "start": {"line": 21, "column": 33, "offset": offset + 1},
                    "end": {"line": 21, "column": 33, "offset": offset + 1},
                    "text": ".0",
                }
            ],
        },
        "url": (ROOT / "docs" / "rules" / "kd005.md").as_uri(),
    }


def test_columns_count_code_points(kdsl_lint: Runner, folder: Path) -> None:
    text = INTEGER.replace(
        "    ref_frame { translation = (1", "/* 🤖é */ ref_frame { translation = (1"
    )
    (folder / "bad.kindsl").write_text(text)
    (finding,) = json.loads(kdsl_lint("bad.kindsl", "--output-format", "json").out)
    line = text.splitlines()[20]
    assert finding["start"]["column"] == line.index("(1,") + 2
    assert finding["start"]["offset"] == text.index("(1,") + 1


def test_warnings_fail_only_above_the_maximum(kdsl_lint: Runner, folder: Path) -> None:
    (folder / "one.kindsl").write_text(UNBOUND)
    assert kdsl_lint("one.kindsl").status == 0
    assert kdsl_lint("one.kindsl", "--max-warnings", 1).status == 0
    assert kdsl_lint("one.kindsl", "--max-warnings", 0).status == 1
    assert kdsl_lint("one.kindsl", "--max-warnings", 0, "--exit-zero").status == 0


def test_select_and_ignore(kdsl_lint: Runner, folder: Path) -> None:
    (folder / "one.kindsl").write_text(UNBOUND)
    assert "KD401" in kdsl_lint("one.kindsl", "--select", "kd4").out
    assert kdsl_lint("one.kindsl", "--select", "KD1,KD2").out == ""
    assert kdsl_lint("one.kindsl", "--ignore", "KD4").out == ""


def test_parameters_from_the_command_line_bind(kdsl_lint: Runner, folder: Path) -> None:
    (folder / "one.kindsl").write_text(UNBOUND)
    (folder / "values.toml").write_text("length = 0.5\n")
    assert kdsl_lint("one.kindsl", "--param", "length=0.5").out == ""
    assert kdsl_lint("one.kindsl", "--params", "values.toml").out == ""


def test_target_is_checked(kdsl_lint: Runner, folder: Path) -> None:
    (folder / "one.kindsl").write_text(GOOD.replace("0.5,", "1e-3,"))
    assert "KD601" in kdsl_lint("one.kindsl", "--target", "robcogen").out
    assert kdsl_lint("one.kindsl", "--target", "robcogen2").out == ""


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        *(
            ([option, ""], f"argument {option}: is empty")
            for option in ("--select", "--ignore", "--target", "--config", "--params")
        ),
        (["--select", "KD1,"], "argument --select: 'KD1,' has an empty element"),
        (["--target", " ,robcogen"], "argument --target: ' ,robcogen' has an empty element"),
        (["--select", "KD98"], "no rule has a code that begins with 'KD98'"),
        (["--target", "robcogn"], "unknown target 'robcogn', did you mean 'robcogen'?"),
        (["--param", "x"], "'x' is not NAME=VALUE"),
        (["--param", "x=nan"], "'nan', the value of 'x', is not a number"),
        (["--max-warnings", "-1"], "--max-warnings"),
        (["--isolated", "--config", "x.toml"], "not allowed with argument"),
        (["--statistics", "--output-format", "sarif"], "--statistics"),
        (["--unsafe-fixes"], "--unsafe-fixes needs --fix or --diff"),
        (["--watch", "-"], "--watch cannot watch stdin"),
        (["--config", "missing.toml"], "missing.toml:1:1: error: cannot be read"),
        (["--params", "missing.toml"], "missing.toml:1:1: error: cannot be read"),
        (["--explain", "KD99"], "no rule 'KD99'"),
        (["--frobnicate"], "unrecognized arguments: --frobnicate"),
    ],
)
def test_wrong_usage_exits_with_2(kdsl_lint: Runner, arguments: list[str], told: str) -> None:
    result = kdsl_lint(*arguments)
    assert result.status == 2
    assert result.out == ""
    assert told in result.err


def test_statistics_count_by_rule(kdsl_lint: Runner, folder: Path) -> None:
    (folder / "a.kindsl").write_text(INTEGER)
    (folder / "b.kindsl").write_text(INTEGER)
    told = kdsl_lint("--statistics")
    assert told.out == "2  KD005  [*] invalid-number\n"
    assert told.status == 1
    assert json.loads(kdsl_lint("--statistics", "--output-format", "json").out) == [
        {"code": "KD005", "name": "invalid-number", "severity": "error", "count": 2, "fixable": 2}
    ]


def test_quiet_leaves_the_findings_alone(kdsl_lint: Runner, folder: Path) -> None:
    (folder / "a.kindsl").write_text(INTEGER)
    told = kdsl_lint("--quiet", "a.kindsl")
    assert told.out.startswith("a.kindsl:21:32:")
    assert told.err == ""


def test_summary_says_what_fix_would_do(kdsl_lint: Runner, folder: Path) -> None:
    (folder / "a.kindsl").write_text(INTEGER)
    (folder / "b.kindsl").write_text(UNBOUND)
    err = kdsl_lint().err
    assert err == "1 error, 1 warning in 2 documents; 1 fixable with --fix\n"


def test_explain_shows_a_page(kdsl_lint: Runner) -> None:
    told = kdsl_lint("--explain", "kd301")
    assert told.status == 0
    assert told.out.startswith("# inertia-not-positive-definite (KD301)\n\nSeverity: error")
    assert "## Why is this bad?" in told.out
    page = json.loads(kdsl_lint("--explain", "KD301", "--output-format", "json").out)
    assert page["code"] == "KD301"
    assert "## Why is this bad?" in page["explanation"]
    assert kdsl_lint("--explain", "duplicate-link-id").out.startswith("# duplicate-link-id (KD101)")


def test_list_rules_tells_all(kdsl_lint: Runner) -> None:
    lines = kdsl_lint("--list-rules").out.splitlines()
    rules = json.loads(kdsl_lint("--list-rules", "--output-format", "json").out)
    assert [line[:5] for line in lines] == [rule["code"] for rule in rules]
    assert rules == sorted(rules, key=lambda rule: rule["code"])
    assert all(re.fullmatch(r"KD\d{3}", rule["code"]) for rule in rules)
    assert all(rule["summary"].endswith(".") for rule in rules)


def test_colour_when_forced_and_never_when_unwanted(
    kdsl_lint: Runner, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (folder / "a.kindsl").write_text(INTEGER)
    assert "\x1b[" not in kdsl_lint("a.kindsl").out
    monkeypatch.setenv("FORCE_COLOR", "1")
    assert "\x1b[1;31merror[KD005]\x1b[0m" in kdsl_lint("a.kindsl").out
    monkeypatch.setenv("NO_COLOR", "1")
    assert "\x1b[" not in kdsl_lint("a.kindsl").out


def test_text_cannot_drive_the_terminal(kdsl_lint: Runner, folder: Path) -> None:
    (folder / "a.kindsl").write_text(INTEGER.replace("Robot arm", "Robot \x1b[2Jarm"))
    assert "\x1b" not in kdsl_lint("a.kindsl").out


def test_related_places_are_told(kdsl_lint: Runner, folder: Path) -> None:
    (folder / "a.kindsl").write_text(GOOD.replace("id = 2", "id = 1"))
    told = kdsl_lint("a.kindsl", "--select", "KD101")
    assert re.search(r"^a\.kindsl:7:\d+: note: ", told.out, re.MULTILINE)
    (finding,) = json.loads(
        kdsl_lint("a.kindsl", "--select", "KD101", "--output-format", "json").out
    )
    related = finding["related"][0]
    assert related["path"] == "a.kindsl"
    assert related["start"]["line"] == 7
    assert set(related) == {"path", "start", "end", "message"}


def test_folders_of_tools_are_linted_when_asked_for(kdsl_lint: Runner, folder: Path) -> None:
    (folder / ".venv").mkdir()
    (folder / ".venv" / "a.kindsl").write_text(INTEGER)
    assert kdsl_lint().out == ""
    assert kdsl_lint("--no-default-exclude").out.startswith(".venv/a.kindsl:21:32: error[KD005]")
    assert kdsl_lint(".venv").out.startswith(".venv/a.kindsl:21:32: error[KD005]")


def test_stdin_with_a_name(kdsl_lint: Runner, monkeypatch: pytest.MonkeyPatch) -> None:
    _feed(monkeypatch, INTEGER)
    assert kdsl_lint("-").out.startswith("<stdin>:21:32: ")
    _feed(monkeypatch, INTEGER)
    assert kdsl_lint("-", "--stdin-filename", "arm.kindsl").out.startswith("arm.kindsl:21:32: ")


def test_stdin_is_configured_by_its_name(
    kdsl_lint: Runner, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (folder / "models").mkdir()
    (folder / "models" / "kindsl.toml").write_text("[parameters]\nlength = 1.0\n")
    _feed(monkeypatch, UNBOUND)
    assert "KD401" in kdsl_lint("-").out
    _feed(monkeypatch, UNBOUND)
    assert kdsl_lint("-", "--stdin-filename", "models/a.kindsl").out == ""


def _feed(monkeypatch: pytest.MonkeyPatch, text: str) -> None:
    from io import BytesIO, TextIOWrapper

    monkeypatch.setattr("sys.stdin", TextIOWrapper(BytesIO(text.encode())))


def test_paths_alone_mean_what_the_parser_says() -> None:
    import argparse

    parser = argparse.ArgumentParser()
    lint.add_arguments(parser)
    options = only_paths(["a.kindsl", "-"])
    assert options is not None
    for name, value in vars(parser.parse_args(["a.kindsl", "-"])).items():
        own = getattr(options, name)
        assert own == value or not (own or value), name
    assert only_paths(["a.kindsl", "-q"]) is None


def test_repeated_findings_are_told_as_one(kdsl_lint: Runner, folder: Path) -> None:
    text = arm(reach="1e-7").replace("(0.0, 0.0, 0.5)", "(1e-7, 2.5e-7, 0.5)")
    (folder / "a.kindsl").write_text(text)
    many = ("--select", "KD507", "--target", "robcogen2", "a.kindsl")
    told = kdsl_lint(*many)
    assert told.out.count("[KD507]") == 1
    assert told.out.endswith("  and 2 more like it in lines 18, 21 (--verbose lists them)\n")
    assert "3 warnings" in told.err
    assert kdsl_lint(*many, "--verbose").out.count("warning[KD507]") == 3
    assert len(json.loads(kdsl_lint(*many, "--output-format", "json").out)) == 3
    assert kdsl_lint(*many, "--max-warnings", 2).status == 1


def test_two_of_a_kind_and_unlike_errors_are_told_one_by_one(
    kdsl_lint: Runner, folder: Path
) -> None:
    (folder / "a.kindsl").write_text(arm().replace("(0.0, 0.0, 0.5)", "(1e-7, 0.0, 0.5)"))
    assert kdsl_lint("--select", "KD507", "--target", "robcogen2").out.count("[KD507]") == 2
    text = GOOD.replace("p_joint elbow {", "p_joint elbow { }").replace("id = 2", "id == 2")
    (folder / "a.kindsl").write_text(text.replace("mass = 1.0", "mass 1.0"))
    told = kdsl_lint()
    assert told.out.count("error[KD001]") > 1
    assert "more like it" not in told.out


def test_verdicts_are_of_each_document_as_it_is_after_fixes(
    kdsl_lint: Runner, folder: Path
) -> None:
    (folder / "a.kindsl").write_text(arm())
    (folder / "b.kindsl").write_text(arm().replace("r_joint", "r_jiont"))
    (folder / "t.dtdsl").write_text("Robot arm\nFrames {}\nTransforms {}\n")
    reads = "a.kindsl: robcogen reads it\na.kindsl: robcogen2 reads it\n"
    assert kdsl_lint("--verbose", ".").err.endswith(
        f"{reads}b.kindsl: robcogen refuses it, 1 place\nb.kindsl: robcogen2 refuses it, 1 place\n"
    )
    mended = kdsl_lint("--verbose", "--fix", "--unsafe-fixes", "--write-baseline", "k.json", ".")
    assert mended.err.endswith(f"{reads}{reads.replace('a.', 'b.')}")
    assert kdsl_lint("--verbose", "a.kindsl").err.endswith(
        "\nrobcogen reads it\nrobcogen2 reads it\n"
    )


def test_no_generator_has_a_verdict_on_a_urdf(
    kdsl_lint: Runner, monkeypatch: pytest.MonkeyPatch
) -> None:
    content = b'<robot name="arm"><link name="base"/></robot>'
    monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(content)))
    told = kdsl_lint("-v", "-")
    assert (told.status, told.out) == (0, "") and "robcogen" not in told.err
