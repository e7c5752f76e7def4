"""The preview behind `kindsl.preview`: kept up to date, and back from a click to the source."""

import asyncio
import json
from collections.abc import Iterator

import pytest
from tests.support.lsp import RawClient, ready_client

pytest.importorskip("tornado", reason="the preview needs tornado")
from tests.preview.hanging_up import hang_up
from tornado.websocket import WebSocketClientConnection, websocket_connect

ROBOT = """\
Robot R {
RobotBase base { children { one via first } }
link one { id = 1 children {} }
r_joint first { ref_frame { translation = (0.0, 0.0, 0.5) rotation = (0.0, 0.0, 0.0) } }
}
"""
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


async def connected(client: RawClient) -> WebSocketClientConnection:
    address = preview(client).replace("http://", "ws://").replace("/?", "/live?")
    connection = await websocket_connect(address)
    assert await received(connection)
    return connection


async def received(connection: WebSocketClientConnection) -> object:
    return await asyncio.wait_for(connection.read_message(), 20)


def test_a_document_keeps_its_address(client: RawClient) -> None:
    assert preview(client) == preview(client)
    assert preview(client).startswith("http://127.0.0.1:")


async def test_a_click_shows_the_source(client: RawClient) -> None:
    connection = await connected(client)
    await connection.write_message(json.dumps({"type": "reveal", "kind": "joint", "name": "first"}))
    shown = await asyncio.to_thread(client.notification, "window/showDocument")
    assert shown["uri"] == URI
    assert shown["selection"]["start"]["line"] == 3
    await hang_up(connection)


async def test_a_keystroke_is_seen(client: RawClient) -> None:
    connection = await connected(client)
    while True:
        try:
            await asyncio.wait_for(connection.read_message(), 0.3)
        except TimeoutError:
            break
    place = {"start": {"line": 3, "character": 53}, "end": {"line": 3, "character": 54}}
    client.change(URI, 2, {"range": place, "text": "9"})
    assert await received(connection)
    await hang_up(connection)


async def test_the_cursor_lights_up_what_it_is_on(client: RawClient) -> None:
    connection = await connected(client)
    while True:
        try:
            await asyncio.wait_for(connection.read_message(), 0.3)
        except TimeoutError:
            break
    where = {"textDocument": {"uri": URI}, "position": {"line": 2, "character": 6}}
    assert await asyncio.to_thread(client.request, "textDocument/documentHighlight", where)
    assert b"one" in bytes(await received(connection))
    await hang_up(connection)
