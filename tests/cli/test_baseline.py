"""`--write-baseline`, and `baseline` in a configuration file."""

import io
import json
from pathlib import Path

import pytest
from tests.cli.conftest import Runner
from tests.cli.samples import GOOD, INTEGER, UNBOUND, arm

TOML = 'baseline = "known.json"\n'
OTHER = "link lower {\n    id = 2\n    inertia_params { mass = 1.0"
TRANSFORMS = """Robot arm
Frames {
    fr_nowhere,
    fr_lower
}
Transforms {
    base=fr_lower, target=fr_lower
}
"""
HEAVIER = OTHER.replace("1.0", "-1.0")


@pytest.fixture
def known(kdsl_lint: Runner, folder: Path) -> Path:
    """A document with one warning, in a joint, that its baseline knows."""
    path = folder / "a.kindsl"
    path.write_text(UNBOUND)
    (folder / "kindsl.toml").write_text(TOML)
    told = kdsl_lint("--write-baseline", "known.json")
    assert (told.status, told.out) == (0, "")
    assert told.err == (
        "1 known finding written to known.json\nno findings in 1 document; 1 known and silent\n"
    )
    return path


def test_known_findings_are_silent_and_counted(kdsl_lint: Runner, known: Path) -> None:
    told = kdsl_lint("--max-warnings", 0)
    assert (told.status, told.out) == (0, "")
    assert told.err == "no findings in 1 document; 1 known and silent\n"
    assert kdsl_lint("--isolated", "--max-warnings", 0).status == 1


@pytest.mark.parametrize("name", ("json", "sarif", "gitlab", "github", "junit"))
def test_every_format_leaves_them_out(kdsl_lint: Runner, known: Path, name: str) -> None:
    assert "KD401" in kdsl_lint("--isolated", "--output-format", name, "a.kindsl").out
    told = kdsl_lint("--output-format", name, "a.kindsl")
    assert '"ruleId": "KD401"' not in told.out
    assert name == "sarif" or "KD401" not in told.out


def test_other_blocks_blanks_and_remarks_do_not_wake_them(kdsl_lint: Runner, known: Path) -> None:
    for old, new in (
        ("Robot arm", "// moved\n\n\nRobot arm"),
        ("(length, 0.0, 0.0)", "( length,0.0,  0.0 ) // a remark"),
        (OTHER, OTHER.replace("1.0", "1.25")),
    ):
        assert old in UNBOUND
        known.write_text(UNBOUND.replace(old, new))
        assert "KD401" not in kdsl_lint().out


def test_a_change_of_their_block_wakes_them(kdsl_lint: Runner, known: Path) -> None:
    known.write_text(UNBOUND.replace("(length, 0.0", "(length, 0.25"))
    told = kdsl_lint()
    assert "KD401" in told.out
    assert "known and silent" not in told.err
    assert told.err.startswith(
        "known.json: warning: stale baseline: it has 1 finding that is no longer there, "
        "write it anew with --write-baseline\n"
    )


def test_another_finding_beside_them_is_told(kdsl_lint: Runner, known: Path) -> None:
    known.write_text(UNBOUND.replace(OTHER, HEAVIER))
    told = kdsl_lint()
    assert (told.status, told.out.count("error[")) == (1, 1)
    assert "KD401" not in told.out
    assert "1 known and silent" in told.err


def test_the_same_mistake_twice_is_one_more(kdsl_lint: Runner, folder: Path, known: Path) -> None:
    known.write_text(UNBOUND.replace("(length, 0.0, 0.0)", "(length, length2, 0.0)"))
    kdsl_lint("--write-baseline", "known.json")
    assert kdsl_lint().err.endswith("2 known and silent\n")
    assert len(json.loads((folder / "known.json").read_text())["documents"]["a.kindsl"]) == 2


def test_baseline_lies_beside_its_configuration(
    kdsl_lint: Runner, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("first", "second"):
        (folder / "models" / name).mkdir(parents=True)
        (folder / "models" / name / "a.kindsl").write_text(UNBOUND)
    (folder / "models" / "pyproject.toml").write_text(f"[tool.kindsl]\n{TOML}")
    kdsl_lint("--write-baseline", "models/known.json", "models/first")
    assert kdsl_lint().out.count("KD401") == 1
    monkeypatch.chdir(folder / "models" / "first")
    assert "1 known and silent" in kdsl_lint().err


def test_stdin_is_known_by_its_name(
    kdsl_lint: Runner, known: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name, count in (("a.kindsl", 0), ("b.kindsl", 1)):
        monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(UNBOUND.encode())))
        assert kdsl_lint("-", "--stdin-filename", name).out.count("KD401") == count


def test_fix_leaves_what_is_known_and_mends_the_rest(
    kdsl_lint: Runner, folder: Path, known: Path
) -> None:
    known.write_text(INTEGER)
    kdsl_lint("--write-baseline", "known.json")
    (folder / "b.kindsl").write_text(INTEGER)
    assert kdsl_lint("--fix").err == "no findings in 2 documents; 1 known and silent; 1 fixed\n"
    assert (known.read_text(), (folder / "b.kindsl").read_text()) == (INTEGER, arm(reach="1.0"))


def test_fix_is_made_though_it_wakes_a_known_error(kdsl_lint: Runner, known: Path) -> None:
    known.write_text(GOOD.replace(OTHER, HEAVIER))
    kdsl_lint("--write-baseline", "known.json")
    known.write_text(GOOD.replace(OTHER, HEAVIER.replace("-1.0", "-1")))
    told = kdsl_lint("--fix")
    assert known.read_text() == GOOD.replace(OTHER, HEAVIER)
    assert told.err.endswith("no findings in 1 document; 1 known and silent; 1 fixed\n")


def test_a_fix_can_come_before_the_baseline(kdsl_lint: Runner, folder: Path, known: Path) -> None:
    known.write_text(INTEGER.replace(OTHER, HEAVIER))
    assert kdsl_lint("--fix", "--write-baseline", "known.json").status == 0
    assert known.read_text() == arm(reach="1.0").replace(OTHER, HEAVIER)
    assert "1 known and silent" in kdsl_lint().err


def test_gone_findings_and_documents_make_it_stale(
    kdsl_lint: Runner, folder: Path, known: Path
) -> None:
    (folder / "b.kindsl").write_text(UNBOUND)
    kdsl_lint("--write-baseline", "known.json")
    assert "stale" not in kdsl_lint().err
    assert "stale" not in kdsl_lint("--select", "KD1").err
    (folder / "b.kindsl").unlink()
    known.write_text(GOOD)
    told = kdsl_lint()
    assert "known.json: warning: stale baseline: it has 2 findings that are no longer" in told.err
    assert told.status == 0
    kdsl_lint("--write-baseline", "known.json")
    assert "stale" not in kdsl_lint().err


@pytest.mark.parametrize("content", (None, "", "[]", '{"documents": {"a": [1]}}', "\xff"))
def test_what_is_no_baseline_is_told_where_it_is_named(
    kdsl_lint: Runner, folder: Path, content: str | None
) -> None:
    (folder / "a.kindsl").write_text(GOOD)
    (folder / "kindsl.toml").write_text(f"target = []\n{TOML}")
    if content is not None:
        (folder / "known.json").write_bytes(content.encode("latin-1"))
    what = "cannot be read: No such file or directory" if content is None else (
        "was not written by --write-baseline"
    )  # fmt: skip
    told = kdsl_lint()
    assert told.err.startswith(f"kindsl.toml:2:1: error: baseline 'known.json' {what}\n")
    assert told.status == 2
    assert kdsl_lint("--write-baseline", "known.json").status == 0
    assert kdsl_lint().status == 0


def test_a_file_that_cannot_be_written_is_a_failure(kdsl_lint: Runner, folder: Path) -> None:
    (folder / "a.kindsl").write_text(UNBOUND)
    told = kdsl_lint("--write-baseline", "none/known.json")
    assert told.status == 2
    assert "none/known.json: error: cannot be written: there is no folder" in told.err
    assert "KD401" in told.out


def test_it_goes_with_neither_watching_nor_showing(kdsl_lint: Runner) -> None:
    for option in ("--watch", "--diff"):
        told = kdsl_lint("--write-baseline", "known.json", option)
        assert told.status == 2
        assert told.err == f"kdsl-lint: error: --write-baseline cannot be used with {option}\n"


def test_unused_bindings_are_no_part_of_it(kdsl_lint: Runner, folder: Path) -> None:
    (folder / "a.kindsl").write_text(GOOD)
    (folder / "kindsl.toml").write_text(f"{TOML}[parameters]\nnone = 1.0\n")
    assert "KD404" in kdsl_lint("--write-baseline", "known.json").out
    assert "KD404" in kdsl_lint().out


def test_transforms_documents_have_known_findings_too(kdsl_lint: Runner, folder: Path) -> None:
    (folder / "a.kindsl").write_text(GOOD)
    (folder / "kindsl.toml").write_text(TOML)
    path = folder / "a.dtdsl"
    path.write_text(TRANSFORMS)
    found = kdsl_lint("--write-baseline", "known.json").err
    assert found.startswith("1 known finding written")
    path.write_text(f"\n{TRANSFORMS}".replace("fr_nowhere,", "fr_nowhere,\nfr_none,"))
    told = kdsl_lint()
    assert "'fr_nowhere'" not in told.out
    assert "'fr_none'" in told.out


def test_findings_of_a_urdf_are_known_by_their_elements(kdsl_lint: Runner, folder: Path) -> None:
    zeros = " ".join(f'{name}="0"' for name in ("ixx", "ixy", "ixz", "iyy", "iyz", "izz"))
    link = f'<link name="{{}}"><inertial><mass value="-1"/><inertia {zeros}/></inertial></link>\n'
    robot = f'<robot name="arm">\n{link.format("a")}</robot>\n'
    for name in ("arm.urdf", "b.urdf"):
        (folder / name).write_text(robot)
    (folder / "kindsl.toml").write_text(TOML)
    assert kdsl_lint("--write-baseline", "known.json", "arm.urdf", "b.urdf").status == 0
    told = kdsl_lint("arm.urdf", "b.urdf")
    assert (told.status, told.out) == (0, "")
    assert told.err == "no findings in 2 documents; 2 known and silent\n"
    moved = robot.replace("</robot>", f"{link.format('b')}</robot>")
    (folder / "arm.urdf").write_text(moved)
    told = kdsl_lint("arm.urdf")
    assert "mass of 'a'" not in told.out and "stale" not in told.err
    (folder / "b.urdf").unlink()
    assert "it has 1 finding that is no longer there" in kdsl_lint("arm.urdf").err
