"""Addresses in comments that an editor can open."""

import re
from collections.abc import Iterator
from typing import NamedTuple

from kindsl.judgement.analysis.analysis import Analysis

_ADDRESS = re.compile(r"https?://[^\s<>\"'`]+")
_TRAILING = ".,;:!?)*]}"


class DocumentLink(NamedTuple):
    """A link in a comment and its address."""

    start: int
    end: int
    target: str


def document_links(analysis: Analysis) -> tuple[DocumentLink, ...]:
    """Return the addresses in the comments, in the order of the text."""
    syntax = analysis.syntax
    return tuple(
        DocumentLink(origin + link.start, origin + link.end, link.target)
        for island, origin in zip(syntax.islands, syntax.starts, strict=True)
        for start, end in island.comments
        for link in _addresses(island.text, start, end)
    )


def links_in_text(text: str) -> tuple[DocumentLink, ...]:
    """Return the addresses in any text, such as a `kindsl.toml`."""
    return tuple(_addresses(text, 0, len(text)))


def _addresses(text: str, start: int, end: int) -> Iterator[DocumentLink]:
    for match in _ADDRESS.finditer(text, start, end):
        target = match[0].rstrip(_TRAILING)
        yield DocumentLink(match.start(), match.start() + len(target), target)
