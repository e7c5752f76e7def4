"""Ends a websocket to its very end, so that no socket is left to the garbage collector."""

import asyncio

from tornado.websocket import WebSocketClientConnection


async def hang_up(connection: WebSocketClientConnection) -> None:
    """Close a connection that nobody has seen the end of, and wait until the other side has too."""
    connection.close()
    async with asyncio.timeout(30.0):
        while await connection.read_message() is not None:
            continue
