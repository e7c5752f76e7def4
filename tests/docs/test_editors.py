"""The settings that the docs give for editors make them show a finding and open the preview."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from tests.docs.guide import GUIDE

BIN = Path(sys.executable).parent
SETTINGS = (GUIDE.parent / "editors.md").read_text(encoding="utf-8")
USAGE = (GUIDE / "editors.md").read_text(encoding="utf-8")
PATIENCE = 240  # seconds

NEOVIM = """
vim.opt.swapfile = false
vim.cmd("edit shin.kindsl")
local function found() return #vim.diagnostic.get(0) > 0 end
vim.wait(60000, found, 20)
for _, each in ipairs(vim.diagnostic.get(0)) do io.stdout:write(each.message .. "\\n") end
vim.cmd("KindslPreview")
vim.wait(60000, function() return vim.g.kindsl_preview ~= nil end, 20)
io.stdout:write(tostring(vim.g.kindsl_preview) .. "\\n")
vim.cmd("qa!")
"""

EMACS = """
(setq eglot-sync-connect 60 flymake-no-changes-timeout 0.1 make-backup-files nil)
(defun wait-for (condition)
  (let ((end (+ (float-time) 60)))
    (while (and (not (funcall condition)) (< (float-time) end))
      (accept-process-output nil 0.05)
      (sit-for 0.02))))
(with-current-buffer (find-file-noselect "shin.kindsl")
  (apply #'eglot--connect (eglot--guess-contact))
  (flymake-mode 1)
  (flymake-start)
  (wait-for #'flymake-diagnostics)
  (dolist (each (flymake-diagnostics)) (princ (format "%s\\n" (flymake-diagnostic-text each))))
  (let ((browse-url-browser-function (lambda (url &rest _) (princ (format "%s\\n" url)))))
    (kindsl-preview))
  (eglot-shutdown (eglot-current-server)))
"""

VIM = """
edit shin.kindsl
ALELint
let s:start = reltime()
while reltimefloat(reltime(s:start)) < 60 && empty(ale#engine#GetLoclist(bufnr('')))
  sleep 50m
endwhile
call writefile(map(copy(ale#engine#GetLoclist(bufnr(''))), {_, each -> each.text}), 'found.txt')
silent! ALEStopAllLSPs
qa!
"""

VIM_MAKE = """
edit shin.kindsl
silent make!
call writefile(map(getqflist(), {_, each -> each.lnum . ' ' . each.type . ' ' . each.text}), 'found.txt')
qa!
"""  # noqa: E501


def block(page: str, language: str, word: str) -> str:
    """Return a page's code block in a language that holds a word."""
    pattern = rf"^( *)```{language}\n(.*?)^\1```$"
    blocks = [found[2] for found in re.finditer(pattern, page, re.MULTILINE | re.DOTALL)]
    (found,) = (each for each in blocks if word in each)
    return found


def require(editor: str) -> str:
    found = shutil.which(editor)
    if found is None:
        assert os.environ.get("CI") != "true", f"{editor} is not installed"
        pytest.skip(f"{editor} is not installed")
    return found


def run(folder: Path, *command: str) -> str:
    """Run an editor with the language server on its path; return what it prints."""
    shutil.copy(GUIDE / "shin.kindsl", folder)
    (folder / "kindsl").symlink_to(GUIDE.parents[1])
    search = f"{BIN}{os.pathsep}{os.environ['PATH']}"
    places = {"HOME": str(folder), "XDG_STATE_HOME": str(folder), "XDG_CACHE_HOME": str(folder)}
    done = subprocess.run(
        command, cwd=folder, env={**os.environ, "PATH": search, **places},
        stdin=subprocess.DEVNULL, capture_output=True, encoding="utf-8", timeout=PATIENCE,
        check=False,
    )  # fmt: skip
    return done.stdout + done.stderr


def test_neovim(tmp_path: Path) -> None:
    neovim = require("nvim")
    path = block(SETTINGS, "lua", "runtimepath").splitlines()[0]
    given = f"{path}\n{block(SETTINGS, 'lua', 'start_client')}"
    (tmp_path / "init.lua").write_text(given)
    (tmp_path / "use.lua").write_text(NEOVIM)
    printed = run(tmp_path, neovim, "--headless", "-u", "init.lua", "-c", "luafile use.lua")
    assert "not positive definite" in printed, printed
    assert "http://127.0.0.1:" in printed, printed


def test_emacs(tmp_path: Path) -> None:
    emacs = require("emacs")
    start = "(when (< emacs-major-version 29) (package-initialize))\n"
    start += "(require 'eglot)\n"
    given = block(SETTINGS, "elisp", "kindsl-mode")
    (tmp_path / "init.el").write_text(start + given + EMACS)
    printed = run(tmp_path, emacs, "-q", "--batch", "-l", "init.el")
    if "Cannot open load file" in printed:
        assert os.environ.get("CI") != "true", "eglot is not installed"
        pytest.skip("eglot is not installed")
    assert "not positive definite" in printed, printed
    assert "http://127.0.0.1:" in printed, printed


def test_vim_with_ale(tmp_path: Path) -> None:
    vim = require("vim")
    begin = "set nocompatible noswapfile viminfo=\nsilent! packadd! ale\n"
    absent = "empty(globpath(&runtimepath, 'autoload/ale/linter.vim'))"
    leave = f"if {absent}\n  call writefile([], 'no-ale')\n  qa!\nendif\n"
    (tmp_path / "vimrc").write_text(
        begin + leave + block(SETTINGS, "vim", "ale_completion_enabled")
    )
    (tmp_path / "use.vim").write_text(VIM)
    printed = run(tmp_path, vim, "-es", "-u", "vimrc", "-S", "use.vim")
    if (tmp_path / "no-ale").exists():
        assert os.environ.get("CI") != "true", "ALE is not installed"
        pytest.skip("ALE is not installed")
    assert "not positive definite" in (tmp_path / "found.txt").read_text(), printed


def test_vim_with_make(tmp_path: Path) -> None:
    vim = require("vim")
    begin = "set nocompatible noswapfile viminfo=\n"
    (tmp_path / "vimrc").write_text(begin + block(USAGE, "vim", "errorformat") + VIM_MAKE)
    run(tmp_path, vim, "-es", "-u", "vimrc")
    found = (tmp_path / "found.txt").read_text().splitlines()
    assert [line.split()[1] for line in found] == ["e", "i"]
    assert found[0].startswith("12 e inertia of 'shin' is not positive definite")
