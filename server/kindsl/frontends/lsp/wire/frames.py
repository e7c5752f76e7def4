"""Messages in a stream of bytes: a header with the length of a body, a blank line, the body.

Whatever comes, the next header in order is found again: bytes that belong to none are skipped.
"""

import asyncio
import contextlib
import itertools
import logging
import re
from collections.abc import Callable

# After a body that is longer than its header said, the next header begins within a line.
_CONTENT_LENGTH = re.compile(
    rb"(?<![\w-])content-length[ \t]*:[ \t]*(\d{1,9})[ \t]*$", re.IGNORECASE
)
_TURN = 256

logger = logging.getLogger(__name__)


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
