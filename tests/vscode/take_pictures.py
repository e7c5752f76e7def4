"""Takes the pictures of the READMEs in a real VS Code: python -m tests.vscode.take_pictures"""

import shutil
import sys
import tempfile
from pathlib import Path

from playwright.sync_api import Page
from tests.vscode import browser, code_server
from tests.vscode.code_server import ROOT
from tests.vscode.workbench import Workbench

EXAMPLES = ROOT / "examples"
IMAGES = ROOT / "docs" / "images"
SETTLING_MILLISECONDS = 3000
SIZE = {"width": 1280, "height": 760}


def main() -> None:
    """Write docs/images/vscode-*.png."""
    IMAGES.mkdir(parents=True, exist_ok=True)
    package = code_server.package_extension()
    settings = {"kindsl.interpreter": [sys.executable], "editor.fontSize": 12}
    with tempfile.TemporaryDirectory() as work, browser.chromium() as chromium:
        folder = Path(work) / "robots"
        shutil.copytree(EXAMPLES, folder)
        with code_server.running(Path(work) / "data", settings, package) as server:
            workbench = Workbench(chromium.new_page(viewport=SIZE), server, folder)
            _take_problems(workbench)
            _take_preview(workbench)


def _take_problems(workbench: Workbench) -> None:
    path = workbench.open("broken_arm.kindsl")
    workbench.squiggles("error").first.wait_for()
    workbench.problems().nth(3).wait_for()
    workbench.page.locator(".editor-group-container .view-line").first.click()
    workbench.go_to("upper_arm via lift", path, 1)
    workbench.hover("upper_arm")
    _keep(workbench.page, "vscode-problems")
    workbench.press("Escape")
    workbench.hide_panel()


def _take_preview(workbench: Workbench) -> None:
    path = workbench.open("quadruped.kindsl")
    workbench.run("Explorer: Focus on Kinematic Tree View")
    workbench.pane("Kinematic Tree").get_by_role("treeitem").nth(2).wait_for()
    workbench.page.locator(".editor-group-container .view-line").first.click()
    workbench.run("Kinematics-DSL: Open Preview to the Side")
    frame = workbench.preview_frame()
    frame.locator("#joints .row").first.wait_for()
    workbench.go_to("LF_hip via", path)
    _keep(workbench.page, "vscode-preview")


def _keep(page: Page, name: str) -> None:
    # Away from what would show a tip, then until everything has come to rest.
    page.mouse.move(SIZE["width"] / 2, 2)
    page.wait_for_timeout(SETTLING_MILLISECONDS)
    page.screenshot(path=IMAGES / f"{name}.png")


if __name__ == "__main__":
    main()
