"""One Chromium for each file of tests, and a preview server for each test, all at one address."""

import pytest
from tests.preview.browser import Address, chromium


@pytest.fixture(scope="module")
async def browser():
    async with chromium() as running:
        yield running


@pytest.fixture(scope="module")
def address():
    return Address()


@pytest.fixture
async def server(address):
    running = await address.start()
    yield running
    await running.stop()
