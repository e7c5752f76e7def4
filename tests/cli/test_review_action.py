"""The action's own script on a real repository, with a stand-in for GitHub's command."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
SCRIPT = ROOT / ".ci" / "review-pull-request"
ARM = (ROOT / "examples" / "industrial_arm.kindsl").read_text()
TEXT = (ROOT / "examples" / "quadruped.kindsl").read_text()
# Writes down what it is asked for; lists the comment if there is one; refuses to write if told so.
GH = """#!/bin/sh
echo "$@" >> "$CALLS"
case "$*" in
*--paginate*) [ -z "$COMMENT" ] || echo "$COMMENT" ;;
*) [ -z "$REFUSE" ] ;;
esac
"""
KINDSL = f'#!/bin/sh\nexec "{sys.executable}" -m kindsl "$@"\n'

pytestmark = pytest.mark.skipif(
    shutil.which("bash") is None or shutil.which("git") is None, reason="there is no bash or git"
)


@pytest.fixture(scope="module")
def repository(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("repository")
    git(folder, "init", "-b", "main")
    (folder / "models").mkdir()
    for text in (TEXT, TEXT.replace("mass = 0.634", "mass = 0.7")):
        (folder / "models" / "quadruped.kindsl").write_text(text)
        (folder / "models" / "readme.txt").write_text(text[-100:] + str(hash(text)))
        git(folder, "add", ".")
        git(folder, "commit", "-m", "change")
    return folder


def git(folder: Path, *arguments: str) -> str:
    name = ["-c", "user.name=n", "-c", "user.email=e@example.org", "-c", "commit.gpgsign=false"]
    command = ["git", "-C", str(folder), *name, *arguments]
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout.strip()


def reviewed(repository: Path, folder: Path, **environment: str) -> tuple[str, str, str]:
    """Return what GitHub was asked for, the comment and the summary."""
    tools = folder / "tools"
    tools.mkdir()
    for name, text in (("gh", GH), ("kindsl", KINDSL)):
        (tools / name).write_text(text)
        (tools / name).chmod(0o755)
    calls, summary = folder / "calls", folder / "summary"
    calls.touch()
    summary.touch()
    given = {
        "PATH": f"{tools}{os.pathsep}{os.environ['PATH']}",
        "PYTHONPATH": str(ROOT / "server"),
        "KINDSL": str(tools / "kindsl"),
        "BASE": git(repository, "rev-parse", "HEAD~1"),
        "HEAD": git(repository, "rev-parse", "HEAD"),
        "PATHS": "models",
        "OUT": str(folder / "out"),
        "REPOSITORY": "owner/name",
        "PULL_REQUEST": "7",
        "GITHUB_STEP_SUMMARY": str(summary),
        "CALLS": str(calls),
        "COMMENT": "",
        "REFUSE": "",
    }
    subprocess.run(
        ["bash", str(SCRIPT)], cwd=repository, env=os.environ | given | environment, check=True,
        timeout=60, capture_output=True,
    )  # fmt: skip
    return calls.read_text(), (folder / "out" / "comment.md").read_text(), summary.read_text()


def test_first_run_writes_a_comment(repository: Path, tmp_path: Path) -> None:
    calls, comment, summary = reviewed(repository, tmp_path)
    assert "-X POST repos/owner/name/issues/7/comments -F body=@" in calls
    assert comment.startswith("<!-- kindsl review -->") and "models/quadruped.kindsl" in comment
    assert "mass 0.634 -> 0.7 kg" in comment and "readme" not in comment
    assert (tmp_path / "out" / "models" / "quadruped.kindsl.review" / "after.svg").exists()
    assert summary == ""


def test_next_run_updates_it(repository: Path, tmp_path: Path) -> None:
    calls, _, summary = reviewed(repository, tmp_path, COMMENT="42")
    assert "-X PATCH repos/owner/name/issues/comments/42 -F body=@" in calls
    assert "POST" not in calls and summary == ""


def test_without_write_access_it_is_in_the_summary(repository: Path, tmp_path: Path) -> None:
    _, comment, summary = reviewed(repository, tmp_path, REFUSE="yes")
    assert summary == comment


def test_nothing_changed_writes_nothing(repository: Path, tmp_path: Path) -> None:
    calls, comment, summary = reviewed(repository, tmp_path, PATHS="elsewhere")
    assert "No document" in comment and "POST" not in calls and summary == ""


@pytest.fixture(scope="module")
def reshaped(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A repository whose last commit adds a document, renames one, and deletes one."""
    folder = tmp_path_factory.mktemp("reshaped")
    git(folder, "init", "-b", "main")
    (folder / "models" / "old").mkdir(parents=True)
    for name in ("old/leg.kindsl", "gone.kindsl"):
        (folder / "models" / name).write_text(f"// {name}\n{TEXT}")
    git(folder, "add", ".")
    git(folder, "commit", "-m", "first")
    git(folder, "mv", "models/old/leg.kindsl", "./-leg.kindsl")
    git(folder, "rm", "models/gone.kindsl")
    changed = (folder / "-leg.kindsl").read_text().replace("mass = 0.634", "mass = 0.7")
    (folder / "-leg.kindsl").write_text(changed)
    (folder / "models").mkdir(exist_ok=True)
    (folder / "models" / "näu [1].kindsl").write_text(ARM)
    git(folder, "add", ".")
    git(folder, "commit", "-m", "second")
    return folder


def test_added_and_renamed_documents_are_reviewed(reshaped: Path, tmp_path: Path) -> None:
    _, comment, _ = reviewed(reshaped, tmp_path, PATHS=".")
    _, renamed, added = comment.split("\n## `")
    assert renamed.startswith("-leg.kindsl`") and "mass 0.634 -> 0.7 kg" in renamed
    assert "added" not in renamed
    assert added.startswith("models/näu [1].kindsl`")
    assert "The document is not in" in added and "| link | forearm | added |" in added
    assert "gone.kindsl" not in comment


def test_a_review_of_git_takes_documents_that_are_only_in_one(
    reshaped: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(reshaped)
    base, head = git(reshaped, "rev-parse", "HEAD~1"), git(reshaped, "rev-parse", "HEAD")
    command = (sys.executable, "-m", "kindsl", "review", "--git", f"{base}..{head}")
    for name, expected in (
        ("-leg.kindsl", f"{base[:12]}:models/old/leg.kindsl to {head[:12]}"),
        ("models/gone.kindsl", f"The document is no longer in {head[:12]}."),
        ("none.kindsl", f"none.kindsl: error: does not exist in {base} or {head}"),
    ):
        out = tmp_path / name
        told = subprocess.run(
            [*command, "-o", str(out), "--", name], capture_output=True, text=True, check=False
        )
        text = (out / "review.md").read_text() if out.exists() else told.stderr
        assert expected in text.replace("\\", "")
