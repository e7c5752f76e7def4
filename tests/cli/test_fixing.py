"""`--fix` and `--diff`."""

import os
import re
import stat
import subprocess
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.cli.conftest import Runner
from tests.cli.samples import GOOD, INTEGER, arm
from tests.support import robots
from tests.support.amount import usually
from tests.support.examples import link, robot

from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.analysis.fixing import disjoint_fixes, fixed, is_fixable
from kindsl.judgement.analysis.text_fix import TextFix, edits_of
from kindsl.judgement.rules.base import Severity
from kindsl.language.text.edits import TextEdit, apply_edits, in_line_style

FIXED = arm(reach="1.0")


def test_fix_mends_and_tells(kdsl_lint: Runner, folder: Path) -> None:
    (folder / "a.kindsl").write_text(INTEGER)
    told = kdsl_lint("--fix", "a.kindsl")
    assert (told.status, told.out) == (0, "")
    assert told.err == "no findings in 1 document; 1 fixed\n"
    assert (folder / "a.kindsl").read_text() == FIXED


def test_diff_shows_and_writes_nothing(kdsl_lint: Runner, folder: Path) -> None:
    (folder / "a.kindsl").write_text(INTEGER)
    (folder / "good.kindsl").write_text(GOOD)
    told = kdsl_lint("--diff")
    assert told.status == 1
    assert told.out.startswith("--- a.kindsl\n+++ a.kindsl\n@@ ")
    assert told.out.count("\n-") == told.out.count("\n+    ref") == 1
    assert (folder / "a.kindsl").read_text() == INTEGER
    assert kdsl_lint("--diff", "good.kindsl").status == 0


def test_diff_can_be_applied(kdsl_lint: Runner, folder: Path) -> None:
    for text in (INTEGER, INTEGER.rstrip("\n"), INTEGER.replace("\n", "\r\n")):
        (folder / "a.kindsl").write_bytes(text.encode())
        diff = kdsl_lint("--diff", "a.kindsl").out
        subprocess.run(
            ["patch", "--quiet", "--binary", "-p0"], input=diff.encode(), cwd=folder, check=True
        )
        assert (folder / "a.kindsl").read_bytes() == text.replace("(1,", "(1.0,").encode()


def test_line_ends_and_mode_are_kept(kdsl_lint: Runner, folder: Path) -> None:
    path = folder / "a.kindsl"
    path.write_bytes(INTEGER.replace("\n", "\r\n").encode())
    path.chmod(0o640)
    kdsl_lint("--fix", "a.kindsl")
    assert path.read_bytes() == FIXED.replace("\n", "\r\n").encode()
    assert stat.S_IMODE(path.stat().st_mode) == 0o640
    assert [entry.name for entry in folder.iterdir()] == [".git", "a.kindsl"]


def test_link_stays_a_link(kdsl_lint: Runner, folder: Path) -> None:
    (folder / "real.txt").write_text(INTEGER)
    (folder / "a.kindsl").symlink_to("real.txt")
    kdsl_lint("--fix", "a.kindsl")
    assert (folder / "a.kindsl").is_symlink()
    assert (folder / "real.txt").read_text() == FIXED


def test_what_cannot_be_written_is_told(
    kdsl_lint: Runner, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (folder / "a.kindsl").write_text(INTEGER)
    monkeypatch.setattr(os, "access", lambda *_: False)
    told = kdsl_lint("--fix", "a.kindsl")
    assert told.status == 2
    assert "a.kindsl: error: cannot be written: permission denied" in told.err
    assert "error[KD005]" in told.out
    assert (folder / "a.kindsl").read_text() == INTEGER


def test_a_failed_write_leaves_the_old_file(
    kdsl_lint: Runner, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(_: int) -> None:
        raise OSError(28, "No space left on device")

    (folder / "a.kindsl").write_text(INTEGER)
    monkeypatch.setattr(os, "fsync", full)
    told = kdsl_lint("--fix", "a.kindsl")
    assert told.status == 2
    assert "cannot be written: No space left on device" in told.err
    assert (folder / "a.kindsl").read_text() == INTEGER
    assert [entry.name for entry in folder.iterdir()] == [".git", "a.kindsl"]


def test_a_file_that_changed_meanwhile_is_not_written(folder: Path) -> None:
    from kindsl.frontends.cli.documents.writing import write_text

    (folder / "a.kindsl").write_text("new")
    failure = write_text("a.kindsl", "a.kindsl", "old", "fixed")
    assert failure is not None
    assert "changed meanwhile" in failure.message
    assert (folder / "a.kindsl").read_text() == "new"


def test_fix_from_stdin_goes_to_stdout(kdsl_lint: Runner, monkeypatch: pytest.MonkeyPatch) -> None:
    from io import BytesIO, TextIOWrapper

    monkeypatch.setattr("sys.stdin", TextIOWrapper(BytesIO(INTEGER.encode())))
    told = kdsl_lint("--fix", "-")
    assert (told.status, told.out) == (0, FIXED)


def test_unsafe_fixes_only_when_wanted(kdsl_lint: Runner, folder: Path) -> None:
    text = GOOD.replace("id = 2", "id = 1")
    (folder / "a.kindsl").write_text(text)
    kdsl_lint("--fix", "a.kindsl")
    assert (folder / "a.kindsl").read_text() == text
    kdsl_lint("--fix", "--unsafe-fixes", "a.kindsl")
    assert (folder / "a.kindsl").read_text() == GOOD


def test_a_link_is_added_and_the_others_renumbered_to_different_numbers(
    kdsl_lint: Runner, folder: Path
) -> None:
    links = link("upper", 4, "lower via elbow"), link("lower", 5)
    base = "upper via shoulder hand via wrist"
    (folder / "a.kindsl").write_text(robot(*links, base=base, joints="shoulder elbow wrist"))
    assert kdsl_lint("--fix", "--unsafe-fixes", "a.kindsl").status == 0
    ids = re.findall(r"id = (\d)", (folder / "a.kindsl").read_text())
    assert sorted(ids) == ["1", "2", "3"]


def test_a_section_with_a_remark_in_it_stays_and_is_not_announced(
    kdsl_lint: Runner, folder: Path
) -> None:
    frame = "ref_frame { translation = (0.0, 0.0, 0.0) /* drawn */ rotation = (0.0, 0.0, 0.0) }\n"
    text = robots.STUB.replace("children", frame + "    children", 1)
    (folder / "a.kindsl").write_text(text)
    told = kdsl_lint("--fix", "--unsafe-fixes", "a.kindsl")
    assert (folder / "a.kindsl").read_text() == text
    assert "KD001" in told.out
    assert "Remove 'ref_frame'" not in told.out
    (folder / "a.kindsl").write_text(text.replace("/* drawn */", ""))
    assert "Remove 'ref_frame' (--fix --unsafe-fixes)" in kdsl_lint("a.kindsl").out
    kdsl_lint("--fix", "--unsafe-fixes", "a.kindsl")
    assert (folder / "a.kindsl").read_text().count("ref_frame") == text.count("ref_frame") - 1


def finding(*edits: TextEdit, safe: bool = True) -> Diagnostic:
    fix = TextFix("Fix", safe, edits)
    return Diagnostic("KD500", "x", Severity.ERROR, "is odd", 0, 1, fix=fix)


def chosen(findings: list[Diagnostic]) -> tuple[list[TextEdit], int]:
    fixes = disjoint_fixes(findings)
    return edits_of(fixes), len(fixes)


def test_fixes_that_touch_each_other_wait_for_the_next_round() -> None:
    one, other = TextEdit(0, 3, "a"), TextEdit(3, 5, "b")
    assert chosen([finding(one), finding(other)]) == ([one], 1)


def test_the_same_fix_of_two_findings_is_made_once() -> None:
    edit = TextEdit(0, 3, "a")
    assert chosen([finding(edit), finding(edit)]) == ([edit], 2)


def test_fixes_may_share_an_edit() -> None:
    shared, one, other = TextEdit(0, 3, "a"), TextEdit(5, 6, "b"), TextEdit(8, 9, "c")
    both = [finding(shared, other), finding(shared, one)]
    assert chosen(both) == ([shared, one, other], 2)


def test_safe_fixes_come_first() -> None:
    risky, safe = TextEdit(0, 3, "a"), TextEdit(2, 5, "b")
    assert chosen([finding(risky, safe=False), finding(safe)]) == ([safe], 1)


def test_a_fix_is_made_whole_or_not_at_all() -> None:
    taken, other = TextEdit(5, 6, "a"), TextEdit(0, 1, "b")
    both = finding(other, TextEdit(5, 7, "c"))
    assert chosen([finding(taken), both]) == ([taken], 1)


def test_new_lines_are_as_the_others() -> None:
    assert in_line_style(TextEdit(0, 0, "a\nb"), "x\r\ny").text == "a\r\nb"
    assert in_line_style(TextEdit(0, 0, "a\nb"), "x\ry").text == "a\rb"
    assert in_line_style(TextEdit(0, 0, "a\nb"), "x\ny").text == "a\nb"
    assert in_line_style(TextEdit(0, 0, "a\nb"), "x\ny\r\n").text == "a\nb"


@settings(max_examples=usually(30, thoroughly=100), deadline=None)
@given(
    st.lists(st.sampled_from(["1", "-2", ".5", "1,5", "x", "2*PI", "PI/2", "0x1", "(", "\u00a0"]))
)
def test_fixing_ends_and_a_second_time_changes_nothing(parts: list[str]) -> None:
    analysis = analyse(arm(reach=" ".join(parts)))
    better, n_fixed, rounds = fixed(analysis, is_fixable)
    assert fixed(better, is_fixable).n_findings == 0
    assert better.findings == analyse(better.text).findings
    text = analysis.text
    for edits in rounds:
        text = apply_edits(text, edits)
    assert text == better.text
    assert (n_fixed == 0) == (better.text == analysis.text)
    n_before = sum(f.code.startswith("KD0") for f in analysis.findings)
    assert sum(f.code.startswith("KD0") for f in better.findings) <= n_before


@given(st.text(max_size=30), st.data())
def test_disjoint_fixes_can_always_be_applied(text: str, data: st.DataObject) -> None:
    edits = st.tuples(st.integers(0, len(text)), st.integers(0, len(text)), st.text(max_size=2))
    made = data.draw(st.lists(edits, max_size=8))
    findings = [finding(TextEdit(min(a, b), max(a, b), new)) for a, b, new in made]
    apply_edits(text, chosen(findings)[0])
