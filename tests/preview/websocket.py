"""A page's end of the wire, without a page."""

import asyncio
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from typing import Any

import umsgpack
from tornado.httpclient import HTTPRequest
from tornado.websocket import WebSocketClientConnection, websocket_connect


@asynccontextmanager
async def connected(address: str, **headers: str) -> AsyncIterator[WebSocketClientConnection]:
    """Be connected to a page's address, and hang up whatever happens.

    To the very end: a socket that is left to the garbage collector fails some later test.
    """
    page = address.replace("http:", "ws:").replace("/?", "/live?")
    connection = await websocket_connect(HTTPRequest(page, headers=headers))
    try:
        yield connection
    finally:
        connection.close()
        async with asyncio.timeout(60.0):
            while await connection.read_message() is not None:
                continue


Part = dict[str, Any]


async def whole_state(connection: WebSocketClientConnection) -> list[Part]:
    """Wait for all that a new page is told."""
    change = umsgpack.unpackb(await _received(connection))
    assert change["type"] == "change" and change["is_whole"]
    return list(change["parts"])


async def parts(connection: WebSocketClientConnection) -> AsyncIterator[Part]:
    """Yield what a page is told, part by part."""
    while True:
        for part in umsgpack.unpackb(await _received(connection))["parts"]:
            yield part


async def first_part(
    connection: WebSocketClientConnection, is_wanted: Callable[[Part], bool]
) -> Part:
    """Wait for a part of a change; what else is in that change is passed over."""
    async for part in parts(connection):
        if is_wanted(part):
            return part
    raise AssertionError("unreachable")


async def _received(connection: WebSocketClientConnection) -> bytes:
    async with asyncio.timeout(60.0):
        received = await connection.read_message()
    assert isinstance(received, bytes), "the line was closed"
    return received
