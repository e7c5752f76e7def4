"""Takes the preview's pictures for the documentation: `python -m tests.preview.screenshots`."""

import asyncio
import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

from playwright.async_api import Page
from tests.preview.browser import chromium, opened, until
from tests.preview.robots import EXAMPLES, ROOT

IMAGES = ROOT / "docs" / "images"
PAGE_SIZE = {"width": 1280, "height": 860}
POSE = {"LF_HFE": 0.6, "LF_KFE": -1.1, "RH_HFE": -0.4, "RH_KFE": 0.8, "RF_HAA": -0.3}


def main() -> None:
    IMAGES.mkdir(parents=True, exist_ok=True)
    for example in sorted(EXAMPLES.glob("*.kindsl")):
        preview(example, "--screenshot", IMAGES / f"preview-{example.stem}.png")
    with TemporaryDirectory() as folder:
        page = Path(folder, "quadruped.html")
        preview(EXAMPLES / "quadruped.kindsl", "--export", page)
        asyncio.run(take_page(page, IMAGES / "preview-page.png"))


def preview(*arguments: object) -> None:
    command = [sys.executable, "-m", "kindsl", "preview", *map(str, arguments)]
    subprocess.run(command, check=True)


async def take_page(file: Path, target: Path) -> None:
    """Picture the whole page: a pose, a chosen link, gravity torques."""
    async with chromium() as browser, opened(browser, file.as_uri()) as page:
        await page.set_viewport_size(PAGE_SIZE)
        await page.locator("#joints .row").nth(11).wait_for()
        for joint, value in POSE.items():
            await fill(page, joint, value)
        await page.locator("[data-category=torque]").check()
        await page.locator(".label.link", has_text="LF_shank").click()
        await until(page, "!document.getElementById('selection').hidden")
        await page.evaluate("document.activeElement.blur()")
        await page.mouse.move(5, 5)
        await page.wait_for_timeout(300)
        await page.screenshot(path=target)


async def fill(page: Page, joint: str, value: float) -> None:
    box = page.get_by_label(f"{joint}, typed")
    await box.fill(str(value))
    await box.press("Enter")


if __name__ == "__main__":
    main()
