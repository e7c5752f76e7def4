"""The place where robcogen2 stops reading a document; each island is read once in its life."""

import re
from collections.abc import Sequence
from typing import NamedTuple

from kindsl.language.syntax.document import IN_ORDER, Chunk, SyntaxDocument
from kindsl.language.syntax.portability import ROBCOGEN2, portability
from kindsl.language.syntax.strict_robcogen2 import StrictReading, strict_reading
from kindsl.language.syntax.tree import Island
from kindsl.language.syntax.vocabulary import LETTERS
from kindsl.language.text.facts import kept

_UNDECODED = re.compile("[\ud800-\udfff]")
# Text in which robcogen2 sees the tokens that the grammar's tables have.
_PLAIN = re.compile(r"[\w\s{}()=,.+*/-]*", re.ASCII)
_REMARK = re.compile(r"//[^\r\n]*")
_SPECIAL = re.compile(r"(?<!\w)(?:[\d.]+[A-Za-z_]|[pP][iI](?:\w|(?<!PI)))|/\*", re.ASCII)


class Stop(NamedTuple):
    """The place where robcogen2 stops: code points from the island's start."""

    island: Island
    offset: int


def stop_of_robcogen2(document: SyntaxDocument) -> Stop | None:
    """Return where robcogen2 stops reading a document, None where it reads all of it."""
    readings = list(map(_reading_of_chunk, document.chunks))
    islands = document.islands
    if any(reading.failure is not None for reading in readings):
        return _stop_in(islands)
    is_whole = IN_ORDER.fullmatch("".join([reading.blocks for reading in readings]))
    return None if is_whole else Stop(islands[-1], len(islands[-1].text))


@kept
def _reading_of_chunk(chunk: Chunk) -> StrictReading:
    """Return the blocks that robcogen2 reads in a chunk, island by island, and any failure."""
    readings = list(map(_kept_reading, chunk.islands))
    failure = next((each.failure for each in readings if each.failure is not None), None)
    return StrictReading("".join([each.blocks for each in readings]), (), failure)


def _stop_in(islands: Sequence[Island]) -> Stop | None:
    """Return where robcogen2 stops in islands, one of which it cannot read alone.

    That may be cut from the next where robcogen2 cuts nothing; then they are read as one.
    """
    for island in islands:
        undecoded = _undecoded(island.text)
        if undecoded is not None:
            return Stop(island, undecoded)
    first, blocks = 0, ""
    while (reading := _kept_reading(islands[first])).failure is None:
        first, blocks = first + 1, blocks + reading.blocks
    # No token goes on in another line.
    if "\n" in islands[first].text[reading.failure :]:
        return Stop(islands[first], reading.failure)
    rest = strict_reading("".join(island.text for island in islands[first:]))
    if rest.failure is None:
        return None if IN_ORDER.fullmatch(blocks + rest.blocks) else Stop(islands[0], 0)
    offset = rest.failure
    for island in islands[first:-1]:
        if offset < len(island.text):
            return Stop(island, offset)
        offset -= len(island.text)
    return Stop(islands[-1], offset)


@kept
def _kept_reading(island: Island) -> StrictReading:
    blocks = _plain_blocks(island)
    if blocks is not None:
        return StrictReading(blocks, (), None)
    reading, undecoded = strict_reading(island.text), _undecoded(island.text)
    return StrictReading(reading.blocks, (), reading.failure if undecoded is None else undecoded)


def _plain_blocks(island: Island) -> str | None:
    """Return the blocks of an island that robcogen2 surely reads as we do, else None."""
    text = _REMARK.sub("", island.text)
    if island.problems or not _PLAIN.fullmatch(text) or _SPECIAL.search(text):
        return None
    notes = portability(island)
    if any(note.target == ROBCOGEN2 or note.kind == "keyword-as-name" for note in notes):
        return None
    return "".join(LETTERS[node.kind] for node in island.nodes)


def _undecoded(text: str) -> int | None:
    found = None if text.isascii() else _UNDECODED.search(text)
    return None if found is None else found.start()
