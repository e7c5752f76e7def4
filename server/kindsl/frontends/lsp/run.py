"""Runs the server over stdio or a socket until the client says `exit` or goes away."""

import asyncio
import contextlib
import os
import signal
import sys

from kindsl.frontends.lsp.server import KindslLanguageServer
from kindsl.frontends.lsp.session import memory
from kindsl.frontends.lsp.session.worker import start_task
from kindsl.frontends.lsp.wire.transport import MessageWriter, open_stdio, read_messages

_POLL_SECONDS = 2.0


async def serve_stdio(server: KindslLanguageServer) -> int:
    """Talk over stdin and stdout; return the exit code."""
    reader, writer = await open_stdio()
    return await _serve(server, reader, writer)


async def serve_tcp(server: KindslLanguageServer, host: str, port: int) -> int:
    """Wait for one client on a socket and talk to it; return the exit code."""
    code = asyncio.get_running_loop().create_future()

    async def connected(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        listener.close()
        code.set_result(await _serve(server, reader, writer))

    listener = await asyncio.start_server(connected, host, port, limit=1 << 24)
    address = listener.sockets[0].getsockname()
    print(f"kindsl language server on {address[0]}:{address[1]}", file=sys.stderr, flush=True)
    return int(await code)


async def _serve(
    server: KindslLanguageServer, reader: asyncio.StreamReader, writer: MessageWriter
) -> int:
    memory.tune()
    server.session.loop = asyncio.get_running_loop()
    server.protocol.set_writer(writer)
    reading = asyncio.ensure_future(read_messages(reader, server.protocol.receive))
    server.session.on_parent_known = lambda process_id: _watch_parent(process_id, reading)
    with contextlib.suppress(NotImplementedError):
        asyncio.get_running_loop().add_signal_handler(signal.SIGTERM, reading.cancel)
    with contextlib.suppress(asyncio.CancelledError):
        await reading
    await server.session.close()
    await server.protocol.settle()
    if isinstance(writer, asyncio.StreamWriter):
        writer.transport.set_write_buffer_limits(0)
        with contextlib.suppress(ConnectionError):
            await writer.drain()
    writer.close()
    return server.protocol.exit_code


def _watch_parent(process_id: int | None, reading: "asyncio.Future[None]") -> None:
    """End the reading when the editor that started the server has died."""
    if process_id is None or process_id <= 0:
        return

    async def watch() -> None:
        while _is_alive(process_id):
            await asyncio.sleep(_POLL_SECONDS)
        reading.cancel()

    task = start_task(watch())
    reading.add_done_callback(lambda _: task.cancel())


def _is_alive(process_id: int) -> bool:
    if sys.platform == "win32":
        return _is_alive_on_windows(process_id)
    try:
        os.kill(process_id, 0)
    except (ProcessLookupError, OverflowError):
        return False
    except PermissionError:
        return True
    return True


def _is_alive_on_windows(process_id: int) -> bool:
    import ctypes

    synchronize, timed_out = 0x00100000, 0x102
    kernel = ctypes.windll.kernel32  # type: ignore[attr-defined]
    handle = kernel.OpenProcess(synchronize, False, process_id)
    if not handle:
        return False
    try:
        return bool(kernel.WaitForSingleObject(handle, 0) == timed_out)
    finally:
        kernel.CloseHandle(handle)
