"""The document as a value: islands in chunks, so that an edit costs what it touches.

An edit makes a new document that shares all untouched islands, and all chunks of islands but the
one or two it falls into, with the old one.
"""

import gc
import re
from bisect import bisect_right
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from functools import cached_property
from itertools import accumulate, chain, pairwise
from math import isqrt
from typing import TYPE_CHECKING

from kindsl.language.syntax.comment_problems import is_open
from kindsl.language.syntax.parser import parse_island
from kindsl.language.syntax.splitter import LOOKAHEAD, split
from kindsl.language.syntax.tables import ORDERS
from kindsl.language.syntax.tree import Island
from kindsl.language.syntax.vocabulary import LETTERS
from kindsl.language.text.edits import TextEdit, apply_edits
from kindsl.language.text.facts import Facts
from kindsl.language.text.groups import grouped

if TYPE_CHECKING:
    from kindsl.language.syntax.block_order import PlacedProblem

IN_ORDER = re.compile(
    "".join(LETTERS[p.rstrip("?+")] + p[len(p.rstrip("?+")) :] for p in ORDERS["document"])
)
_MANY_EDITS = 64


class PlacedIsland:
    """An island, its number in the document and its absolute offset."""

    __slots__ = ("index", "island", "start")

    def __init__(self, index: int, island: Island, start: int) -> None:
        self.index = index
        self.island = island
        self.start = start


class Chunk:
    """Some neighbouring islands; never changed once made."""

    __slots__ = ("_letters", "facts", "islands", "length", "offsets", "open_comments")

    def __init__(self, islands: tuple[Island, ...]) -> None:
        self.islands = islands
        self.facts = Facts()
        self.offsets = [0, *accumulate(len(island.text) for island in islands)]
        self.length = self.offsets.pop()
        self._letters: str | None = None
        self.open_comments = sum(has_open_comment(island) for island in islands)

    @property
    def letters(self) -> str:
        """A letter for each block."""
        if self._letters is None:
            nodes = [node for island in self.islands for node in island.nodes]
            self._letters = "".join([LETTERS[node.kind] for node in nodes])
        return self._letters


class SyntaxDocument:
    """A text and its islands; edits make new documents.

    All offsets are code points from the start of the text.

    Attributes:
        versions: Results about the version that was last looked at: shared by all that
            edits have made of each other.
        is_xml: Whether it is XML, of whatever format.
        angle_unit: That of joints.
    """

    is_xml, angle_unit = False, "rad"

    def __init__(self, chunks: tuple[Chunk, ...], versions: Facts | None = None) -> None:
        self.chunks = chunks
        self.versions = versions or Facts()
        self._chunk_starts = [0, *accumulate(chunk.length for chunk in chunks)]
        self._chunk_indices = [0, *accumulate(len(chunk.islands) for chunk in chunks)]

    def __len__(self) -> int:
        """Return the number of islands."""
        return self._chunk_indices[-1]

    @property
    def length(self) -> int:
        """Length of the text in code points."""
        return self._chunk_starts[-1]

    @cached_property
    def islands(self) -> tuple[Island, ...]:
        """All islands in order; their texts joined are the text."""
        return tuple(chain.from_iterable(chunk.islands for chunk in self.chunks))

    @cached_property
    def starts(self) -> list[int]:
        """The absolute offset of each island."""
        return [
            start + offset
            for start, chunk in zip(self._chunk_starts, self.chunks, strict=False)
            for offset in chunk.offsets
        ]

    @cached_property
    def text(self) -> str:
        """The whole text."""
        return "".join([island.text for island in self.islands])

    def island(self, index: int) -> PlacedIsland:
        """Return the island of a number, without making the list of all."""
        number = min(bisect_right(self._chunk_indices, index) - 1, len(self.chunks) - 1)
        local = index - self._chunk_indices[number]
        chunk = self.chunks[number]
        start = self._chunk_starts[number] + chunk.offsets[local]
        return PlacedIsland(index, chunk.islands[local], start)

    def island_at(self, offset: int) -> PlacedIsland:
        """Return the island that holds an offset, clamped to the text.

        An offset between two islands belongs to the second.
        """
        offset = min(max(offset, 0), self.length)
        number = min(bisect_right(self._chunk_starts, offset) - 1, len(self.chunks) - 1)
        chunk, start = self.chunks[number], self._chunk_starts[number]
        local = bisect_right(chunk.offsets, offset - start) - 1
        index = self._chunk_indices[number] + local
        return PlacedIsland(index, chunk.islands[local], start + chunk.offsets[local])

    @cached_property
    def problems(self) -> "tuple[PlacedProblem, ...]":
        """The problems of the row of blocks as a whole; each island has its own."""
        if IN_ORDER.fullmatch("".join([chunk.letters for chunk in self.chunks])):
            return ()
        from kindsl.language.syntax.block_order import order_problems

        return order_problems(self.islands, self.starts)

    def edited(self, edits: Sequence[TextEdit]) -> "SyntaxDocument":
        """Return the document after edits that are made at once.

        Raises:
            ValueError: Two edits overlap.
        """
        if len(edits) > _MANY_EDITS:
            return _reparsed(apply_edits(self.text, edits), self.islands, self.versions)
        document, done = self, self.length
        for edit in sorted(enumerate(edits), key=lambda e: (e[1].start, e[1].end, e[0]))[::-1]:
            if edit[1].end > done:
                raise ValueError(f"edits overlap at offset {edit[1].end}")
            done = edit[1].start
            document = _edited_once(document, *edit[1])
        return document


def parse(text: str) -> SyntaxDocument:
    """Return the document of a text; never raises, whatever the text."""
    return _reparsed(text, (), Facts())


def has_open_comment(island: Island) -> bool:
    """Return whether a comment in the island has no end."""
    return bool(island.comments) and is_open(island.text, *island.comments[-1])


@contextmanager
def paused_collector() -> Iterator[None]:
    """Pause the cyclic collector, which would walk the growing tree again and again."""
    was_enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if was_enabled:
            gc.enable()


def _reparsed(text: str, known: Iterable[Island], versions: Facts) -> SyntaxDocument:
    """Return a document, its islands taken from the known ones where the text is the same."""
    islands = _islands(text, split(text).starts, known)
    return SyntaxDocument(chunks_of(islands), versions)


def _islands(text: str, starts: list[int], known: Iterable[Island]) -> list[Island]:
    pool = grouped((island.text, island) for island in known)
    islands = []
    with paused_collector():
        for start, end in zip(starts, [*starts[1:], len(text)], strict=True):
            piece = text[start:end]
            same = pool.get(piece)
            islands.append(same.pop(0) if same else parse_island(piece))
    return islands


def chunks_of(islands: Sequence[Island]) -> tuple[Chunk, ...]:
    """Return islands in chunks, sized for the least steps an edit takes."""
    return _in_chunks(islands, _most_in_chunk(len(islands)))


def _most_in_chunk(n_islands: int) -> int:
    """Return how many islands a chunk holds: an edit walks all of one, and over all chunks.

    A step over a chunk takes as long as about four over islands.
    """
    return max(2 * isqrt(n_islands), 1)


def _in_chunks(islands: Sequence[Island], most: int) -> tuple[Chunk, ...]:
    """Return islands in as few chunks as hold them, all of about one size."""
    count = -(-len(islands) // most)
    ends = [len(islands) * number // count for number in range(count + 1)] if count else []
    return tuple(Chunk(tuple(islands[first:end])) for first, end in pairwise(ends))


def _edited_once(document: SyntaxDocument, start: int, end: int, new: str) -> SyntaxDocument:
    """Return the document after one edit: split anew around it, parse what is new."""
    first = _safe_start(document, document.island_at(start).index)
    touched = document.island_at(end).index
    origin = document.island(first).start
    reach = 1
    while True:
        stop = _safe_stop(document, touched + reach)
        region = [document.island(index).island for index in range(first, stop)]
        old = "".join([island.text for island in region])
        text = old[: start - origin] + new + old[end - origin :]
        found = split(text)
        if stop == len(document):
            kept, cut = stop, len(text)
            break
        is_closed = not (found.has_open_comment and _closes_later(document, stop))
        place = _first_kept(
            document, touched + 1, stop, len(text) - len(old) - origin, found.starts
        )
        if is_closed and place is not None:
            kept, cut = place
            break
        reach *= 2
    starts = [begin for begin in found.starts if begin < cut] or [0]
    # What is kept must not stand in what is new, too, be its text the same.
    gone = region[: kept - first]
    return _replaced(document, first, kept, _islands(text[:cut], starts, gone))


def _safe_start(document: SyntaxDocument, index: int) -> int:
    """Return an island before the edit whose beginning the edit cannot put in question.

    A comment without an end may get one by any edit behind it.
    """
    if any(chunk.open_comments for chunk in document.chunks):
        for number, island in enumerate(document.islands[:index]):
            if has_open_comment(island):
                index = number
                break
    index -= 1
    while index > 0 and len(document.island(index).island.tokens) < LOOKAHEAD:
        index -= 1
    return max(index, 0)


def _safe_stop(document: SyntaxDocument, index: int) -> int:
    """Return an end behind the island `index` that its keyword's look-ahead does not reach."""
    while index < len(document) and len(document.island(index).island.tokens) < LOOKAHEAD:
        index += 1
    return min(index + 1, len(document))


def _closes_later(document: SyntaxDocument, first: int) -> bool:
    return any("*/" in document.island(i).island.text for i in range(first, len(document)))


def _first_kept(
    document: SyntaxDocument, first: int, stop: int, shift: int, starts: list[int]
) -> tuple[int, int] | None:
    """Return the first old island whose beginning is found again behind the edit, and where."""
    found = set(starts)
    for index in range(first, stop):
        start = document.island(index).start + shift
        if start in found:
            return index, start
    return None


def _replaced(
    document: SyntaxDocument, first: int, stop: int, islands: list[Island]
) -> SyntaxDocument:
    indices = document._chunk_indices
    low = min(bisect_right(indices, first) - 1, len(document.chunks) - 1)
    high = max(bisect_right(indices, max(stop - 1, first)), low + 1)
    old = [island for chunk in document.chunks[low:high] for island in chunk.islands]
    base, most = indices[low], _most_in_chunk(len(document))
    old[first - base : stop - base] = islands
    return SyntaxDocument(
        (*document.chunks[:low], *_in_chunks(old, most), *document.chunks[high:]), document.versions
    )
