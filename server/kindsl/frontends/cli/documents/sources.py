"""Reads a document's text, or gives the reason why it cannot be read."""

import os
import sys
from typing import NamedTuple

from kindsl.frontends.cli.outcome import Failure
from kindsl.language.text.encodings import decoded
from kindsl.language.text.lines import LineIndex
from kindsl.language.text.regular import NotRegularError, content_of

STDIN = "-"
UNNAMED = "<stdin>"

# Bytes that are no UTF-8, and NUL: a text in Latin-1 has some, noise consists of them.
_MOST_STRANGE = 0.1
_BYTE_ORDER_MARKS = (
    (b"\xff\xfe\x00\x00", "UTF-32"),
    (b"\x00\x00\xfe\xff", "UTF-32"),
    (b"\xff\xfe", "UTF-16"),
    (b"\xfe\xff", "UTF-16"),
)


class NotText(NamedTuple):
    """The content of a file that is not text in UTF-8.

    Attributes:
        message: Its nature, one sentence about the document without final period.
        text: The part of it that can be shown.
        offset: The place in that text at which its nature shows.
    """

    message: str
    text: str
    offset: int


def read_source(path: str, shown: str) -> str | Failure:
    """Return the text of a file, or the failure; see `read_text`."""
    text = read_text(path, shown)
    if not isinstance(text, NotText):
        return text
    return Failure(shown, text.message, *LineIndex(text.text).place(text.offset))


def read_text(path: str, shown: str) -> str | NotText | Failure:
    """Return the text of a file or stdin, undecodable bytes as surrogates, line ends untouched."""
    try:
        return _text_of(sys.stdin.buffer.read() if path == STDIN else content_of(path))
    except OSError as error:
        return Failure(shown, reason(path, error))


def reason(path: str, error: OSError) -> str:
    """Return the reason why a file could not be read."""
    if os.path.islink(path) and not os.path.exists(path):
        return f"broken symbolic link to '{os.readlink(path)}'"
    if isinstance(error, NotRegularError):
        return str(error.strerror)
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


def _text_of(content: bytes) -> str | NotText:
    may_declare = content.startswith((b"<?xml", b"\xff\xfe", b"\xfe\xff"))
    text = decoded(content) if may_declare else content.decode("utf-8", "surrogateescape")
    for mark, encoding in _BYTE_ORDER_MARKS:
        if content.startswith(mark) and not text.startswith("\ufeff"):
            return _encoded(content, encoding)
    if len(text) == len(content) and "\0" not in text and text.isascii():
        return text
    n_strange = len(text) - len(text.encode("utf-8", "ignore").decode()) + text.count("\0")
    return _strange(content, text) if n_strange > 1 + _MOST_STRANGE * len(text) else text


def _encoded(content: bytes, encoding: str) -> NotText:
    return NotText(f"is {encoding[:6]}, not UTF-8", content.decode(encoding, "replace"), 0)


def _strange(content: bytes, text: str) -> NotText:
    """Return a description of content that is not text: UTF-16 without a mark, or binary."""
    for parity, encoding in ((0, "UTF-16-BE"), (1, "UTF-16-LE")):
        high, low = content[parity:400:2], content[1 - parity : 400 : 2]
        if high.count(0) * 2 > len(high) and low.count(0) * 2 < len(low):
            return _encoded(content, encoding)
    offset = next(i for i, c in enumerate(text) if c == "\0" or "\udc80" <= c <= "\udcff")
    code = ord(text[offset]) & 0xFF
    return NotText(f"is not a text: byte 0x{code:02X}", text, offset)
