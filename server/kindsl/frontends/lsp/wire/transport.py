"""Bytes in and out: over stdio or a socket, in the running event loop.

Nothing here waits in a thread while messages flow: on POSIX both pipes belong to the event loop,
so a busy handler cannot starve the reader, and a client that does not read cannot block us.
"""

import asyncio
import contextlib
import itertools
import logging
import os
import re
import stat
import sys
import threading
from collections.abc import Callable

from pygls.io_ import StdoutWriter

_BUFFER = 1 << 24
_READ = 1 << 16
# The second one is for what the event loop cannot watch: a file, Windows.
MessageWriter = asyncio.StreamWriter | StdoutWriter
# After a body that is longer than its header said, the next header begins within a line.
_CONTENT_LENGTH = re.compile(
    rb"(?<![\w-])content-length[ \t]*:[ \t]*(\d{1,9})[ \t]*$", re.IGNORECASE
)
_TURN = 256

logger = logging.getLogger(__name__)


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


async def read_messages(reader: asyncio.StreamReader, receive: Callable[[bytes], bool]) -> None:
    """Hand the body of each message to `receive` until it says False or the input ends.

    Messages that have arrived are all handed on before what they started goes on, so that a
    cancellation overtakes the request it is about; a flood still leaves others their turn.
    """
    length: int | None = None
    with contextlib.suppress(asyncio.IncompleteReadError, ConnectionError):
        for count in itertools.count(1):
            if count % _TURN == 0:
                await asyncio.sleep(0)
            line = await _line(reader)
            if found := _CONTENT_LENGTH.search(line):
                length = int(found[1])
                if line[: found.start()].strip():
                    logger.error("%d bytes before a header were skipped", found.start())
            elif not line and length is not None:
                body, length = await reader.readexactly(length), None
                if not receive(body):
                    return


async def _line(reader: asyncio.StreamReader) -> bytes:
    """Return a line of a header without its end, or a part of one that is too long."""
    try:
        return (await reader.readuntil(b"\n")).rstrip()
    except asyncio.LimitOverrunError as error:
        return await reader.readexactly(error.consumed)
