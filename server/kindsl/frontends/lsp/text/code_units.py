"""Columns as clients count them: in UTF-8, UTF-16 or UTF-32 code units.

Everywhere else columns and offsets are code points.
"""

from lsprotocol import types

UTF8 = types.PositionEncodingKind.Utf8
UTF32 = types.PositionEncodingKind.Utf32


def width(text: str, encoding: str) -> int:
    """Return the number of code units of a text."""
    if encoding == UTF32 or text.isascii():
        return len(text)
    if encoding == UTF8:
        return len(text.encode("utf-8", "surrogatepass"))
    return len(text) + sum(character > "\uffff" for character in text)


def column(text: str, units: int, encoding: str) -> int:
    """Return how many characters lie before a number of code units, at most all.

    A number that points inside a character counts as its beginning.
    """
    if encoding == UTF32 or text.isascii():
        return min(units, len(text))
    for index, character in enumerate(text):
        units -= width(character, encoding)
        if units < 0:
            return index
    return len(text)
