"""Runs the server over stdio or a socket until the client says `exit` or goes away."""

import asyncio
import contextlib
import signal
import sys

from kindsl.frontends.lsp.server import KindslLanguageServer
from kindsl.frontends.lsp.session import memory
from kindsl.frontends.lsp.session.worker import start_task
from kindsl.frontends.lsp.wire import parent_watch
from kindsl.frontends.lsp.wire.frames import read_messages
from kindsl.frontends.lsp.wire.transport import MessageWriter, TransportWriter, open_stdio


async def serve_stdio(server: KindslLanguageServer) -> int:
    """Talk over stdin and stdout; return the exit code."""
    reader, writer = await open_stdio()
    return await _serve(server, reader, writer)


async def serve_tcp(server: KindslLanguageServer, host: str, port: int) -> int:
    """Wait for one client on a socket and talk to it; return the exit code."""
    code = asyncio.get_running_loop().create_future()

    async def connected(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        listener.close()
        code.set_result(await _serve(server, reader, TransportWriter(writer.transport)))

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
    await writer.flush()
    writer.close()
    return server.protocol.exit_code


def _watch_parent(process_id: int | None, reading: "asyncio.Future[None]") -> None:
    if process_id is None or process_id <= 0:
        return

    async def watch() -> None:
        await parent_watch.wait_for_exit(process_id)
        reading.cancel()

    task = start_task(watch())
    reading.add_done_callback(lambda _: task.cancel())
