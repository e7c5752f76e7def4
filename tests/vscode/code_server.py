"""A real VS Code: the npm package `code-server` carries one, which a browser can drive.

The package is installed once into build/code-server. Its VS Code server runs on the loopback
interface behind a small front of ours (front.mjs), which does what code-server's own front does.
"""

import fcntl
import json
import os
import shutil
import subprocess
import sys
import time
import urllib.request
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple

from tests.support.ports import free_port
from tests.web import site

ROOT = Path(__file__).parents[2]
BUILD = ROOT / "build" / "code-server"
EXTENSION = ROOT / "vscode-extension"
FRONT = Path(__file__).parent / "front.mjs"
VERSION = "4.100.3"
START_SECONDS = 120
SOURCES = (
    "examples/quadruped.kindsl",
    "server",
    "grammar",
    "vscode-extension",
    "web",
    "LICENSE",
    "CHANGELOG.md",
    "docs/images/vscode-preview.png",
    "docs/images/vscode-problems.png",
)

QUIET_SETTINGS: Mapping[str, object] = {
    "security.workspace.trust.enabled": False,
    "workbench.startupEditor": "none",
    "workbench.tips.enabled": False,
    "workbench.colorTheme": "Default Dark Modern",
    "workbench.secondarySideBar.defaultVisibility": "hidden",
    "chat.commandCenter.enabled": False,
    "telemetry.telemetryLevel": "off",
    "extensions.autoUpdate": False,
    "extensions.autoCheckUpdates": False,
    "extensions.ignoreRecommendations": True,
    "update.mode": "none",
    "git.enabled": False,
    "editor.minimap.enabled": False,
    "editor.cursorBlinking": "solid",
    "workbench.reduceMotion": "on",
    "editor.acceptSuggestionOnEnter": "on",
    "files.autoSave": "off",
    "breadcrumbs.enabled": True,
    "task.autoDetect": "on",
}


class Machine(NamedTuple):
    """What a server is run by: words before its command, and its environment, None for ours."""

    before: Sequence[str] = ()
    env: Mapping[str, str] | None = None


@dataclass(frozen=True, slots=True)
class CodeServer:
    """A running server.

    Attributes:
        port: Where it listens on 127.0.0.1.
        data: Its data folder, with `user/User/settings.json`.
    """

    port: int
    data: Path

    def url(self, folder: Path, payload: Sequence[tuple[str, str]] = ()) -> str:
        """Return the address that opens a folder or workspace, with options for the window."""
        kind = "workspace" if folder.suffix == ".code-workspace" else "folder"
        address = f"http://127.0.0.1:{self.port}/?{kind}={folder}"
        return f"{address}&payload={json.dumps(payload)}" if payload else address

    def remote(self, path: Path) -> str:
        """Return a local path as the window names it."""
        return f"vscode-remote://127.0.0.1:{self.port}{path}"


def install() -> Path:
    """Return the folder of VS Code's server, installed if it is not there yet."""
    BUILD.mkdir(parents=True, exist_ok=True)
    vscode = BUILD / "node_modules" / "code-server" / "lib" / "vscode"
    with locked(BUILD / "lock"):
        stamp = BUILD / "installed"
        if not stamp.exists() or stamp.read_text() != VERSION:
            _install_into(BUILD, vscode)
            stamp.write_text(VERSION)
    return vscode


def has_terminals() -> bool:
    """Whether the terminal's native module could be compiled when VS Code was installed."""
    module = install() / "node_modules" / "node-pty" / "build" / "Release" / "pty.node"
    return module.exists()


def package_extension() -> Path:
    """Return the extension's package, built if a source is younger than it."""
    site.build_image()
    version = json.loads((EXTENSION / "package.json").read_text())["version"]
    package = EXTENSION / f"kindsl-{version}.vsix"
    with locked(ROOT / "build" / "vsix.lock"):
        if not package.exists() or package.stat().st_mtime < youngest_source():
            if not (EXTENSION / "node_modules" / ".package-lock.json").exists():
                npm("ci", "--ignore-scripts", folder=EXTENSION)
            npm("run", "package", folder=EXTENSION)
    return package


@contextmanager
def running(
    data: Path,
    settings: Mapping[str, object],
    package: Path,
    machine: Machine = Machine(),  # noqa: B008 (immutable)
) -> Iterator[CodeServer]:
    """Run a server with the given user settings and an extension's package installed."""
    write_settings(data, settings)
    shutil.copytree(Path(_installed(package).name) / "ext", data / "ext")
    behind, port = free_port(), free_port()
    listen = ["--host", "127.0.0.1", "--port", str(behind), "--without-connection-token"]
    server = [*_server(data), *listen, "--enable-smoke-test-driver"]
    front = [_node(), str(FRONT), str(port), str(behind)]
    log = data / "server.log"
    front_process = _process(front, data / "front.log")
    with _process([*machine.before, *server], log, machine.env) as process, front_process:
        _wait_until_up(port, process, log)
        yield CodeServer(port, data)


@cache
def _installed(package: Path) -> "TemporaryDirectory[str]":
    """Return a data folder in which a package was installed, once for all servers."""
    data = TemporaryDirectory()
    command = [*_server(Path(data.name)), "--install-extension", str(package)]
    _check(subprocess.run(command, **_CAPTURED))
    return data


def _server(data: Path) -> list[str]:
    """Return the command of a server with a data folder."""
    return [
        *(_node(), str(install() / "out" / "server-main.js")),
        *("--server-data-dir", str(data), "--user-data-dir", str(data / "user")),
        *("--extensions-dir", str(data / "ext"), "--accept-server-license-terms"),
        *("--telemetry-level", "off"),
    ]


@contextmanager
def _process(
    command: Sequence[str], log: Path, env: Mapping[str, str] | None = None
) -> "Iterator[subprocess.Popen[bytes]]":
    with log.open("wb") as output:
        process = subprocess.Popen(command, stdout=output, stderr=output, env=env)
        try:
            yield process
        finally:
            process.terminate()
            process.wait(60)


def write_settings(data: Path, settings: Mapping[str, object]) -> None:
    """Write the user's settings over those that keep the window quiet."""
    text = json.dumps({**QUIET_SETTINGS, **settings}, indent=1)
    for folder in ("User", "Machine"):
        (data / "user" / folder).mkdir(parents=True, exist_ok=True)
        (data / "user" / folder / "settings.json").write_text(text)


_CAPTURED = {"stdout": subprocess.PIPE, "stderr": subprocess.STDOUT, "text": True}


def _install_into(folder: Path, vscode: Path) -> None:
    (folder / "package.json").write_text('{"private": true}\n')
    npm("install", "--ignore-scripts", f"code-server@{VERSION}", folder=folder)
    for part in (vscode, vscode / "extensions"):
        npm("install", "--ignore-scripts", "--omit=dev", folder=part)
    asar = vscode / "node_modules.asar"
    if not asar.exists():
        asar.symlink_to("node_modules")
    _compile_terminals(vscode)


def _compile_terminals(vscode: Path) -> None:
    """Compile the terminal's native module, which only the test of tasks needs."""
    manifest = vscode / "package.json"
    allowed = {**json.loads(manifest.read_text()), "allowScripts": {"node-pty": True}}
    manifest.write_text(json.dumps(allowed, indent=2))
    # Its own last step may fail after the module is there: the module decides.
    subprocess.run(["npm", "rebuild", "node-pty"], cwd=vscode, check=False, **_CAPTURED)


def youngest_source(*more: str) -> float:
    """When the latest change was made to what goes into the package, or into more folders."""
    listed = ["git", "ls-files", "-z", *SOURCES, *more]
    names = subprocess.run(listed, cwd=ROOT, capture_output=True, text=True, check=True).stdout
    files = [ROOT / name for name in names.split("\0") if name]
    return max(file.stat().st_mtime for file in files if file.exists())


def npm(*arguments: str, folder: Path) -> None:
    """Run npm in a folder.

    Raises:
        RuntimeError: With what it said, if it failed.
    """
    npm = shutil.which("npm")
    if npm is None:
        raise FileNotFoundError("npm is not installed")
    command = [npm, *arguments, *(("--no-audit", "--no-fund") if arguments[0] != "run" else ())]
    # The bundled libraries are installed by the Python of the tests.
    environment = {**os.environ, "PYTHON": sys.executable}
    _check(subprocess.run(command, cwd=folder, env=environment, **_CAPTURED))


def _node() -> str:
    node = shutil.which("node")
    if node is None:
        raise FileNotFoundError("node is not installed")
    return node


def _check(result: "subprocess.CompletedProcess[str]") -> None:
    if result.returncode != 0:
        raise RuntimeError(f"{result.args} failed:\n{result.stdout}")


def _wait_until_up(port: int, process: "subprocess.Popen[bytes]", log: Path) -> None:
    deadline = time.monotonic() + START_SECONDS
    while time.monotonic() < deadline:
        if process.poll() is not None:
            break
        try:
            with urllib.request.urlopen(f"http://127.0.0.1:{port}/version", timeout=5):
                return
        except OSError:
            # Not there yet, or there and too busy to answer.
            time.sleep(0.1)
    raise RuntimeError(f"VS Code's server did not come up:\n{log.read_text(errors='replace')}")


@contextmanager
def locked(path: Path) -> Iterator[None]:
    """Let one process at a time do it."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.open("w") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        yield
