"""The playground and a browser to open it in."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser
from tests.vscode.browser import chromium
from tests.web import site
from tests.web.tab import Tab


@pytest.fixture(scope="session")
def playground() -> Path:
    """The folder of the playground."""
    return site.build()


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    """Closed with the module: the loop of Playwright must not outlive it."""
    with chromium() as running:
        yield running


@pytest.fixture(scope="module")
def address(playground: Path) -> Iterator[str]:
    """Where the playground is served."""
    with site.served(playground) as served:
        yield served


@pytest.fixture(scope="module")
def tab(browser: Browser, address: str) -> Iterator[Tab]:
    """One tab on an example, for all tests that only look."""
    page = browser.new_page(viewport={"width": 1400, "height": 850})
    tab = Tab(page)
    tab.open(f"{address}?example=broken_arm")
    yield tab
    page.close()
