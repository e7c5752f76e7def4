"""What the README and the recipes promise works as it is written there."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from tests.docs.guide import GUIDE, PAGES

from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.settings import Settings

ROOT = GUIDE.parents[1]
README = (ROOT / "README.md").read_text(encoding="utf-8")
EVIDENCE = (ROOT / "docs" / "evidence.md").read_text(encoding="utf-8")
PYTHON = (GUIDE / "python.md").read_text(encoding="utf-8")
RECIPES = (GUIDE / "recipes.md").read_text(encoding="utf-8")
TEXTS = {path.name: path.read_text(encoding="utf-8") for path in (ROOT / "docs").glob("*.md")}
BLOCK = r"```{}\n(.*?)^```$"
ARM = (GUIDE / "crane.kindsl").read_text(encoding="utf-8")


def blocks(text: str, language: str) -> list[str]:
    return re.findall(BLOCK.format(language), text, re.MULTILINE | re.DOTALL)


def run(command: str, folder: Path) -> str:
    search = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    quiet = {"GIT_CONFIG_GLOBAL": os.devnull, "GIT_CONFIG_SYSTEM": os.devnull, "GIT_PAGER": "cat"}
    environment = {**os.environ, **quiet, "PATH": search, "PYTHONPATH": str(ROOT / "server")}
    done = subprocess.run(
        ["sh", "-c", command], cwd=folder, env=environment, stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, encoding="utf-8", timeout=60, check=False,
    )  # fmt: skip
    return done.stdout


def test_whole_robots_in_the_pages_are_taken_by_both_generators() -> None:
    folders = (".", "docs", "grammar", "vscode-extension", "vscode-extension/walkthrough")
    pages = [page for folder in folders for page in (ROOT / folder).glob("*.md")]
    both = Settings(frozenset({"robcogen", "robcogen2"}))
    texts = [
        block
        for page in (*pages, *PAGES)
        for block in blocks(page.read_text(encoding="utf-8"), "kindsl")
        if block.startswith("Robot ")
    ]
    assert texts
    for text in texts:
        worse = [f for f in analyse(text, both).findings if f.severity in ("error", "warning")]
        assert worse == [], text


def test_the_python_of_the_guide_runs(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(GUIDE)
    names: dict[str, object] = {}
    for snippet in blocks(PYTHON, "python"):
        exec(compile(snippet, "python.md", "exec"), names)
    assert getattr(names["M"], "shape", None) == (3, 3)


def test_the_readme_fits_two_screens() -> None:
    assert len(README.splitlines()) <= 80
    assert len(re.findall(r"^!\[", README, re.MULTILINE)) == 1


def test_the_action_is_told_where_the_models_are() -> None:
    steps = [block for block in blocks(TEXTS["ci.md"], "yaml") if "uses: OWNER/kindsl" in block]
    assert steps
    for step in steps:
        assert re.search(r"^ *paths: models$", step, re.MULTILINE), step
        for options in re.findall(r"args: (.*)", step):
            assert re.fullmatch(r"(--[a-z-]+( [a-z0-9]+)?( |$))*", options), options


def test_nothing_is_installed_from_an_index_that_does_not_have_it() -> None:
    for text in (README, *TEXTS.values(), *(page.read_text(encoding="utf-8") for page in PAGES)):
        for command in re.findall(r"pip install ([^\n`]+)", text):
            assert command.startswith((".", "'.")) or "git+ADDRESS" in command, command


def test_tests_that_the_evidence_names_are_in_a_clone() -> None:
    named = re.findall(r"pytest (tests/[\w/.]+)", EVIDENCE)
    assert named
    for path in named:
        text = (ROOT / path).read_text(encoding="utf-8")
        assert "pytest.mark.published" not in text, path


def test_every_page_with_commands_says_where_they_are_run() -> None:
    for page in PAGES:
        text = page.read_text(encoding="utf-8")
        assert "```console" not in text or "run in a copy of `docs/guide`" in text, page.name


@pytest.mark.skipif(shutil.which("git") is None, reason="git is not installed")
@pytest.mark.parametrize("has_configuration", [False, True])
def test_git_shows_what_changed_mechanically(tmp_path: Path, has_configuration: bool) -> None:
    (recipe,) = [block for block in blocks(RECIPES, "sh") if "git config" in block]
    set_up, _, _ = recipe.partition("git diff")
    run("git init -q . && " + set_up, tmp_path)
    (tmp_path / "crane.kindsl").write_text(ARM)
    if has_configuration:
        (tmp_path / "kindsl.toml").write_text("")
    run("git add -A && git -c user.name=a -c user.email=a@b commit -qm a", tmp_path)
    (tmp_path / "crane.kindsl").write_text(ARM.replace("(0.6, 0.0, 0.0)", "(0.7, 0.0, 0.0)"))
    (tmp_path / "new.kindsl").write_text(ARM)
    told = run("git add -A && git diff --cached", tmp_path)
    assert "joint frame   extend  moved 100 mm, turned 0 deg" in told
    assert re.search(r"^link +jib +added", told, re.MULTILINE)
    assert "error" not in told
