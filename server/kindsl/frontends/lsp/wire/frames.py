"""Messages in a stream of bytes: a header with the length of a body, a blank line, the body.

Whatever comes, the next header in order is found again: bytes that belong to none are skipped.
"""

import asyncio
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
    frames = _Frames(reader)
    for count in itertools.count(1):
        if count % _TURN == 0:
            await asyncio.sleep(0)
        try:
            body = await frames.body()
        except (asyncio.IncompleteReadError, ConnectionError):
            return
        if not receive(body):
            return


class _Frames:
    """Finds messages; what is wrong with them is logged, bare line feeds but once."""

    __slots__ = ("_has_told_of_line_ends", "_reader")

    def __init__(self, reader: asyncio.StreamReader) -> None:
        self._reader = reader
        self._has_told_of_line_ends = False

    async def body(self) -> bytes:
        """Return the body of the next message.

        Raises:
            IncompleteReadError: The input has ended.
        """
        length, has_begun = None, False
        while True:
            line = await self._line()
            if line.strip():
                has_begun = True
                told = _length(line)
                length = length if told is None else told
            elif length is not None:
                return await self._reader.readexactly(length)
            elif has_begun:
                logger.error("a header without a valid Content-Length was skipped")
                has_begun = False

    async def _line(self) -> bytes:
        """Return a line of a header without its end, or a part of one that is too long."""
        try:
            line = await self._reader.readuntil(b"\n")
        except asyncio.LimitOverrunError as error:
            return await self._reader.readexactly(error.consumed)
        if not line.endswith(b"\r\n") and not self._has_told_of_line_ends:
            self._has_told_of_line_ends = True
            logger.warning("a header's lines end with LF instead of CR LF")
        return line.rstrip(b"\r\n")


def _length(line: bytes) -> int | None:
    """Return the length in a line of a header, None if there is none."""
    found = _CONTENT_LENGTH.search(line)
    if found is None:
        return None
    if line[: found.start()].strip():
        logger.error("%d bytes before a header were skipped", found.start())
    return int(found[1])
