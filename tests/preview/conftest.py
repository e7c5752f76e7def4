"""One Chromium for each file of tests, and a preview server for each test."""

import pytest
from tests.preview.browser import chromium

from kindsl.frontends.preview.server import PreviewServer


@pytest.fixture(scope="module")
async def browser():
    async with chromium() as running:
        yield running


@pytest.fixture
async def server():
    running = PreviewServer()
    await running.start()
    yield running
    await running.stop()
