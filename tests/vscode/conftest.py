"""A real VS Code with the extension's package installed, and a browser to look at it."""

import sys
from collections.abc import Generator, Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser
from tests.vscode import browser as browser_module
from tests.vscode import code_server
from tests.vscode.code_server import CodeServer
from tests.vscode.workbench import Workbench


@pytest.fixture(scope="session")
def vsix() -> Path:
    """The extension's package, freshly built."""
    browser_module.require("node")
    browser_module.require("npm")
    return code_server.package_extension()


@pytest.fixture(scope="module")
def server(vsix: Path, tmp_path_factory: pytest.TempPathFactory) -> Iterator[CodeServer]:
    """VS Code's server, with the interpreter of the tests configured."""
    settings = {"kindsl.interpreter": [sys.executable]}
    with code_server.running(tmp_path_factory.mktemp("vscode"), settings, vsix) as running:
        yield running


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    """Closed with the module: the loop of Playwright must not outlive it."""
    with browser_module.chromium() as running:
        yield running


@pytest.fixture(scope="module")
def workbench(
    browser: Browser, server: CodeServer, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[Workbench]:
    """One window on an empty folder."""
    page = browser.new_page(viewport={"width": 1440, "height": 900})
    yield Workbench(page, server, tmp_path_factory.mktemp("robots"))
    page.close()


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(
    item: pytest.Item, call: pytest.CallInfo[None]
) -> Generator[None, pytest.TestReport, pytest.TestReport]:
    """Keep a picture of the window in which a test failed."""
    report = yield
    window = getattr(item, "funcargs", {}).get("workbench")
    if report.when == "call" and report.failed and window is not None:
        window.screenshot(f"failed-{item.name}")
    return report
