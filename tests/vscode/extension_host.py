"""Runs test modules inside the extension host of a real VS Code."""

import json
import re
import sys
import time
import venv
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

from playwright.sync_api import Browser
from tests.vscode.code_server import CodeServer
from tests.vscode.workbench import SHOTS

HOST = Path(__file__).parent / "host"
TIMEOUT_SECONDS = 240
SIZE = {"width": 640, "height": 480}

OLD_PYTHON = """#!/bin/sh
echo '{"executable": "python3", "version": [3, 8, 10], "missing": []}'
"""
HELD_PYTHON = """#!/bin/sh
until [ -e "{go}" ]; do sleep 0.05; done
exec "{python}" "$@"
"""
OLD_PYGLS = """__version__ = "0.13.1"
"""


@dataclass(slots=True)
class Outcome:
    """What a run in the extension host said."""

    code: int | None = None
    log: list[str] = field(default_factory=list)

    def __str__(self) -> str:
        results = [line for line in self.log if "TEST " in line]
        return "\n".join(results or self.log)


def run_suite(
    browser: Browser, server: CodeServer, folder: Path, suite: Path, others: Sequence[Path] = ()
) -> Outcome:
    """Run a test module in a window on a folder.

    Args:
        suite: The module, which exports `run`.
        others: Folders of further extensions, taken as they are.
    """
    outcome = Outcome()
    page = browser.new_page(viewport=SIZE)
    page.expose_function(
        "codeAutomationLog", lambda kind, arguments: outcome.log.append(_line(kind, arguments))
    )
    page.expose_function("codeAutomationExit", lambda code, logs: _finish(outcome, code))
    payload = [
        *(("extensionDevelopmentPath", server.remote(path)) for path in (HOST, *others)),
        ("extensionTestsPath", server.remote(suite)),
        ("skipWelcome", "true"),
    ]
    page.goto(server.url(folder, payload), wait_until="domcontentloaded", timeout=60_000)
    deadline = time.monotonic() + TIMEOUT_SECONDS
    while outcome.code is None and time.monotonic() < deadline:
        page.wait_for_timeout(100)
    if outcome.code is None:
        page.screenshot(path=SHOTS / f"{suite.stem}-timeout.png")
    page.close()
    return outcome


def bare_environment(folder: Path) -> Path:
    """Make an environment without any package and return its interpreter."""
    venv.create(folder, with_pip=False, symlinks=True)
    return folder / "bin" / "python"


def write_interpreters(folder: Path, work: Path) -> None:
    """Make interpreters good and bad, and tell the tests in the folder where they are."""
    bare = bare_environment(work / "bare")
    spoilt = bare_environment(work / "spoilt")
    packages = next((work / "spoilt").glob("lib/python*/site-packages"))
    for name in ("pygls", "lsprotocol", "cattrs"):
        (packages / name).mkdir()
        (packages / name / "__init__.py").write_text(OLD_PYGLS)
    old = work / "old-python"
    old.write_text(OLD_PYTHON)
    old.chmod(0o755)
    wrapped = work / "wrapped-python"
    wrapped.write_text(f'#!/bin/sh\nexec "{sys.executable}" "$@"\n')
    wrapped.chmod(0o755)
    held = work / "held-python"
    held.write_text(HELD_PYTHON.format(go=folder / "may-run", python=sys.executable))
    held.chmod(0o755)
    places = {
        "good": Path(sys.executable),
        "wrapped": wrapped,
        "bare": bare,
        "spoilt": spoilt,
        "old": old,
        "held": held,
        "stub": Path(__file__).parent / "stub_server.py",
    }
    text = json.dumps({name: str(path) for name, path in places.items()})
    (folder / "interpreters.json").write_text(text)


def _line(kind: str, arguments: object) -> str:
    parts = arguments if isinstance(arguments, list) else [arguments]
    return re.sub(r"color: \w*", "", " ".join([f"[{kind}]", *map(str, parts)]))


def _finish(outcome: Outcome, code: int) -> None:
    outcome.code = code
