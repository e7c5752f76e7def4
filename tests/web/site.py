"""The playground, built once if a source is younger than it, and served on the loopback."""

import fcntl
import os
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from tests.vscode.browser import require

ROOT = Path(__file__).parents[2]
WEB = ROOT / "web"
IMAGE = WEB / "build" / "server"
PLAYGROUND = ROOT / "dist" / "playground"
SOURCES = ("server/kindsl", "grammar", "web", "examples", "vscode-extension/requirements.txt")


def build() -> Path:
    """Return the folder of the playground, made if it is not there or too old."""
    require("npm")
    with _locked():
        last = PLAYGROUND / "service_worker.js"
        if _is_outdated(last):
            _build_image()
            _npm("run", "playground")
    return PLAYGROUND


def build_image() -> Path:
    """Return the folder of Python with the server in it, made if it is not there or too old."""
    require("npm")
    with _locked():
        _build_image()
    return IMAGE


def _build_image() -> None:
    if not (WEB / "node_modules" / ".package-lock.json").exists():
        _npm("ci", "--ignore-scripts", "--no-audit", "--no-fund")
    if _is_outdated(IMAGE / "image.json"):
        _npm("run", "server")


@contextmanager
def _locked() -> Iterator[None]:
    lock = ROOT / "build" / "web.lock"
    lock.parent.mkdir(exist_ok=True)
    with lock.open("w") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        yield


@contextmanager
def served(folder: Path) -> Iterator[str]:
    """Serve a folder by the project's own little server; yield its address."""
    command = [sys.executable, str(WEB / "serve.py"), str(folder)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        try:
            yield process.stdout.readline().strip()
        finally:
            process.terminate()
            process.wait(60)


def shot(name: str) -> Path:
    """Return where to keep a picture."""
    folder = ROOT / "artifacts" / "web"
    folder.mkdir(parents=True, exist_ok=True)
    return folder / f"{name}.png"


def _is_outdated(made: Path) -> bool:
    return not made.exists() or made.stat().st_mtime < _youngest_source()


def _youngest_source() -> float:
    listed = ["git", "ls-files", "-z", *SOURCES]
    names = subprocess.run(listed, cwd=ROOT, capture_output=True, text=True, check=True).stdout
    files = [ROOT / name for name in names.split("\0") if name]
    return max(file.stat().st_mtime for file in files if file.exists())


def _npm(*arguments: str) -> None:
    environment = {**os.environ, "PYTHON": sys.executable}
    command = ["npm", *arguments]
    run = subprocess.run(command, cwd=WEB, env=environment, capture_output=True, text=True)
    assert run.returncode == 0, run.stdout + run.stderr
