"""Writes a text in place of another, wholly or not at all."""

import contextlib
import os
import stat
import tempfile

from kindsl.cli.documents.sources import reason
from kindsl.cli.outcome import Failure


def write_text(path: str, shown: str, old: str, new: str) -> Failure | None:
    """Replace a file's text, keeping its mode, and the link that leads to it.

    Args:
        path: The file.
        shown: What to call it.
        old: What it held when it was read; if it holds something else by now, it stays.
        new: What it shall hold; line ends are written as they are.

    Returns:
        None, or why it could not be written.
    """
    target = os.path.realpath(path)
    try:
        if not os.access(target, os.W_OK):
            return Failure(shown, "cannot be written: permission denied")
        with open(target, "rb") as file:
            if file.read() != old.encode("utf-8"):
                return Failure(shown, "has changed meanwhile, not written")
        _replace(target, new.encode("utf-8"))
    except OSError as error:
        return Failure(shown, reason(target, error).replace("read", "written"))
    return None


def _replace(target: str, content: bytes) -> None:
    """Write a neighbour of the target, then put it in the target's place."""
    status = os.stat(target)
    folder, name = os.path.split(target)
    descriptor, temporary = tempfile.mkstemp(prefix=f".{name}.", dir=folder)
    try:
        with open(descriptor, "wb") as file:
            file.write(content)
            file.flush()
            os.fsync(file.fileno())
        os.chmod(temporary, stat.S_IMODE(status.st_mode))
        with contextlib.suppress(OSError, AttributeError):
            os.chown(temporary, status.st_uid, status.st_gid)
        os.replace(temporary, target)
    except BaseException:
        with contextlib.suppress(OSError):
            os.unlink(temporary)
        raise
