"""The browser that shows pages: Debian's Chromium, without a screen, with software WebGL."""

import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from typing import NoReturn

import pytest
from playwright.sync_api import Browser, sync_playwright

# The first one has no windows and menus of its own, which cost as much as what is in the page.
BROWSERS = ("chromium-headless-shell", "chromium", "chromium-browser", "google-chrome")
# Robots are drawn by WebGL in software; what is around them without it, which costs a third less.
ARGUMENTS = (
    "--no-sandbox",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--disable-gpu-compositing",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
)
TIMEOUT = 120_000  # milliseconds


def require(*programs: str) -> str:
    """Return the first program found; else skip the test, or fail where everything must run."""
    found = next((path for path in map(shutil.which, programs) if path), None)
    if found is None:
        missing(f"{' or '.join(programs)} is not installed")
    return found


def missing(reason: str) -> NoReturn:
    """Skip the test, or fail where everything must run."""
    if os.environ.get("CI") == "true":
        pytest.fail(reason)
    pytest.skip(reason)


@contextmanager
def chromium(*more: str) -> Iterator[Browser]:
    """Run a browser, with more arguments than the usual."""
    path, arguments = require(*BROWSERS), [*ARGUMENTS, *more]
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=path, args=arguments, timeout=TIMEOUT)
        yield browser
        browser.close()
