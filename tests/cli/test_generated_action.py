"""What the action runs where code is generated, and the hook's command."""

import os
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from tests.cli.conftest import Runner
from tests.cli.samples import GOOD

ROOT = Path(__file__).parents[2]
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
    hooks = (ROOT / ".pre-commit-hooks.yaml").read_text()
    (entry,) = (line for line in hooks.splitlines() if "generate --" in line and "entry" in line)
    _, *words = shlex.split(entry.partition(": ")[2])
    assert kindsl(*words, "out/arm", "arm.kindsl") == (0, "", "")
    (generated / "arm.kindsl").write_text(GOOD.replace("0.5)", "0.6)"))
    assert kindsl(*words, "out/arm", "arm.kindsl").status == 1
