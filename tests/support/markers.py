"""Documents with marks in comments that tell what is expected where.

- `// ^^^ KD101 text` points at the columns above the carets in the nearest line that is no mark.
- `// <- KD101 text` at the end of a line points at that line's first word.
- `$0` is the cursor; it is taken out of the text.
- `//- name.kindsl` begins another file.

The text behind a code is part of the message.
"""

import re
from typing import NamedTuple

_FILE = re.compile(r"^//- (\S+)[ \t]*\n", re.MULTILINE)
_CARETS = re.compile(
    r"^[ \t]*//(?P<lead>[ \t]*)(?P<carets>\^+)[ \t]+(?P<code>KD\d{3})(?P<text>.*)$"
)
_ARROW = re.compile(r"[ \t]*// <-[ \t]+(?P<code>KD\d{3})(?P<text>.*)$")
_WORD = re.compile(r"[^\s{}()=,]+")
_CURSOR = "$0"


class Expectation(NamedTuple):
    """A finding that must be there.

    Attributes:
        code: The rule's code.
        start: First code point of the marked place.
        end: One past its last code point.
        text: Part of the message, perhaps empty.
    """

    code: str
    start: int
    end: int
    text: str


class MarkedText(NamedTuple):
    """A document without its cursor, and what its marks say.

    Attributes:
        name: The file's name, empty for the text before the first `//-`.
        text: The document; marks are comments and stay in it.
        expected: The expectations, in the order of the text.
        cursor: Where the cursor was, if there was one.
    """

    name: str
    text: str
    expected: tuple[Expectation, ...]
    cursor: int | None


def marked_files(source: str) -> list[MarkedText]:
    """Return the documents in a text with marks."""
    pieces = _FILE.split(source)
    named = [("", pieces[0]), *zip(pieces[1::2], pieces[2::2], strict=True)]
    return [_marked(name, text) for name, text in named if text.strip()]


def marked(source: str) -> MarkedText:
    """Return the only document in a text with marks."""
    (document,) = marked_files(source)
    return document


def _marked(name: str, source: str) -> MarkedText:
    cursor = source.find(_CURSOR)
    source = source.replace(_CURSOR, "", 1)
    expected: list[Expectation] = []
    lines: list[str] = []
    offset = target = 0
    for line in source.splitlines(keepends=True):
        carets = _CARETS.match(line.rstrip("\r\n"))
        if carets:
            start = target + carets.start("carets")
            end = target + carets.end("carets")
            expected.append(Expectation(carets["code"], start, end, carets["text"].strip()))
        else:
            target = offset
            arrow = _ARROW.search(line.rstrip("\r\n"))
            if arrow:
                word = _WORD.search(line)
                assert word is not None
                place = offset + word.start(), offset + word.end()
                expected.append(Expectation(arrow["code"], *place, arrow["text"].strip()))
        lines.append(line)
        offset += len(line)
    return MarkedText(name, "".join(lines), tuple(expected), cursor if cursor >= 0 else None)
