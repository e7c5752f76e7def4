"""The preview behind `kindsl.preview`: kept up to date, and back from a click to the source."""

import asyncio
import json
from collections.abc import AsyncIterator, Iterator
from contextlib import asynccontextmanager
from typing import Any

import pytest
from tests.support import robots
from tests.support.lsp import RawClient, ready_client

pytest.importorskip("tornado", reason="the preview needs tornado")
from tests.preview.websocket import connected, first_part, whole_state
from tornado.websocket import WebSocketClientConnection

ROBOT = robots.ONE_LINK.replace("mass = m", "mass = 1.0").replace("0.0) rot", "0.5) rot")
JOINT_LINE = 4
HEIGHT = {
    "start": {"line": JOINT_LINE, "character": 53},
    "end": {"line": JOINT_LINE, "character": 54},
}
URI = "untitled:shown"
SHOWS = {"window": {"showDocument": {"support": True}}}


@pytest.fixture(scope="module")
def client() -> Iterator[RawClient]:
    with ready_client(SHOWS) as client:
        client.open(URI, ROBOT)
        client.diagnostics(URI)
        yield client


def preview(client: RawClient) -> str:
    arguments = {"command": "kindsl.preview", "arguments": [URI]}
    url: str = client.request("workspace/executeCommand", arguments)["url"]
    return url


@asynccontextmanager
async def page_of(client: RawClient) -> AsyncIterator[WebSocketClientConnection]:
    async with connected(preview(client)) as connection:
        await whole_state(connection)
        yield connection


def test_a_document_keeps_its_address(client: RawClient) -> None:
    address = preview(client)
    assert address.startswith("http://127.0.0.1:")
    assert preview(client) == address


def is_source_shown(message: dict[str, Any]) -> bool:
    """Whether the editor is to show the document, and not the page's address."""
    return message.get("method") == "window/showDocument" and message["params"]["uri"] == URI


async def test_a_click_shows_the_source(client: RawClient) -> None:
    async with page_of(client) as connection:
        await connection.write_message(
            json.dumps({"type": "reveal", "kind": "joint", "name": "first"})
        )
        shown = await asyncio.to_thread(client.wait, is_source_shown)
        assert shown["params"]["selection"]["start"]["line"] == JOINT_LINE


async def test_a_keystroke_is_seen(client: RawClient) -> None:
    async with page_of(client) as connection:
        client.change(URI, 2, {"range": HEIGHT, "text": "9"})
        await until_drawn_higher(connection)


async def until_drawn_higher(connection: WebSocketClientConnection) -> None:
    await first_part(connection, lambda m: m.get("placement", [])[12:15] == [0.0, 0.0, 9.5])


async def test_a_keystroke_is_seen_long_before_it_is_checked() -> None:
    settings = {"kindsl": {"diagnostics": {"delay": 60_000}}}
    with ready_client(SHOWS, initializationOptions=settings) as client:
        client.open(URI, ROBOT)
        client.diagnostics(URI)
        async with page_of(client) as connection:
            client.change(URI, 2, {"range": HEIGHT, "text": "9"})
            await until_drawn_higher(connection)
        checked = [m["params"].get("version") for m in client.messages if "params" in m]
        assert 2 not in checked


async def test_what_is_wrong_is_listed_when_it_is_known(client: RawClient) -> None:
    async with page_of(client) as connection:
        end = {"line": JOINT_LINE, "character": 0}
        client.change(
            URI, 3, {"range": {"start": end, "end": end}, "text": "link one { id = 2 }\n"}
        )
        await first_part(connection, lambda m: m.get("line") == JOINT_LINE + 1)
        client.change(URI, 4, {"text": ROBOT})


async def test_the_cursor_lights_up_what_it_is_on(client: RawClient) -> None:
    async with page_of(client) as connection:
        where = {"textDocument": {"uri": URI}, "position": {"line": 2, "character": 6}}
        assert await asyncio.to_thread(client.request, "textDocument/documentHighlight", where)
        message = await first_part(connection, lambda m: m["type"] == "highlight")
        assert (message["kind"], message["name"]) == ("link", "one")
