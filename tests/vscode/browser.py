"""The browser that shows VS Code: Debian's Chromium, without a screen, with software WebGL."""

import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from typing import NoReturn

import pytest
from playwright.sync_api import Browser, BrowserType, sync_playwright

ARGUMENTS = (
    "--no-sandbox",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
)
TIMEOUT = 120_000  # milliseconds
# For windows in which nothing is drawn but the workbench: a third less work.
UNDRAWN = ("--disable-gpu",)


def require(program: str) -> str:
    """Return a program's path; without it skip the test, or fail where everything must run."""
    path = shutil.which(program)
    if path is None:
        missing(f"{program} is not installed")
    return path


def missing(reason: str) -> NoReturn:
    """Skip the test, or fail where everything must run."""
    if os.environ.get("CI") == "true":
        pytest.fail(reason)
    pytest.skip(reason)


@contextmanager
def chromium(*more: str) -> Iterator[Browser]:
    """Run a browser, with more arguments than the usual."""
    with sync_playwright() as playwright, launched(playwright.chromium, *more) as browser:
        yield browser


@contextmanager
def launched(kind: BrowserType, *more: str) -> Iterator[Browser]:
    """Run one more browser of a kind, with more arguments than the usual."""
    path = require("chromium")
    browser = kind.launch(executable_path=path, args=[*ARGUMENTS, *more], timeout=TIMEOUT)
    yield browser
    browser.close()
