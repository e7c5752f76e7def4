"""Saves of a text in a file."""

import os

Stamp = tuple[int, int, int]


def stamp(path: str) -> Stamp | None:
    """Return what changes with each save of a file; None if none can be there."""
    try:
        status = os.stat(path)  # noqa: PTH116 (a path may hold any bytes)
    except (OSError, ValueError):
        return None
    return status.st_mtime_ns, status.st_size, status.st_ino
