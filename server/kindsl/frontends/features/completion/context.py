"""The context of a completion, read from the text before the cursor alone.

The island's text up to the word being typed is parsed by itself, so that nothing behind the cursor
is taken for what goes on before it; the parser's repairs lead over earlier mistakes.
"""

import re
from collections.abc import Sequence
from typing import NamedTuple

from kindsl.frontends.features.tree_path import path_to
from kindsl.frontends.features.value_place import ValuePlace, value_place
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.syntax.document import PlacedIsland
from kindsl.language.syntax.expected import expected_at
from kindsl.language.syntax.parser import parse_island
from kindsl.language.syntax.sections import ORDER
from kindsl.language.syntax.tree import Island, Node, Token
from kindsl.language.syntax.vocabulary import of_kind, token_kinds
from kindsl.language.text.span import Span

_WORD_BEFORE = re.compile(r"[\^.]?\w*\Z")
_NUMBER = re.compile(r"[\d.]")
_BEHIND_WORD = re.compile(r"\W")
_LONGEST_WORD = 200
_BEFORE_LISTS = token_kinds(("link", "joint")) | {"via", "=", "(", ",", "<"}
_BLOCKS = of_kind("block", "pose", "list", "group")


class CompletionContext(NamedTuple):
    """The surroundings of the word being typed.

    Attributes:
        start: Absolute start of the word; where it is empty, the cursor.
        end: Its absolute end.
        word: The part of it before the cursor.
        expected: The kinds of tokens that the grammar allows instead of the word.
        block: The innermost open block: `document`, `base`, `link`, `joint`, `inertia`,
            `children`, `frame_group`, `frame` or `joint_frame`.
        previous: The token before the word; at the start one without a kind.
        value: The place of the value that is being typed, if one is.
        sections: Sections of the open block before the word.
        place: The island of the cursor.
        typed: The whole word, what stands behind the cursor included.
    """

    start: int
    end: int
    word: str
    expected: frozenset[str]
    block: str
    previous: Token
    value: ValuePlace | None
    sections: tuple[Node, ...]
    place: PlacedIsland
    typed: str

    @property
    def line_start(self) -> int:
        """Start of the line if only blanks stand before the word, else of the word."""
        before = self.place.island.text[: self.start - self.place.start]
        blanks = len(before) - len(before.rstrip(" \t"))
        return (
            self.start - blanks
            if before[: len(before) - blanks].endswith(("\n", "\r"))
            else self.start
        )

    @property
    def is_after_blank(self) -> bool:
        """True if something must follow a blank or bracket just typed on this line."""
        text = self.place.island.text[self.previous.end : self.start - self.place.start]
        goes_on = self.previous.kind in _BEFORE_LISTS or "via" in self.expected
        return goes_on and not text.strip(" \t") and (bool(text) or self.previous.kind in "(<")


def completion_context(analysis: Analysis, offset: int) -> CompletionContext | None:
    """Return the context of a completion at an offset; None in a comment and after a digit."""
    offset = min(max(offset, 0), analysis.syntax.length)
    place = analysis.syntax.island_at(offset)
    local = offset - place.start
    word = None if _is_in_comment(place.island, local) else _word_at(place.island.text, local)
    return None if word is None else _context(place, local, word)


def _context(place: PlacedIsland, local: int, word: Span) -> CompletionContext:
    text = place.island.text
    before = parse_island(text[: word.start])
    expected = expected_at(before, word.start)
    block = next((c for c in reversed(expected.constructs) if c in _BLOCKS), "document")
    nothing = Token("", "", word.start, word.start, word.start)
    last = next((t for t in reversed(before.tokens) if not t.is_missing), nothing)
    path = path_to(before, last)
    return CompletionContext(
        place.start + word.start,
        place.start + word.end,
        text[word.start : local],
        expected.kinds,
        block,
        last,
        value_place(path, last.end),
        sections_of(path, block),
        place,
        text[word.start : word.end],
    )


def _is_in_comment(island: Island, local: int) -> bool:
    for start, end in island.comments:
        is_ended = island.text[start : start + 2] == "/*" and island.text.endswith("*/", start, end)
        if start < local and (local < end or (local == end and not is_ended)):
            return True
    return False


def _word_at(text: str, local: int) -> Span | None:
    """Return the word around an offset, empty where none is, None where a number is."""
    before = text[max(local - _LONGEST_WORD, 0) : local]
    word: str = _WORD_BEFORE.findall(before)[0]
    if _NUMBER.match(word):
        return None
    rest = _BEHIND_WORD.split(text[local : local + _LONGEST_WORD])[0]
    return Span(local - len(word), local + len(rest))


def sections_of(path: Sequence[Node], block: str) -> tuple[Node, ...]:
    """Return the sections of the innermost block of a kind."""
    node = next((node for node in reversed(path) if node.kind == block), None)
    if node is None:
        return ()
    return tuple(section for kind in ORDER.get(block, ()) for section in node.nodes(kind))
