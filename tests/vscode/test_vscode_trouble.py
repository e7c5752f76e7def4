"""What a user sees where something is missing or not trusted."""

import re
import sys
from collections.abc import Iterator, Mapping
from contextlib import suppress
from pathlib import Path

import pytest
from playwright.sync_api import Error, Frame, expect
from tests.vscode import code_server, models
from tests.vscode.code_server import CodeServer
from tests.vscode.extension_host import bare_environment
from tests.vscode.workbench import Workbench

STUB = Path(__file__).with_name("stub_server.py")


@pytest.fixture(scope="module")
def server(vsix: Path, tmp_path_factory: pytest.TempPathFactory) -> Iterator[CodeServer]:
    """VS Code's server, with an interpreter configured that is not there."""
    settings = {"kindsl.interpreter": ["/nowhere/python3"]}
    with code_server.running(tmp_path_factory.mktemp("vscode"), settings, vsix) as running:
        yield running


def test_a_setting_that_names_no_python_is_said_once_and_colours_stay(workbench: Workbench) -> None:
    workbench.open("arm.kindsl", models.ARM)
    expect(workbench.notifications()).to_have_count(1)
    message = workbench.notifications().first
    expect(message).to_contain_text(
        "The setting kindsl.interpreter names no Python 3.11 or later: /nowhere/python3: not found"
    )
    actions = ["Open Settings", "Select Interpreter", "Show Log"]
    for action in actions:
        expect(message.get_by_role("button", name=action)).to_be_visible()
    workbench.run("Kinematics-DSL: Open Preview to the Side")
    panel = workbench.eventually(lambda: reason_in_panel(workbench), "a reason in the panel")
    expect(panel.locator("p")).to_contain_text("names no Python 3.11 or later")
    expect(panel.locator("button")).to_have_text(actions)
    workbench.screenshot("no-python")
    panel.locator("button", has_text="Select Interpreter").click()
    expect(workbench.page.locator(".quick-input-widget")).to_be_visible()
    workbench.press("Escape")
    words = workbench.page.locator(".view-line span span", has_text="RobotBase")
    expect(words.first).not_to_have_class("mtk1")


def test_a_python_without_packages_is_enough(
    workbench: Workbench, server: CodeServer, tmp_path: Path
) -> None:
    settings = {"kindsl.interpreter": [str(bare_environment(tmp_path / "bare"))]}
    configure(workbench, server, settings)
    workbench.open("broken.kindsl", models.BROKEN)
    expect(workbench.squiggles("error")).to_have_count(2)
    workbench.open("arm.kindsl", models.ARM)
    workbench.run("Kinematics-DSL: Open Preview to the Side")
    frame = workbench.preview_frame()
    expect(frame.locator("#robot")).to_have_text("arm")
    frame.get_by_role("slider", name="elbow", exact=True).fill("1.2")
    expect(workbench.notifications()).to_have_count(0)
    workbench.screenshot("bare-python")


def test_a_restart_while_the_tree_is_awaited_is_no_error(
    workbench: Workbench, server: CodeServer
) -> None:
    configure(workbench, server, {"kindsl.path": [sys.executable, str(STUB), "--silent-tree"]})
    workbench.open("arm.kindsl", models.ARM)
    workbench.run("Explorer: Focus on Kinematic Tree View")
    asked = workbench.problems().filter(has_text="tree of process")
    first = asked.inner_text()
    workbench.run("Kinematics-DSL: Restart Server")
    expect(asked).not_to_have_text(first)
    # A message pops up a while after it came, but is listed at once.
    titles = workbench.page.locator(".notifications-center-header-title:visible")
    workbench.run_until("Notifications: Show Notifications", titles)
    expect(titles).to_have_text(re.compile("no new notifications", re.IGNORECASE))


def configure(workbench: Workbench, server: CodeServer, settings: Mapping[str, object]) -> None:
    """Change the user's settings in a window without documents and messages."""
    workbench.run("View: Close All Editors")
    workbench.run("Notifications: Clear All Notifications")
    code_server.write_settings(server.data, settings)


def reason_in_panel(workbench: Workbench) -> Frame | None:
    """The preview's panel, where it says something instead of showing a robot."""
    for frame in workbench.page.frames:
        # VS Code may replace a frame while it is looked at.
        with suppress(Error):
            if "webview" in frame.url and frame.locator("body > p").count():
                return frame
    return None
