"""What a user sees where something is missing or not trusted."""

import json
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path

from playwright.sync_api import Browser, expect
from tests.vscode import code_server, models
from tests.vscode.extension_host import bare_environment
from tests.vscode.workbench import Workbench


def test_no_python_is_said_once_and_colours_stay(
    browser: Browser, vsix: Path, tmp_path: Path
) -> None:
    settings = {"kindsl.interpreter": ["/nowhere/python3"]}
    with window(browser, vsix, tmp_path, settings) as workbench:
        workbench.open("arm.kindsl", models.ARM)
        expect(workbench.notifications()).to_have_count(1)
        message = workbench.notifications().first
        expect(message).to_contain_text("needs Python 3.11 or later: /nowhere/python3: not found")
        for action in ("Select Interpreter", "Get Python", "Show Log"):
            expect(message.get_by_role("button", name=action)).to_be_visible()
        workbench.screenshot("no-python")
        words = workbench.page.locator(".view-line span span", has_text="RobotBase")
        expect(words.first).not_to_have_class("mtk1")


def test_no_numpy_is_said_once_and_findings_come(
    browser: Browser, vsix: Path, tmp_path: Path
) -> None:
    bare = bare_environment(tmp_path / "bare")
    with window(browser, vsix, tmp_path, {"kindsl.interpreter": [str(bare)]}) as workbench:
        workbench.open("broken.kindsl", models.BROKEN)
        expect(workbench.squiggles("error")).to_have_count(2)
        expect(workbench.notifications()).to_have_count(1)
        message = workbench.notifications().first
        expect(message).to_contain_text("NumPy is not installed in")
        for action in ("Install", "Select Interpreter", "Don't Show Again"):
            expect(message.get_by_role("button", name=action)).to_be_visible()
        workbench.screenshot("no-numpy")
        workbench.run("Kinematics-DSL: Open Preview to the Side")
        text = workbench.eventually(lambda: panel_text(workbench), "a reason in the panel")
        assert "-m pip install numpy meshcat tornado" in text


def test_a_workspace_that_is_not_trusted_chooses_no_program(
    browser: Browser, vsix: Path, tmp_path: Path
) -> None:
    settings = {
        "kindsl.interpreter": [sys.executable],
        "security.workspace.trust.enabled": True,
        "security.workspace.trust.startupPrompt": "never",
    }
    chosen = tmp_path / "robots" / ".vscode" / "settings.json"
    chosen.parent.mkdir(parents=True)
    chosen.write_text(json.dumps({"kindsl.path": ["/nowhere/server"]}))
    with window(browser, vsix, tmp_path, settings) as workbench:
        expect(workbench.status("Restricted Mode")).to_be_visible()
        workbench.open("broken.kindsl", models.BROKEN)
        expect(workbench.squiggles("error")).to_have_count(2)
        expect(workbench.notifications()).to_have_count(0)


@contextmanager
def window(
    browser: Browser, vsix: Path, work: Path, settings: Mapping[str, object]
) -> Iterator[Workbench]:
    """A window on the folder `robots` in an installation of its own."""
    folder = work / "robots"
    folder.mkdir(exist_ok=True)
    with code_server.running(work / "data", settings, [vsix]) as server:
        page = browser.new_page(viewport={"width": 1280, "height": 800})
        yield Workbench(page, server, folder)
        page.close()


def panel_text(workbench: Workbench) -> str | None:
    """What the preview's panel says instead of showing a robot."""
    for frame in workbench.page.frames:
        if "webview" in frame.url and frame.locator("body > p").count():
            return frame.locator("body > p").first.text_content()
    return None
