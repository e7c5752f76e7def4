"""Addresses in comments that an editor can open."""

import re
from typing import NamedTuple

from kindsl.rules.analysis import Analysis

_ADDRESS = re.compile(r"https?://[^\s<>\"'`]+")
_TRAILING = ".,;:!?)*]}"


class DocumentLink(NamedTuple):
    """A stretch of a comment and the address it stands for."""

    start: int
    end: int
    target: str


def document_links(analysis: Analysis) -> tuple[DocumentLink, ...]:
    """Return the addresses in the comments, in the order of the text."""
    syntax = analysis.syntax
    found = []
    for island, origin in zip(syntax.islands, syntax.starts, strict=False):
        for start, end in island.comments:
            for match in _ADDRESS.finditer(island.text, start, end):
                target = match[0].rstrip(_TRAILING)
                begin = origin + match.start()
                found.append(DocumentLink(begin, begin + len(target), target))
    return tuple(found)


def links_in_text(text: str) -> tuple[DocumentLink, ...]:
    """Return the addresses in any text, such as a `kindsl.toml`."""
    found = []
    for match in _ADDRESS.finditer(text):
        target = match[0].rstrip(_TRAILING)
        found.append(DocumentLink(match.start(), match.start() + len(target), target))
    return tuple(found)
