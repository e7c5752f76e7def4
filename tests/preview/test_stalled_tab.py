"""A tab whose process hangs: its socket fills up, and nothing else happens."""

import asyncio
import base64
import os
import socket

from tests.preview.robots import plain_robot
from tests.preview.websocket import connected, first_part

from kindsl.frontends.preview.server import PreviewServer


async def hanging_tab(server):
    """Open a websocket and never read from it."""
    connection = socket.create_connection(("127.0.0.1", server.port))
    key = base64.b64encode(os.urandom(16)).decode()
    connection.sendall(
        f"GET /live?token={server.token} HTTP/1.1\r\nHost: 127.0.0.1:{server.port}\r\n"
        f"Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Key: {key}\r\n"
        "Sec-WebSocket-Version: 13\r\n\r\n".encode()
    )
    return connection


async def last_pose(connection, wanted):
    return await first_part(connection, lambda part: part.get("placement") == wanted)


async def test_it_holds_up_nobody_and_grows_no_queue():
    server = PreviewServer()
    await server.start()
    robots = [plain_robot(60, seed) for seed in (1, 2)]
    await server.show("robot", robots[0], ())
    hanging = await hanging_tab(server)
    address = f"ws://127.0.0.1:{server.port}/live?token={server.token}"
    async with connected(address) as lively:
        while len(server._lines) < 2:
            await asyncio.sleep(0.01)
        sizes = []
        for edit in range(60):
            await server.show("robot", robots[edit % 2], ())
            await asyncio.sleep(0)
            sizes.append(max(len(line.tab._waiting) for line in server._lines))
        n_properties = len(server.document(None).channel.state)
        assert max(sizes) <= 2 * n_properties + 2
        joints = [m for m in server.document(None).channel.state if m.type == "joint"]
        await last_pose(lively, list(joints[-1].placement))
    hanging.close()
    await server.stop()


async def test_a_long_robot_leaves_the_loop_free_and_only_the_newest_version_is_drawn():
    server = PreviewServer()
    robots = [plain_robot(150, seed) for seed in range(6)]
    ticks = 0

    async def tick():
        nonlocal ticks
        while True:
            ticks += 1
            await asyncio.sleep(0)

    ticking = asyncio.ensure_future(tick())
    shows = [asyncio.ensure_future(server.show("robot", robot, ())) for robot in robots]
    await asyncio.gather(*shows)
    ticking.cancel()
    assert server.document(None).analysis is robots[-1]
    assert ticks > 10
