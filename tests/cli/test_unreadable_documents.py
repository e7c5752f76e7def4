"""Whatever lies in a folder: a clear message with the place, and the others are linted.

What cannot be read exits with 2; what can, and is no document, is a finding.
"""

import os
import pwd
import random
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.cli.conftest import Runner
from tests.cli.samples import GOOD, INTEGER

import kindsl
from kindsl.frontends.cli.documents.sources import is_decodable
from kindsl.frontends.cli.linter.one_document import FixMode, Task, check
from kindsl.judgement.analysis import analysis
from kindsl.judgement.analysis.settings import Settings
from kindsl.judgement.rules.base import Finding, Rule, Severity
from kindsl.judgement.rules.registry import checking_rules

STRANGE = {
    "utf16.kindsl": GOOD.encode("utf-16"),
    "utf16le.kindsl": GOOD.encode("utf-16-le"),
    "utf16be.kindsl": GOOD.encode("utf-16-be"),
    "utf32.kindsl": GOOD.encode("utf-32"),
    "noise.kindsl": random.Random(1).randbytes(10_000),
}


@pytest.mark.parametrize("name", STRANGE)
def test_what_is_no_text_is_found(kdsl_lint: Runner, folder: Path, name: str) -> None:
    (folder / name).write_bytes(STRANGE[name])
    (folder / "other.kindsl").write_text(INTEGER)
    told = kdsl_lint()
    expected = name[:5].upper().replace("UTF", "UTF-") if name.startswith("utf") else "not a text"
    found = [line for line in told.out.splitlines() if ": error[" in line]
    assert sorted(line.partition(" ")[0].split(":")[0] for line in found) == sorted(
        [name, "other.kindsl"]
    )
    (own,) = (line for line in found if line.startswith(f"{name}:"))
    assert "error[KD004] the document is" in own
    assert expected in own
    assert told.status == 1


def test_ten_megabytes_of_noise(kdsl_lint: Runner, folder: Path) -> None:
    (folder / "noise.kindsl").write_bytes(random.Random(2).randbytes(10_000_000))
    told = kdsl_lint("noise.kindsl")
    assert told.status == 1
    first, *rest = told.out.splitlines()
    assert first.startswith("noise.kindsl:1:")
    assert "error[KD004] the document is not a text: byte 0x" in first
    assert len(rest) == 2
    assert max(map(len, rest)) < 200


def test_latin_1_is_found_at_its_place(kdsl_lint: Runner, folder: Path) -> None:
    text = GOOD.replace("Robot arm {", "Robot arm { // Länge der Beine")
    (folder / "latin.kindsl").write_bytes(text.encode("latin-1"))
    told = kdsl_lint("latin.kindsl")
    assert told.out.startswith("latin.kindsl:1:17: error[KD004]")
    assert told.status == 1


def test_every_run_of_undecodable_bytes_is_found(folder: Path) -> None:
    text = GOOD.replace("Robot arm {", "Robot arm { // \xe4 and \xf6\xfc").replace(
        "id = 1", "\xe4 id = 1"
    )
    (folder / "latin.kindsl").write_bytes(text.encode("latin-1"))
    found = kindsl.load(folder / "latin.kindsl").findings
    told = [finding.message.partition(",")[0] for finding in found if finding.code == "KD004"]
    assert told == ["undecodable byte 0xE4", "undecodable bytes 0xF6 0xFC", "undecodable byte 0xE4"]


@pytest.mark.parametrize(
    ("written", "spoilt"),
    [
        ("Iy = 0.0019", "Iy = \x800.0019"),
        ("Iy = 0.0019", "Iy = 0.0\x8019"),
        ("(0.0, 0.0, 0.5) rot", "(0.0, 0.0, 0.5\x80) rot"),
    ],
)
def test_a_byte_at_a_number_is_told_once(folder: Path, written: str, spoilt: str) -> None:
    (folder / "latin.kindsl").write_bytes(GOOD.replace(written, spoilt, 1).encode("latin-1"))
    (found,) = kindsl.load(folder / "latin.kindsl").findings
    assert (found.code, found.fix) == ("KD004", None)
    assert found.message == "undecodable byte 0x80, a document is UTF-8"


def test_a_document_that_did_not_decode_is_never_written(kdsl_lint: Runner, folder: Path) -> None:
    content = INTEGER.replace("Robot arm {", "Robot arm { // Länge").encode("latin-1")
    (folder / "latin.kindsl").write_bytes(content)
    kdsl_lint("latin.kindsl", "--fix")
    assert (folder / "latin.kindsl").read_bytes() == content


def test_byte_order_mark_is_found_and_removed(kdsl_lint: Runner, folder: Path) -> None:
    (folder / "bom.kindsl").write_text(GOOD, encoding="utf-8-sig")
    told = kdsl_lint("bom.kindsl")
    assert told.out.startswith("bom.kindsl:1:1: error[KD004]")
    assert kdsl_lint("bom.kindsl", "--fix").status == 0
    assert (folder / "bom.kindsl").read_bytes() == GOOD.encode()


@pytest.mark.parametrize("line_end", ["\r\n", "\r"])
def test_other_line_ends_are_lines(kdsl_lint: Runner, folder: Path, line_end: str) -> None:
    (folder / "a.kindsl").write_bytes(INTEGER.replace("\n", line_end).encode())
    told = kdsl_lint("a.kindsl")
    assert told.out.startswith("a.kindsl:21:32: error[KD005]")
    assert len(told.out.splitlines()) == 4


def test_a_line_of_a_megabyte_is_shown_in_part(kdsl_lint: Runner, folder: Path) -> None:
    one_line = INTEGER.replace("\n", " ").replace(
        "{ upper via", "{" + " " * 1_000_000 + "upper via"
    )
    (folder / "long.kindsl").write_text(one_line)
    told = kdsl_lint("long.kindsl")
    lines = told.out.splitlines()
    assert lines[0].startswith("long.kindsl:1:1000")
    assert max(map(len, lines)) < 200
    assert lines[2].index("^") == lines[1].index("(1, ") + 1


def test_broken_link(kdsl_lint: Runner, folder: Path) -> None:
    (folder / "gone.kindsl").symlink_to("nowhere.kindsl")
    (folder / "other.kindsl").write_text(INTEGER)
    told = kdsl_lint()
    assert "gone.kindsl: error: broken symbolic link to 'nowhere.kindsl'" in told.err
    assert told.out.startswith("other.kindsl:21:32:")
    assert told.status == 2


def test_folder_with_the_name_of_a_document(kdsl_lint: Runner, folder: Path) -> None:
    (folder / "x.kindsl").mkdir()
    (folder / "other.kindsl").write_text(INTEGER)
    told = kdsl_lint()
    assert (told.status, told.out.count("other.kindsl:21:32:")) == (1, 1)
    told = kdsl_lint("x.kindsl", "other.kindsl")
    assert "x.kindsl: error: is a folder, not a file" in told.err
    assert told.out.startswith("other.kindsl:21:32:")
    assert told.status == 2


def test_folder_with_such_a_name_and_documents_is_a_folder(kdsl_lint: Runner, folder: Path) -> None:
    (folder / "x.kindsl").mkdir()
    (folder / "x.kindsl" / "good.kindsl").write_text(GOOD)
    assert kdsl_lint().status == 0


def test_missing_file(kdsl_lint: Runner, folder: Path) -> None:
    (folder / "other.kindsl").write_text(INTEGER)
    told = kdsl_lint("missing.kindsl", "other.kindsl")
    assert told.err.startswith("missing.kindsl: error: no such file or folder\n")
    assert told.out.startswith("other.kindsl:21:32:")
    assert told.status == 2


def test_pipe_in_a_folder_is_passed_over(kdsl_lint: Runner, folder: Path) -> None:
    os.mkfifo(folder / "pipe.kindsl")
    (folder / "good.kindsl").write_text(GOOD)
    told = kdsl_lint()
    assert (told.status, told.err) == (0, "no findings in 1 document\n")


@pytest.mark.parametrize(
    "command",
    [
        ("lint", "pipe.kindsl"),
        ("lint", "good.kindsl", "--config", "pipe.kindsl"),
        ("lint", "good.kindsl", "--params", "pipe.kindsl"),
        ("format", "pipe.kindsl"),
        ("info", "pipe.kindsl"),
        ("compute", "good.kindsl", "--q-file", "pipe.kindsl"),
        ("convert", "pipe.kindsl", "-"),
        ("convert", "pipe.urdf", "-"),
        ("diff", "good.kindsl", "pipe.kindsl"),
        ("preview", "pipe.kindsl", "--export", "x.html"),
        ("info", "/dev/zero"),
    ],
)
def test_a_pipe_that_is_named_is_refused(
    kindsl: Runner, folder: Path, command: tuple[str, ...]
) -> None:
    for name in ("pipe.kindsl", "pipe.urdf"):
        os.mkfifo(folder / name)
    (folder / "good.kindsl").write_text(GOOD)
    told = kindsl(*command)
    assert told.status == 2
    assert "is not a regular file\n" in told.err


def test_a_pipe_of_the_shell_is_read(folder: Path) -> None:
    (folder / "good.kindsl").write_text(GOOD)
    command = f"{sys.executable} -m kindsl diff <(cat good.kindsl) good.kindsl"
    told = subprocess.run(["bash", "-c", command], capture_output=True, text=True, check=False)
    assert (told.returncode, told.stdout) == (0, "nothing changed mechanically\n")


@pytest.mark.parametrize("content", [b"\0" * 3, b"\0" * 400, b"\xff\0\0\0"])
def test_a_few_nul_bytes_are_no_text(kdsl_lint: Runner, folder: Path, content: bytes) -> None:
    (folder / "x.kindsl").write_bytes(content)
    assert "the document is not a text: byte 0x" in kdsl_lint("x.kindsl").out


def test_no_permission(kdsl_lint: Runner) -> None:
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        folder.chmod(0o755)
        secret, other = folder / "secret.kindsl", folder / "other.kindsl"
        secret.write_text(GOOD)
        secret.chmod(0)
        other.write_text(INTEGER)
        other.chmod(0o644)
        kdsl_lint(other)  # imports what is needed
        with without_privileges():
            told = kdsl_lint(secret, other)
    assert f"{secret}: error: cannot be read: permission denied" in told.err
    assert f"{other}:21:32: error[KD005]" in told.out
    assert told.status == 2


@contextmanager
def without_privileges() -> Iterator[None]:
    """Be somebody else for a while if we are root, who may read everything."""
    user = os.geteuid()
    if user != 0:
        yield
        return
    os.seteuid(pwd.getpwnam("nobody").pw_uid)
    try:
        yield
    finally:
        os.seteuid(user)


def test_defect_of_a_rule_does_not_stop_the_others(
    kdsl_lint: Runner, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from kindsl.frontends.cli.linter import one_document as checking

    def broken(name: str, text: str) -> object:
        if "arm" in text:
            raise KeyError("oh")
        return syntax_of(name, text)

    syntax_of = checking.syntax_of
    monkeypatch.setattr(checking, "syntax_of", broken)
    monkeypatch.delenv("KINDSL_TRACEBACK")
    (folder / "arm.kindsl").write_text(GOOD)
    (folder / "leg.kindsl").write_text(INTEGER.replace("arm", "leg"))
    told = kdsl_lint()
    assert told.err.startswith("arm.kindsl: error: internal error: KeyError: 'oh'\n")
    assert told.out.startswith("leg.kindsl:21:32:")
    assert told.status == 2


def test_a_rule_that_fails_is_told_with_what_the_others_found(
    kdsl_lint: Runner, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def failing(*_: object) -> Iterator[Finding]:
        raise KeyError("oh")
        yield

    rule = Rule("kd999_faulty", Severity.ERROR, check_document=failing)
    monkeypatch.setattr(analysis, "checking_rules", lambda: (rule, *checking_rules()))
    monkeypatch.setattr(analysis, "running_rules", analysis.running_rules.__wrapped__)
    monkeypatch.delenv("KINDSL_TRACEBACK")
    (folder / "arm.kindsl").write_text(INTEGER)
    told = kdsl_lint()
    fault = "arm.kindsl: error: internal error: KD999 failed: KeyError: 'oh'\n"
    assert told.err.startswith(fault)
    assert told.out.startswith("arm.kindsl:21:32: error[KD005]")
    assert told.status == 2


@settings(max_examples=150, deadline=None)
@given(
    st.binary(max_size=200)
    | st.tuples(st.binary(max_size=5), st.integers(0, len(GOOD))).map(
        lambda spoilt: GOOD.encode()[: spoilt[1]] + spoilt[0] + GOOD.encode()[spoilt[1] :]
    )
)
def test_any_bytes_are_linted_and_mended_without_a_defect(content: bytes) -> None:
    with tempfile.NamedTemporaryFile(suffix=".kindsl") as file:
        path = Path(file.name)
        path.write_bytes(content)
        task = Task(file.name, "x.kindsl", Settings(), FixMode.WRITTEN, with_unsafe=True)
        linted, failure, _ = check(task)
        written = path.read_bytes()
        path.write_bytes(content)
    assert failure is None
    assert linted is not None
    assert linted.text.encode("utf-8", "surrogateescape") == written or written == content
    if not is_decodable(content.decode("utf-8", "surrogateescape")):
        assert written == content
        assert any(finding.code == "KD004" for finding in linted.findings)
