"""Where the elements of an expanded xacro file come from: the number, else the tag, in its file.

Each element of a file that is read is given an attribute with the file and its offset there, which
macros copy with the element.
"""

import re
from collections.abc import Callable
from typing import Any, NamedTuple
from xml.sax.saxutils import quoteattr, unescape

from kindsl.robots.interchange.xml_reading import TAG, XmlError, parsed_xml

_MARK = "kindsl-origin"
_MARKED = re.compile(rf'\s{_MARK}="(\d+):([^"]*)"')
_ATTRIBUTE = re.compile(r"""([\w:.-]+)\s*=\s*(["'])(.*?)\2""", re.DOTALL)


class Origin(NamedTuple):
    """A place in a file that a xacro file is made of.

    Attributes:
        file: Its path.
        start: Where it begins, in code points.
        end: Where it ends.
    """

    file: str
    start: int
    end: int


def with_origins(text: str, file: str) -> str:
    """Return the text of a file whose elements say where they are, but for those of xacro."""
    try:
        root: Any = parsed_xml(text)
    except XmlError:
        return text  # xacro says what is wrong with it.
    pieces, done = [], 0
    for element in (each for each in root.iter() if ":" not in each.tag):
        behind = element.offset + 1 + len(element.tag)
        pieces.append(f"{text[done:behind]} {_MARK}={quoteattr(f'{element.offset}:{file}')}")
        done = behind
    return "".join((*pieces, text[done:]))


def origin(expansion: str, start: int, end: int, read: Callable[[str], str]) -> Origin | None:
    """Return where something in an expansion comes from, None if nothing says so.

    Args:
        expansion: The text.
        start: Where it begins.
        end: Where it ends.
        read: Returns the text of a file.
    """
    first = expansion.rfind("<", 0, start + 1)
    tag = TAG.match(expansion, max(first, 0))
    mark = _MARKED.search(tag[0]) if tag is not None else None
    if tag is None or mark is None:
        return None
    at, file = int(mark[1]), unescape(mark[2], {"&quot;": '"'})
    text = read(file)
    there = TAG.match(text, at)
    if there is None:
        return None
    for found in _ATTRIBUTE.finditer(tag[0]):
        first, last = (tag.start() + each for each in found.span(3))
        if first <= start <= last:
            return _value(there, found[1], found[3], (start - first, end - first), file)
    return Origin(file, *there.span())


def _value(there: re.Match[str], name: str, value: str, at: tuple[int, int], file: str) -> Origin:
    """Return the place in an attribute that is the same there, else the attribute, or the tag."""
    for found in _ATTRIBUTE.finditer(there[0]):
        if found[1] == name:
            first, last = (there.start() + each for each in found.span(3))
            if found[3] == value and at[1] <= len(value):
                first, last = first + at[0], first + at[1]
            return Origin(file, first, last)
    return Origin(file, *there.span())
