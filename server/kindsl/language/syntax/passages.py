"""Passages of a text that are of another format: reports of mass properties, elements of URDF,
shapes.

They consist of whole lines. What they say is for others to read.
"""

import re
from collections.abc import Iterator
from enum import StrEnum
from typing import NamedTuple

from kindsl.language.syntax.vocabulary import BLOCKS, SECTIONS, words_of

_IN_BRACES = frozenset({"block", "list", "groups", "pose"})
_ASSIGNED, _WORDS = (
    "|".join(sorted(words_of(*(name for name, kind in SECTIONS.items() if is_wanted(kind)))))
    for is_wanted in (lambda kind: kind not in _IN_BRACES, _IN_BRACES.__contains__)
)
_HEADS = "|".join(sorted(words_of(*BLOCKS)))
_OURS = re.compile(
    rf"\s*(?:(?:(?:{_ASSIGNED})\s*=\s*(?:\([^()]*\)|[-+\w.<>/*\[\]^]++)\s*)+"
    rf"|(?:{_WORDS})\s*|(?:{_HEADS})\s+\^?\w+\s*(?:floating\s*)?"
    r"|(?:\w++\s+via\s+\w++\s*)+)(?://.*)?"
)
_COMMENT = re.compile(r"\s*(?://|/\*)")
_MATERIAL = re.compile(r"\s*(?:physical )?material\b", re.IGNORECASE)
_ENTRY = re.compile(r"\s*[LIJ][xyz]{2}\s*[=:]\s*\S+\s*")
_INERTIA = re.compile(r"inertia|mass moments|\b[LJ][xyz]{2}\s*[=:\t ]\s*[-+\d.]", re.IGNORECASE)
_CENTER = re.compile(
    r"cent(?:er|re) ?of ?(?:mass|gravity)|\bcentroid\b|\b(?:com|cog)\s*[:(\[\t]", re.IGNORECASE
)
_MASS = re.compile(
    r"^[^\w\r\n]*(?:total |body |part )?(?:mass|weight)\b(?!\s*(?:prop|mom|cent))"
    r"[^=:\d{}\n]*[=:\s]\s*[-+\d.]",
    re.IGNORECASE | re.MULTILINE,
)
_SKIPPED = re.compile(r"\s*+(?:<!--(?:[^-]|-(?!->))*+-->|<\?[^<>]*\?>)")
_ELEMENT = re.compile(r"\s*<(?P<name>[A-Za-z_][\w:.-]*)(?:\s[^<>]*?)?(?P<end>/?)>")
_FIRST = re.compile(r"^[ \t]*<(?:link|joint|inertial|robot|\?xml|!--)(?=[\s>/-])", re.MULTILINE)
_OF_URDF = re.compile(r"<(?:link|joint|inertial)\b")
SHAPES = ("box", "cylinder", "hollow_cylinder", "sphere", "capsule")
_NAMED = rf"(?:{'|'.join(SHAPES)})[ \t]*\([^(){{}}\r\n]*"
_SHAPE = re.compile(
    rf"^[ \t]*({_NAMED}\))[ \t]*\r?$|(?<=[\s{{}}])({_NAMED}\b(?:mass|density)\s*=[^(){{}}\r\n]*\))",
    re.MULTILINE,
)
URDF_ELEMENTS = "elements of URDF"


class Foreign(StrEnum):
    """The kind of a foreign passage."""

    REPORT = "report"
    URDF = "urdf"
    SHAPE = "shape"


class Passage(NamedTuple):
    """A passage of another format.

    Attributes:
        start: Where its first line has its first character, code points.
        end: Where its last line ends.
    """

    kind: Foreign
    start: int
    end: int


def foreign_passages(text: str) -> list[Passage]:
    """Return the passages of a text that are of another format, in their order."""
    found = list(_elements(text)) if "<" in text else []
    shapes = (match.span(match.lastindex or 0) for match in _SHAPE.finditer(text))
    found += (Passage(Foreign.SHAPE, *span) for span in shapes)
    found.sort(key=lambda passage: passage.start)
    if _INERTIA.search(text) and _CENTER.search(text):
        done = 0
        for passage in [*found, Passage(Foreign.URDF, len(text), len(text))]:
            found += _reports(text, done, passage.start)
            done = passage.end
    return sorted(found, key=lambda passage: passage.start)


def _elements(text: str) -> Iterator[Passage]:
    """Yield each row of XML elements that has a link, a joint or an inertia."""
    position, unclosed = 0, set[str]()
    text = text[: _unclosed_comment(text)]
    while first := _FIRST.search(text, position):
        start = first.start() + len(first[0]) - len(first[0].lstrip())
        end = _end_of_row(text, start, unclosed)
        if end > start and _OF_URDF.search(text, start, end):
            yield Passage(Foreign.URDF, start, end)
        position = max(end, first.end())


def _unclosed_comment(text: str) -> int:
    place = text.find("<!--", text.rfind("-->") + 1)
    return place if place >= 0 else len(text)


def _end_of_row(text: str, position: int, unclosed: set[str]) -> int:
    """Return where the last of some elements ends that follow each other."""
    while True:
        skipped, element = _SKIPPED.match(text, position), _ELEMENT.match(text, position)
        if skipped is not None:
            position = skipped.end()
        elif element is None or element["name"] in unclosed:
            return position
        elif element["end"]:
            position = element.end()
        else:
            closing = re.compile(rf"<(/?){re.escape(element['name'])}(?=[\s>/])[^<>]*?(/?)>")
            end = _closed(text, element.end(), closing)
            if end is None:
                unclosed.add(element["name"])
                return position
            position = end


def _closed(text: str, position: int, tag: re.Pattern[str]) -> int | None:
    depth = 1
    for match in tag.finditer(text, position):
        depth += 0 if match[2] else -1 if match[1] else 1
        if depth == 0:
            return match.end()
    return None


def _reports(text: str, begin: int, stop: int) -> Iterator[Passage]:
    """Yield the runs of lines without braces, none of them ours, that are reports."""
    start = end = position = begin
    is_after_entry = False
    for line in [*text[begin:stop].splitlines(keepends=True), "{"]:
        body = line.rstrip()
        if _is_foreign(body, is_after_entry):
            start = position if end <= start and body else start
            end = position + len(body) if body else end
        else:
            yield from _report(text, start, end)
            start = end = position + len(line)
        if body:
            is_entry = _ENTRY.fullmatch(body) is not None
            is_after_entry = is_entry and (is_after_entry or _OURS.fullmatch(body) is None)
        position += len(line)


def _is_foreign(line: str, is_after_entry: bool) -> bool:
    if _COMMENT.match(line):
        return False
    if ("{" in line or "}" in line) and not _MATERIAL.match(line):
        return False
    return _OURS.fullmatch(line) is None or (is_after_entry and _ENTRY.fullmatch(line) is not None)


def _report(text: str, start: int, end: int) -> Iterator[Passage]:
    passage = text[start:end]
    if all(pattern.search(passage) for pattern in (_MASS, _CENTER, _INERTIA)):
        first = start + len(passage) - len(passage.lstrip())
        yield Passage(Foreign.REPORT, first, end)
