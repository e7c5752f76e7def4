"""What a user sees where something is missing or not trusted."""

import json
import sys
import zipfile
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Frame, expect
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
        actions = ["Select Interpreter", "Get Python", "Show Log"]
        for action in actions:
            expect(message.get_by_role("button", name=action)).to_be_visible()
        workbench.run("Kinematics-DSL: Open Preview to the Side")
        panel = workbench.eventually(lambda: reason_in_panel(workbench), "a reason in the panel")
        expect(panel.locator("p")).to_contain_text("needs Python 3.11 or later")
        expect(panel.locator("button")).to_have_text(actions)
        workbench.screenshot("no-python")
        panel.locator("button", has_text="Select Interpreter").click()
        expect(workbench.page.locator(".quick-input-widget")).to_be_visible()
        workbench.press("Escape")
        words = workbench.page.locator(".view-line span span", has_text="RobotBase")
        expect(words.first).not_to_have_class("mtk1")


@pytest.fixture(scope="module")
def offered(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where pip looks for packages in the window without packages."""
    return tmp_path_factory.mktemp("wheels")


@pytest.fixture(scope="module")
def without_packages(
    browser: Browser, vsix: Path, tmp_path_factory: pytest.TempPathFactory, offered: Path
) -> Iterator[Workbench]:
    """A window whose Python has no package and no network."""
    work = tmp_path_factory.mktemp("bare")
    settings = {"kindsl.interpreter": [str(bare_environment(work / "bare"))]}
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("PIP_NO_INDEX", "1")
        patch.setenv("PIP_FIND_LINKS", str(offered))
        with window(browser, vsix, work, settings) as workbench:
            yield workbench


def test_a_python_without_packages_is_enough(without_packages: Workbench) -> None:
    workbench = without_packages
    workbench.open("broken.kindsl", models.BROKEN)
    expect(workbench.squiggles("error")).to_have_count(2)
    workbench.open("arm.kindsl", models.ARM)
    workbench.run("Kinematics-DSL: Open Preview to the Side")
    frame = workbench.preview_frame()
    expect(frame.locator("#robot")).to_have_text("arm")
    frame.get_by_role("slider", name="elbow", exact=True).fill("1.2")
    expect(workbench.notifications()).to_have_count(0)
    workbench.screenshot("bare-python")


def test_what_is_missing_is_installed_by_a_command(
    without_packages: Workbench, offered: Path
) -> None:
    workbench = without_packages
    workbench.open("arm.kindsl", models.ARM)
    workbench.run("Kinematics-DSL: Install NumPy for This Extension")
    expect(workbench.notifications().first).to_contain_text("the package index offers nothing")
    write_wheel(offered, "numpy")
    workbench.screenshot("nothing-offered")
    workbench.notifications().first.get_by_role("button", name="Try Again").click()
    installed = "data/user/User/globalStorage/kindsl.kindsl/packages/*/numpy/__init__.py"
    work = workbench.folder.parent
    workbench.eventually(lambda: list(work.glob(installed)), "the installed package")
    expect(workbench.notifications()).to_have_count(0)


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


def reason_in_panel(workbench: Workbench) -> Frame | None:
    """The preview's panel, where it says something instead of showing a robot."""
    for frame in workbench.page.frames:
        if "webview" in frame.url and frame.locator("body > p").count():
            return frame
    return None


def write_wheel(folder: Path, name: str) -> None:
    """Write an empty package that pip can install."""
    info = f"{name}-1.0.dist-info"
    files = {
        f"{name}/__init__.py": "",
        f"{info}/METADATA": f"Metadata-Version: 2.1\nName: {name}\nVersion: 1.0\n",
        f"{info}/WHEEL": "Wheel-Version: 1.0\nRoot-Is-Purelib: true\nTag: py3-none-any\n",
        f"{info}/RECORD": "",
    }
    with zipfile.ZipFile(folder / f"{name}-1.0-py3-none-any.whl", "w") as wheel:
        for file, text in files.items():
            wheel.writestr(file, text)
