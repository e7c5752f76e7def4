"""Reads a document's text, or tells why it cannot be read."""

import os
import stat
import sys

from kindsl.cli.outcome import Failure

STDIN = "-"
BOM = "\ufeff"

# Bytes that are no UTF-8, and NUL: a text in Latin-1 has some, noise consists of them.
_MOST_STRANGE = 0.1
_BYTE_ORDER_MARKS = (
    (b"\xff\xfe\x00\x00", "UTF-32"),
    (b"\x00\x00\xfe\xff", "UTF-32"),
    (b"\xff\xfe", "UTF-16"),
    (b"\xfe\xff", "UTF-16"),
)


def read_source(path: str, shown: str) -> str | Failure:
    """Return the text of a file, undecodable bytes as surrogates, line ends untouched.

    Args:
        path: The file, or `-` for stdin.
        shown: What to call it.
    """
    try:
        return _text_of(_content_of(path), shown)
    except OSError as error:
        return Failure(shown, reason(path, error))


def reason(path: str, error: OSError) -> str:
    """Return in words why a file could not be read."""
    if os.path.islink(path) and not os.path.exists(path):
        return f"broken symbolic link to '{os.readlink(path)}'"
    if isinstance(error, FileNotFoundError):
        return "no such file or folder"
    if isinstance(error, IsADirectoryError):
        return "is a folder, not a file"
    if isinstance(error, PermissionError):
        return "cannot be read: permission denied"
    return f"cannot be read: {error.strerror or error}"


def is_decodable(text: str) -> bool:
    """Return whether a text was wholly UTF-8 when it was read."""
    try:
        text.encode("utf-8")
    except UnicodeEncodeError:
        return False
    return True


def _content_of(path: str) -> bytes:
    if path == STDIN:
        return sys.stdin.buffer.read()
    with open(path, "rb") as file:
        if stat.S_ISCHR(os.fstat(file.fileno()).st_mode) and not file.isatty():
            raise OSError(0, "is a device")
        return file.read()


def _text_of(content: bytes, shown: str) -> str | Failure:
    for mark, encoding in _BYTE_ORDER_MARKS:
        if content.startswith(mark):
            return Failure(shown, f"is {encoding}, not UTF-8", 1, 1)
    text = content.decode("utf-8", "surrogateescape")
    if len(text) == len(content) and "\0" not in text and text.isascii():
        return text
    n_strange = len(text) - len(content.decode("utf-8", "ignore")) + text.count("\0")
    return _no_text(content, shown) if n_strange > 1 + _MOST_STRANGE * len(text) else text


def _no_text(content: bytes, shown: str) -> Failure:
    """Return the failure for content that is no text, at its first strange byte."""
    for parity in (0, 1):
        sample = content[parity:400:2]
        if sample.count(0) * 2 > len(sample):
            return Failure(shown, "is UTF-16, not UTF-8", 1, 1)
    try:
        content.decode("utf-8")
        place = content.index(0)
    except UnicodeDecodeError as error:
        place = error.start
    before = content[:place].decode("utf-8", "surrogateescape")
    line = before.count("\n") + 1
    column = len(before) - before.rfind("\n")
    return Failure(shown, f"is not a text: byte 0x{content[place]:02X}", line, column)
