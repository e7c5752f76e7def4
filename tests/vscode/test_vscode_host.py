"""The extension, installed from its package, tested from inside the extension host."""

from pathlib import Path

import pytest
from playwright.sync_api import Browser
from tests.support.examples import urdf_link
from tests.vscode import code_server, models
from tests.vscode.browser import missing
from tests.vscode.code_server import CodeServer
from tests.vscode.extension_host import HOST, run_suite, write_interpreters


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    robots = tmp_path / "robots"
    robots.mkdir()
    (robots / "arm.kindsl").write_text(models.ARM)
    (robots / "broken.kindsl").write_text(models.BROKEN)
    return robots


def test_features(browser: Browser, server: CodeServer, folder: Path) -> None:
    outcome = run_suite(browser, server, folder, HOST / "features.js")
    assert outcome.code == 0, str(outcome)


def test_waking(browser: Browser, server: CodeServer, tmp_path: Path) -> None:
    (tmp_path / "package.xml").write_text('<?xml version="1.0"?>\n<package/>\n')
    inertia = 'ixx="0.01" ixy="0" ixz="0" iyy="0.02" iyz="0" izz="0.09"'
    (tmp_path / "arm.urdf").write_text(urdf_link(inertia))
    outcome = run_suite(browser, server, tmp_path, HOST / "waking.js")
    assert outcome.code == 0, str(outcome)


def test_tasks(browser: Browser, server: CodeServer, folder: Path) -> None:
    if not code_server.has_terminals():
        missing("the terminal of VS Code could not be compiled")
    (folder / "broken.kindsl").write_text(models.ARM.replace("lower via elbow", "lower via x"))
    outcome = run_suite(browser, server, folder, HOST / "tasks.js")
    assert outcome.code == 0, str(outcome)


def test_discovery(browser: Browser, server: CodeServer, folder: Path, tmp_path: Path) -> None:
    write_interpreters(folder, tmp_path)
    outcome = run_suite(browser, server, folder, HOST / "discovery.js")
    assert outcome.code == 0, str(outcome)


def test_the_python_extension(
    browser: Browser, server: CodeServer, folder: Path, tmp_path: Path
) -> None:
    write_interpreters(folder, tmp_path)
    stand_in = HOST / "ms_python"
    outcome = run_suite(browser, server, folder, HOST / "python_extension.js", [stand_in])
    assert outcome.code == 0, str(outcome)
