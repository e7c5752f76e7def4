"""A picture of an exported page, taken by a Chromium without a window."""

import os
import shutil
import subprocess
import tempfile
from pathlib import Path

from kindsl.frontends.preview.assets import PreviewUnavailableError
from kindsl.language.text.writing import write_file

BROWSERS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome")
SIZE = "1200,800"  # width and height, pixels
_PATIENCE = 120.0  # seconds
_FLAGS = (
    "--headless", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-quic",
    "--no-first-run", "--disable-background-networking", "--disable-component-update",
    "--disable-sync", "--hide-scrollbars", "--force-color-profile=srgb",
)  # fmt: skip


def take_screenshot(page: str, target: Path) -> None:
    """Write a PNG of an exported page's picture, without its panel.

    Raises:
        PreviewUnavailableError: There is no Chromium, or it fails.
    """
    browser = find_browser()
    with tempfile.TemporaryDirectory(prefix="kindsl-", ignore_cleanup_errors=True) as folder:
        source = Path(folder, "page.html")
        source.write_text(page, encoding="utf-8")
        picture = Path(folder, "picture.png")
        _run(_command(browser, source, picture))
        if not picture.is_file():
            raise PreviewUnavailableError(f"'{browser}' has drawn nothing")
        write_file(str(target), picture.read_bytes())


def find_browser() -> str:
    """Return the path of a Chromium.

    Raises:
        PreviewUnavailableError: There is none.
    """
    found = (shutil.which(name) for name in BROWSERS)
    browser = next((path for path in found if path), None)
    if browser is None:
        raise PreviewUnavailableError("a screenshot needs Chromium or Chrome, and there is none")
    return browser


def _command(browser: str, source: Path, picture: Path) -> list[str]:
    # Chromium's sandbox does not work for the superuser, as in containers.
    is_superuser = hasattr(os, "geteuid") and os.geteuid() == 0
    return [
        browser, *_FLAGS, *(["--no-sandbox"] if is_superuser else []),
        f"--user-data-dir={source.parent / 'profile'}", f"--window-size={SIZE}",
        f"--screenshot={picture}",
        f"{source.as_uri()}#picture",
    ]  # fmt: skip


def _run(command: list[str]) -> None:
    try:
        subprocess.run(command, check=True, capture_output=True, timeout=_PATIENCE)
    except subprocess.TimeoutExpired as error:
        raise PreviewUnavailableError(f"'{command[0]}' did not finish in time") from error
    except (subprocess.CalledProcessError, OSError) as error:
        raise PreviewUnavailableError(f"'{command[0]}' failed: {error}") from error
