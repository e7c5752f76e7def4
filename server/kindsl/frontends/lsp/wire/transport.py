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

from pygls.io_ import StdoutWriter

_BUFFER = 1 << 24
_READ = 1 << 16
# The second one is for what the event loop cannot watch: a file, Windows.
MessageWriter = asyncio.StreamWriter | StdoutWriter


async def open_stdio() -> tuple[asyncio.StreamReader, MessageWriter]:
    """Take over stdin and stdout; from now on `print` writes to stderr."""
    incoming, outgoing = os.dup(0), os.dup(1)
    sys.stdout.flush()
    os.dup2(2, 1)
    sys.stdout = sys.stderr
    return await _open_reader(incoming), await _open_writer(outgoing)


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
    pipe = os.fdopen(descriptor, "wb")
    if not _can_be_watched(descriptor):
        return StdoutWriter(pipe)
    loop = asyncio.get_running_loop()
    transport, protocol = await loop.connect_write_pipe(asyncio.streams.FlowControlMixin, pipe)
    return asyncio.StreamWriter(transport, protocol, None, loop)


def _can_be_watched(descriptor: int) -> bool:
    """Return whether the event loop can wait for it: pipes and sockets on POSIX."""
    mode = os.fstat(descriptor).st_mode
    return os.name == "posix" and (stat.S_ISFIFO(mode) or stat.S_ISSOCK(mode))


def _feed(descriptor: int, reader: asyncio.StreamReader, loop: asyncio.AbstractEventLoop) -> None:
    with contextlib.suppress(RuntimeError):  # the loop has ended
        while chunk := os.read(descriptor, _READ):
            loop.call_soon_threadsafe(reader.feed_data, chunk)
        loop.call_soon_threadsafe(reader.feed_eof)
