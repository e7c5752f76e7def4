"""A page's end of the wire, without a page."""

import asyncio
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager

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
