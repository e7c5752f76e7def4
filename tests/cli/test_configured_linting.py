"""How kindsl.toml and the command line decide together, and what is unused in the first."""

import json
from pathlib import Path

from tests.cli.conftest import Runner
from tests.cli.samples import GOOD, INTEGER, UNBOUND, arm


def test_configuration_above_the_document_holds(kdsl_lint: Runner, folder: Path) -> None:
    (folder / "sub").mkdir()
    (folder / "sub" / "a.kindsl").write_text(UNBOUND)
    assert "KD401" in kdsl_lint().out
    (folder / "kindsl.toml").write_text("[parameters]\nlength = 0.5\n")
    assert kdsl_lint().out == ""
    assert "KD401" in kdsl_lint("--isolated").out
    (folder / "other.toml").write_text('[severity]\nKD401 = "error"\n')
    told = kdsl_lint("--config", "other.toml")
    assert "error[KD401]" in told.out
    assert told.status == 1


def test_command_line_wins(kdsl_lint: Runner, folder: Path) -> None:
    (folder / "a.kindsl").write_text(UNBOUND)
    (folder / "kindsl.toml").write_text('ignore = ["KD4"]\n')
    assert kdsl_lint().out == ""
    assert "KD401" in kdsl_lint("--select", "KD4").out
    assert kdsl_lint("--ignore", "KD1").out == ""


def test_an_editors_settings_hold_where_the_configuration_says_nothing(
    kdsl_lint: Runner, folder: Path
) -> None:
    (folder / "a.kindsl").write_text(UNBOUND)
    editor = {"severity": {"KD401": "error"}, "target": ["robcogen2"], "diagnostics": {"delay": 9}}
    told = ("--editor-settings", json.dumps(editor))
    assert "error[KD401]" in kdsl_lint(*told).out
    (folder / "kindsl.toml").write_text('[severity]\nKD401 = "info"\n')
    assert "info[KD401]" in kdsl_lint(*told).out
    assert "error[KD401]" in kdsl_lint("--isolated", *told).out
    (folder / "kindsl.toml").unlink()
    assert kdsl_lint("--editor-settings", '{"parameters": {"length": 0.5}}').out == ""


def test_editor_settings_that_make_no_sense_are_told(kdsl_lint: Runner) -> None:
    told = kdsl_lint("--editor-settings", '{"target": ["c"]}')
    assert "setting 'kindsl.target': unknown target 'c' (known: robcogen, robcogen2)" in told.err
    assert told.status == 2
    assert "argument --editor-settings: '{' is not JSON" in kdsl_lint("--editor-settings", "{").err


def test_command_line_binds_over_configuration(kindsl: Runner, folder: Path) -> None:
    (folder / "a.kindsl").write_text(UNBOUND)
    (folder / "kindsl.toml").write_text("[parameters]\nlength = 0.5\n")
    (folder / "values.toml").write_text("[parameters]\nlength = 0.6\n")
    assert _value(kindsl("info", "a.kindsl", "--output-format", "json").out) == 0.5
    both = ("a.kindsl", "--params", "values.toml", "--output-format", "json")
    assert _value(kindsl("info", *both).out) == 0.6
    assert _value(kindsl("info", *both, "--param", "length=0.7").out) == 0.7


def _value(text: str) -> object:
    return json.loads(text)["parameters"][0]["value"]


def test_wrong_configuration_stops_only_its_documents(kdsl_lint: Runner, folder: Path) -> None:
    for name in ("broken", "fine"):
        (folder / name).mkdir()
        (folder / name / "a.kindsl").write_text(INTEGER)
        (folder / name / "b.kindsl").write_text(INTEGER)
    (folder / "broken" / "kindsl.toml").write_text("\ntargets = []\n")
    told = kdsl_lint()
    assert told.err.startswith(
        "broken/kindsl.toml:2:1: error: unknown key 'targets', did you mean 'target'?\n"
    )
    assert told.err.count("kindsl.toml") == 1
    assert "broken/a.kindsl" not in told.out
    assert told.out.startswith("fine/a.kindsl:21:32:")
    assert told.status == 2


def test_unused_binding_is_found_in_the_configuration(kdsl_lint: Runner, folder: Path) -> None:
    (folder / "a.kindsl").write_text(UNBOUND)
    (folder / "kindsl.toml").write_text("[parameters]\nlength = 0.5\n  lenght = 0.5\n")
    told = kdsl_lint()
    assert told.out.splitlines()[0].startswith("kindsl.toml:3:3: warning[KD404] ")
    assert told.status == 0
    assert kdsl_lint("--ignore", "KD404").out == ""
    assert kdsl_lint("--max-warnings", 0).status == 1


def test_what_other_documents_use_is_not_unused(kdsl_lint: Runner, folder: Path) -> None:
    (folder / "good.kindsl").write_text(GOOD)
    (folder / "sub").mkdir()
    (folder / "sub" / "other.kindsl").write_text(UNBOUND)
    (folder / "kindsl.toml").write_text("[parameters]\nlength = 0.5\n")
    assert kdsl_lint("good.kindsl").out == ""


def test_folders_of_tools_use_nothing_unless_they_are_asked_for(
    kdsl_lint: Runner, folder: Path
) -> None:
    (folder / "good.kindsl").write_text(GOOD)
    (folder / "build").mkdir()
    (folder / "build" / "other.kindsl").write_text(UNBOUND)
    (folder / "kindsl.toml").write_text("[parameters]\nlength = 0.5\n")
    assert "warning[KD404]" in kdsl_lint("good.kindsl").out
    assert kdsl_lint("good.kindsl", "--no-default-exclude").out == ""


def test_binding_for_some_documents_is_unused_by_the_others(
    kdsl_lint: Runner, folder: Path
) -> None:
    (folder / "a.kindsl").write_text(UNBOUND)
    (folder / "b.kindsl").write_text(arm())
    table = '[[document]]\npath = "{}"\nparameters = {{ length = 0.5 }}\n'
    (folder / "kindsl.toml").write_text(table.format("a.kindsl"))
    assert kdsl_lint().out == ""
    (folder / "kindsl.toml").write_text(table.format("b.kindsl"))
    told = kdsl_lint("--select", "KD404")
    assert told.out.startswith("kindsl.toml:3:16: warning[KD404] ")


def test_limit_of_a_joint_that_no_document_has(kdsl_lint: Runner, folder: Path) -> None:
    (folder / "a.kindsl").write_text(arm())
    table = "[joints.{}]\nmax = 1.0\n"
    (folder / "kindsl.toml").write_text(table.format("shoulder"))
    assert kdsl_lint("--select", "KD404").out == ""
    (folder / "kindsl.toml").write_text(table.format("sholder"))
    told = kdsl_lint("--select", "KD404").out
    assert told.startswith("kindsl.toml:1:9: warning[KD404] no document has a joint 'sholder'; did")
    one = '[[document]]\npath = "{}"\njoints.shoulder.min = 0.0\n'
    (folder / "kindsl.toml").write_text(one.format("a.kindsl"))
    assert kdsl_lint("--select", "KD404").out == ""
    (folder / "kindsl.toml").write_text(one.format("b.kindsl"))
    (folder / "b.kindsl").write_text(GOOD.replace("shoulder", "hip"))
    assert "no document that 'b.kindsl' names has a joint" in kdsl_lint("--select", "KD404").out


def test_pose_of_a_joint_that_no_document_has(kdsl_lint: Runner, folder: Path) -> None:
    (folder / "a.kindsl").write_text(arm())
    (folder / "kindsl.toml").write_text("[poses.home]\nshoulder = 1.0\nelbw = 0.5\n")
    told = kdsl_lint("--select", "KD404").out
    assert told.startswith("kindsl.toml:3:1: warning[KD404] no document has a joint 'elbw'; did")
    assert "shoulder" not in told


def test_binding_in_pyproject_is_told_there(kdsl_lint: Runner, folder: Path) -> None:
    (folder / "a.kindsl").write_text(GOOD)
    (folder / "pyproject.toml").write_text("[tool.kindsl.parameters]\nfree = 0.5\n")
    (finding,) = json.loads(kdsl_lint("--output-format", "json").out)
    assert finding["path"] == "pyproject.toml"
    assert finding["start"] == {"line": 2, "column": 1, "offset": 25}
    assert finding["end"]["column"] == 5


def test_stdin_tells_nothing_of_other_files(kdsl_lint: Runner, folder: Path, monkeypatch) -> None:  # type: ignore[no-untyped-def]
    from io import BytesIO, TextIOWrapper

    (folder / "kindsl.toml").write_text("[parameters]\nfree = 0.5\n")
    monkeypatch.setattr("sys.stdin", TextIOWrapper(BytesIO(GOOD.encode())))
    assert kdsl_lint("-").out == ""


def test_unused_parameter_of_the_command_line_is_told(kdsl_lint: Runner, folder: Path) -> None:
    (folder / "a.kindsl").write_text(UNBOUND)
    told = kdsl_lint("a.kindsl", "--param", "lenght=1", "--select", "KD1")
    assert told.err.startswith("warning: --param lenght: no document uses parameter 'lenght'")
    assert told.status == 0
    assert "warning: --param" not in kdsl_lint("a.kindsl", "--param", "length=1").err
    written = kdsl_lint("a.kindsl", "--param", "lenght=1", "--write-baseline", "known.json")
    assert "warning: --param lenght" in written.err
