"""The playground and a browser to open it in."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, BrowserContext
from tests.vscode.browser import chromium
from tests.web import site
from tests.web.tab import SIZE, Tab

# The server's worker does nothing.
NO_SERVER = """window.Worker = new Proxy(Worker, { construct(Real, [address, ...more], made) {
    const loaded = address.startsWith("server/") ? "data:," : address;
    return Reflect.construct(Real, [loaded, ...more], made);
} })"""
# All that the page's foot says, in `said`.
NOTE_MESSAGES = """window.said = [];
const listen = ([{ target }]) => said.push(target.textContent);
addEventListener("DOMContentLoaded", () =>
    new MutationObserver(listen).observe(document.getElementById("message"), { childList: true }));
"""


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


@pytest.fixture
def context(browser: Browser) -> Iterator[BrowserContext]:
    """A browser that was never here, to which Python does not come: for what needs no server."""
    context = browser.new_context(viewport=SIZE, service_workers="block")
    context.add_init_script(NO_SERVER)
    yield context
    context.close()


@pytest.fixture(scope="module")
def tab(browser: Browser, address: str) -> Iterator[Tab]:
    """One tab on an example, for all tests that only look."""
    page = browser.new_page(viewport=SIZE)
    page.add_init_script(NOTE_MESSAGES)
    tab = Tab(page)
    tab.open(f"{address}?example=broken_arm")
    yield tab
    page.close()
