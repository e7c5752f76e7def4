"""Runs commands inside the test's process, in a folder of their own."""

from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import pytest

from kindsl.frontends.cli import lint, main


class Told(NamedTuple):
    """What a command left: its status and what it wrote."""

    status: int
    out: str
    err: str


Runner = Callable[..., Told]


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A fresh working directory that is a repository of its own, without colours."""
    (tmp_path / ".git").mkdir()
    monkeypatch.chdir(tmp_path)
    for name in ("NO_COLOR", "FORCE_COLOR", "CI_PROJECT_DIR", "GITHUB_WORKSPACE"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("KINDSL_TRACEBACK", "1")
    return tmp_path


@pytest.fixture
def kdsl_lint(capfd: pytest.CaptureFixture[str]) -> Runner:
    """`kdsl-lint` as a function."""
    return _runner(lint.main, capfd)


@pytest.fixture
def kindsl(capfd: pytest.CaptureFixture[str]) -> Runner:
    """`kindsl` as a function."""
    return _runner(main.main, capfd)


def _runner(command: Callable[[list[str]], int], capfd: pytest.CaptureFixture[str]) -> Runner:
    def run(*arguments: object) -> Told:
        try:
            status = command([str(argument) for argument in arguments])
        except SystemExit as leaving:
            status = leaving.code if isinstance(leaving.code, int) else 1
        return Told(status, *capfd.readouterr())

    return run
