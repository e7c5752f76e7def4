"""The extension's own page, as the editor shows it after the package was installed."""

from playwright.sync_api import Frame
from tests.vscode.workbench import Workbench

SIZES = "() => [...document.images].map((image) => image.naturalWidth)"


def test_the_page_shows_its_pictures(workbench: Workbench) -> None:
    workbench.run("View: Show Extensions")
    workbench.page.locator(".extension-list-item", has_text="Kinematics-DSL").first.click()

    def pictures() -> list[int] | None:
        for frame in workbench.page.frames:
            if "webview" in frame.url and len(sizes(frame)) >= 2:
                return sizes(frame)
        return None

    def drawn() -> bool:
        found = pictures()
        return found is not None and min(found) > 100

    workbench.eventually(drawn, "pictures in the extension's page")
    workbench.screenshot("extension-page")


def sizes(frame: Frame) -> list[int]:
    """Return the width of each picture in a frame, 0 for one that is not shown."""
    found: list[int] = frame.evaluate(SIZES)
    return found
