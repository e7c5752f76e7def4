"""Capabilities of a terminal: colours, encodings, closed streams."""

import errno
import os
import sys
from io import TextIOWrapper
from typing import TextIO

UNWRITABLE = 2
_COLOURS = {
    "error": "1;31", "warning": "1;33", "info": "1;34", "hint": "1;36", "note": "1;36",
    "path": "1", "frame": "34", "fix": "32",
}  # fmt: skip


def wants_colour(stream: TextIO | None) -> bool:
    """Return whether to colour the output to a stream: NO_COLOR, FORCE_COLOR, else a terminal."""
    if os.environ.get("NO_COLOR"):
        return False
    if os.environ.get("FORCE_COLOR", "0") != "0":
        return True
    return is_terminal(stream) and os.environ.get("TERM") != "dumb"


def is_terminal(stream: TextIO | None) -> bool:
    """Return whether a stream is a terminal; Python has None for a closed one."""
    return stream is not None and stream.isatty()


def coloured(text: str, kind: str) -> str:
    """Return a text with the escape sequences of a colour around it."""
    return f"\x1b[{_COLOURS[kind]}m{text}\x1b[0m"


def uncoloured(text: str, _kind: str) -> str:
    """Return a text as it is."""
    return text


def write(stream: TextIO | None, content: str | bytes) -> None:
    """Write to stdout or stderr, escaping unencodable characters; nothing if the reader has gone.

    Raises:
        SystemExit: What is asked for cannot be written to stdout.
    """
    try:
        if isinstance(content, bytes):
            _open(stream).buffer.write(content)
        else:
            if isinstance(stream, TextIOWrapper):
                stream.reconfigure(errors="backslashreplace")
            _open(stream).write(content)
        _open(stream).flush()
    except BrokenPipeError:
        _send_nowhere(stream)
    except OSError as error:
        if stream is sys.stderr:
            return
        _send_nowhere(stream)
        write(sys.stderr, f"stdout: error: cannot be written: {error.strerror or error}\n")
        raise SystemExit(UNWRITABLE) from None


def _open(stream: TextIO | None) -> TextIO:
    """Return a stream that is not closed."""
    if stream is None:
        raise OSError(errno.EBADF, os.strerror(errno.EBADF))
    return stream


def _send_nowhere(stream: TextIO | None) -> None:
    if stream is not None:
        os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())
