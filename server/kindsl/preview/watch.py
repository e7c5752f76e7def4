"""Notices when files are saved."""

import asyncio
import os
from collections.abc import AsyncIterator, Sequence

INTERVAL = 0.1  # seconds

Fingerprint = tuple[tuple[int, int, int] | None, ...]


async def saves(
    paths: Sequence[str], known: Fingerprint, interval: float = INTERVAL
) -> AsyncIterator[None]:
    """Yield each time that a file has changed, been replaced or appeared.

    Args:
        paths: The files; the first is the one that has to be there.
        known: Their fingerprint when they were last read.
        interval: Seconds between two looks.
    """
    while True:
        await asyncio.sleep(interval)
        present = fingerprint(paths)
        # A file that is away is being replaced; wait for the new one.
        if present != known and present[0] is not None:
            known = present
            yield


def fingerprint(paths: Sequence[str]) -> Fingerprint:
    """Return what changes with each save; None for a file that is not there."""
    return tuple(map(_stamp, paths))


def _stamp(path: str) -> tuple[int, int, int] | None:
    try:
        status = os.stat(path)  # noqa: PTH116 (a path may hold any bytes)
    except OSError:
        return None
    return status.st_mtime_ns, status.st_size, status.st_ino
