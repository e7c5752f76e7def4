"""Bytes in and out: over stdio or a socket, in the running event loop.

Nothing here waits in a thread while messages flow: on POSIX both pipes belong to the event loop,
so a busy handler cannot starve the reader, and a client that does not read cannot block us.
"""

import asyncio
import contextlib
import os
import stat
import sys
import threading

_BUFFER = 1 << 24
_READ = 1 << 16


async def open_stdio() -> "tuple[asyncio.StreamReader, MessageWriter]":
    """Take over stdin and stdout; from now on `print` writes to stderr."""
    incoming, outgoing = os.dup(0), os.dup(1)
    sys.stdout.flush()
    os.dup2(2, 1)
    sys.stdout = sys.stderr
    return await _open_reader(incoming), await _open_writer(outgoing)


class TransportWriter:
    """Writes through an asyncio transport: at once, or when the other side reads."""

    __slots__ = ("_transport",)

    def __init__(self, transport: asyncio.WriteTransport) -> None:
        self._transport = transport

    def write(self, data: bytes) -> None:
        """Send, or keep until the other side reads."""
        self._transport.write(data)

    def close(self) -> None:
        """Send what is kept, then no more."""
        self._transport.close()

    async def flush(self) -> None:
        """Wait until all is sent, or the other side is gone."""
        while self._transport.get_write_buffer_size() and not self._transport.is_closing():
            await asyncio.sleep(0.005)


class BlockingMessageWriter:
    """Writes to a file descriptor that the event loop cannot watch (a file, Windows)."""

    __slots__ = ("_descriptor",)

    def __init__(self, descriptor: int) -> None:
        self._descriptor = descriptor

    def write(self, data: bytes) -> None:
        """Send at once."""
        view = memoryview(data)
        while view:
            view = view[os.write(self._descriptor, view) :]

    def close(self) -> None:
        """Send no more."""
        with contextlib.suppress(OSError):
            os.close(self._descriptor)

    async def flush(self) -> None:
        """Everything has been sent already."""


# Writes framed messages out: `write` never waits for the other side, `flush` does.
MessageWriter = TransportWriter | BlockingMessageWriter


async def _open_reader(descriptor: int) -> asyncio.StreamReader:
    loop = asyncio.get_running_loop()
    reader = asyncio.StreamReader(limit=_BUFFER)
    if _can_be_watched(descriptor):
        pipe = os.fdopen(descriptor, "rb", buffering=0)
        await loop.connect_read_pipe(lambda: asyncio.StreamReaderProtocol(reader), pipe)
    else:
        feed = threading.Thread(target=_feed, args=(descriptor, reader, loop), daemon=True)
        feed.start()
    return reader


async def _open_writer(descriptor: int) -> MessageWriter:
    if not _can_be_watched(descriptor):
        return BlockingMessageWriter(descriptor)
    pipe = os.fdopen(descriptor, "wb", buffering=0)
    loop = asyncio.get_running_loop()
    transport, _ = await loop.connect_write_pipe(asyncio.BaseProtocol, pipe)
    return TransportWriter(transport)


def _can_be_watched(descriptor: int) -> bool:
    """Return whether the event loop can wait for it: pipes and sockets on POSIX."""
    mode = os.fstat(descriptor).st_mode
    return os.name == "posix" and (stat.S_ISFIFO(mode) or stat.S_ISSOCK(mode))


def _feed(descriptor: int, reader: asyncio.StreamReader, loop: asyncio.AbstractEventLoop) -> None:
    with contextlib.suppress(RuntimeError):  # the loop has ended
        while chunk := os.read(descriptor, _READ):
            loop.call_soon_threadsafe(reader.feed_data, chunk)
        loop.call_soon_threadsafe(reader.feed_eof)
