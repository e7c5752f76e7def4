"""What the action runs where code is generated, and the hook's command."""

import os
import re
import shlex
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest
from tests.cli.conftest import Runner
from tests.cli.samples import GOOD

ROOT = Path(__file__).parents[2]
HOOKS = ".pre-commit-hooks.yaml"
SCRIPT = ROOT / ".ci" / "check-generated"
KINDSL = f'#!/bin/sh\nexec "{sys.executable}" -m kindsl "$@"\n'


def checked(folder: Path, generated: str) -> tuple[int, str]:
    """Return the status and what is in the log."""
    command = folder / "kindsl.sh"
    command.write_text(KINDSL)
    command.chmod(0o755)
    given = {"KINDSL": str(command), "GENERATED": generated, "PYTHONPATH": str(ROOT / "server")}
    done = subprocess.run(
        ["bash", str(SCRIPT)], cwd=folder, env=os.environ | given, timeout=60, capture_output=True,
        text=True, check=False,
    )  # fmt: skip
    assert done.stderr == ""
    return done.returncode, done.stdout


@pytest.fixture
def generated(kindsl: Runner, folder: Path) -> Path:
    """A folder with two documents and the code of each."""
    for name in ("arm", "my leg"):
        (folder / f"{name}.kindsl").write_text(GOOD)
        options = ("--language", "python", "--quantities", "poses", "-o", f"out/{name[-3:]}")
        assert kindsl("generate", f"{name}.kindsl", *options).status == 0
    return folder


@pytest.mark.skipif(shutil.which("bash") is None, reason="there is no bash")
def test_the_action_tells_of_every_folder(generated: Path) -> None:
    lines = "\nout/leg my leg.kindsl\n  out/arm arm.kindsl\n"
    told = "out/leg: fits my leg.kindsl\nout/arm: fits arm.kindsl\n"
    assert checked(generated, lines) == (0, told)
    (generated / "my leg.kindsl").write_text(GOOD.replace("0.5)", "0.6)"))
    why = "'my leg.kindsl' has changed since 'out/leg' was generated"
    expected = (
        f"::error file=my leg.kindsl::my leg.kindsl: error: {why}\nout/arm: fits arm.kindsl\n"
    )
    assert checked(generated, lines) == (1, expected)


def test_the_hook_runs_what_exists(kindsl: Runner, generated: Path) -> None:
    hooks = (ROOT / HOOKS).read_text()
    (entry,) = (line for line in hooks.splitlines() if "generate --" in line and "entry" in line)
    _, *words = shlex.split(entry.partition(": ")[2])
    assert kindsl(*words, "out/arm", "arm.kindsl") == (0, "", "")
    (generated / "arm.kindsl").write_text(GOOD.replace("0.5)", "0.6)"))
    assert kindsl(*words, "out/arm", "arm.kindsl").status == 1


def test_action_and_hook_install_what_code_of_any_language_needs() -> None:
    """RobCoGen's classes need more than all other languages."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    needed = [name.partition(">=")[0] for name in project["optional-dependencies"]["robcogen"]]
    (line,) = re.findall(r"additional_dependencies: \[(.*)\]", (ROOT / HOOKS).read_text())
    assert sorted(line.split(", ")) == sorted(needed)
    assert '[ -n "$GENERATED" ]; then extra="[robcogen]"' in (ROOT / "action.yml").read_text()
