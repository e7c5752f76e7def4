"""Regular files: no pipes, no devices, whose reading might never end."""

import os
import stat

# What the process has been given open, as a shell's `<(command)` is.
_GIVEN = ("/dev/stdin", "/dev/fd/", "/proc/self/fd/")


class NotRegularError(OSError):
    """A path leads to a pipe, a socket or a device, which might keep its reader waiting."""


def require_regular(path: str) -> None:
    """Raise NotRegularError if opening or reading a path might never end.

    Raises:
        OSError: There is nothing at the path, or it is not regular.
    """
    mode = os.stat(path).st_mode
    if stat.S_ISREG(mode) or stat.S_ISDIR(mode) or os.path.abspath(path).startswith(_GIVEN):
        return
    raise NotRegularError(None, "is not a regular file")


def content_of(path: str) -> bytes:
    """Return what a regular file holds.

    Raises:
        OSError: It cannot be read, or is not regular.
    """
    require_regular(path)
    with open(path, "rb") as file:
        return file.read()
