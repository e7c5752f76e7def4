"""Neovim and Emacs, headless: see, hover, complete, rename, format, set a number, undo."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

HERE = Path(__file__).parent
SERVER = [sys.executable, "-m", "kindsl.cli.language_server"]
STEPS = (
    "diagnostic", "hover", "completion", "rename", "format", "set", "undone", "cleared", "stopped",
)  # fmt: skip
ROBOT = """\
Robot Arm {
RobotBase base {
    children {
        arm via shoulder
    }
}
link arm {
  id=1
    children {
        missing via nothing
    }
}
r_joint shoulder {
    ref_frame {
        translation = (0.0, 0.0, 0.5)
        rotation = (0.0, PI/2.0, 0.0)
    }
}
}
"""


def require(editor: str) -> str:
    found = shutil.which(editor)
    if found is None and os.environ.get("CI") != "true":
        pytest.skip(f"{editor} is not installed")
    assert found is not None, f"{editor} is not installed"
    return found


def use(command: list[str], folder: Path) -> "subprocess.CompletedProcess[str]":
    """Let an editor open the robot in a folder."""
    document = folder / "arm.kindsl"
    document.write_text(ROBOT)
    environment = {
        **os.environ,
        "KINDSL_SERVER": json.dumps(SERVER),
        "KINDSL_DOCUMENT": str(document),
        "XDG_STATE_HOME": str(folder),
        "XDG_CACHE_HOME": str(folder),
    }
    return subprocess.run(
        command,
        env=environment,
        cwd=folder,
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )


def check(run: "subprocess.CompletedProcess[str]") -> None:
    for step in STEPS:
        assert f"{step}: t" in run.stdout, f"{step}\n{run.stdout}\n{run.stderr}"
    assert run.returncode == 0, run.stdout + run.stderr


def test_neovim(tmp_path: Path) -> None:
    neovim = require("nvim")
    script = f"luafile {HERE / 'neovim.lua'}"
    check(use([neovim, "--headless", "--clean", "-c", script], tmp_path))


def test_emacs(tmp_path: Path) -> None:
    emacs = require("emacs")
    eglot = [emacs, "-q", "--batch", "--eval", "(progn (package-initialize) (require 'eglot))"]
    if subprocess.run(eglot, capture_output=True, timeout=60, check=False).returncode:
        assert os.environ.get("CI") != "true", "eglot is not installed"
        pytest.skip("eglot is not installed")
    check(use([emacs, "-q", "--batch", "-l", str(HERE / "emacs.el")], tmp_path))


def test_vim_with_ale(tmp_path: Path) -> None:
    vim = require("vim")
    has_ale = [
        vim,
        "-Nes",
        "-u",
        "NONE",
        "-c",
        "packadd ale",
        "-c",
        "exe exists('g:loaded_ale') ? 'q!' : 'cq!'",
    ]
    if subprocess.run(has_ale, capture_output=True, timeout=60, check=False).returncode:
        assert os.environ.get("CI") != "true", "ALE is not installed"
        pytest.skip("ALE is not installed")
    run = use([vim, "-N", "-u", str(HERE / "vim.vim"), "-es"], tmp_path)
    steps = (tmp_path / "steps").read_text()
    assert "diagnostic: true\ncleared: true" in steps, steps + run.stdout + run.stderr
    assert run.returncode == 0
