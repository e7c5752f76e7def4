"""Notices when files are saved."""

import asyncio
from collections.abc import AsyncIterator, Sequence

from kindsl.language.text.saves import Stamp, stamp

INTERVAL = 0.1  # seconds
LOOKS_UNTIL_LOST = 10

Fingerprint = tuple[Stamp | None, ...]


async def saves(paths: Sequence[str], known: Fingerprint) -> AsyncIterator[bool]:
    """Yield True each time that a file has changed, been replaced or appeared.

    Yields False once when the first file has been away for so long that nobody is replacing it.

    Args:
        paths: The files; the first is the one that has to be there.
        known: Their fingerprint when they were last read.
    """
    away = 0
    while True:
        await asyncio.sleep(INTERVAL)
        present = fingerprint(paths)
        away = away + 1 if present[0] is None else 0
        if away == LOOKS_UNTIL_LOST:
            known = ()
            yield False
        elif present != known and not away:
            known = present
            yield True


def fingerprint(paths: Sequence[str]) -> Fingerprint:
    """Return what changes with each save; None for a file that is not there."""
    return tuple(map(stamp, paths))
