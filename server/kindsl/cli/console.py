"""What a terminal can show."""

import os
from io import TextIOWrapper
from typing import TextIO

_COLOURS = {
    "error": "1;31", "warning": "1;33", "info": "1;34", "hint": "1;36", "note": "1;36",
    "path": "1", "frame": "34", "fix": "32",
}  # fmt: skip


def wants_colour(stream: TextIO) -> bool:
    """Return whether to colour what goes to a stream: NO_COLOR, FORCE_COLOR, else a terminal."""
    if os.environ.get("NO_COLOR"):
        return False
    if os.environ.get("FORCE_COLOR", "0") != "0":
        return True
    return stream.isatty() and os.environ.get("TERM") != "dumb"


def coloured(text: str, kind: str) -> str:
    """Return a text with the escape sequences of a colour around it."""
    return f"\x1b[{_COLOURS[kind]}m{text}\x1b[0m"


def plain(text: str, _kind: str) -> str:
    """Return a text as it is."""
    return text


def write(stream: TextIO, text: str) -> None:
    """Write a text, come what may: signs that the stream cannot encode, a reader that has gone."""
    try:
        if isinstance(stream, TextIOWrapper):
            stream.reconfigure(errors="backslashreplace")
        stream.write(text)
        stream.flush()
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())
