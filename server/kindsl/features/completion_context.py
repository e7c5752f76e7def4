"""What may stand where someone types: read from the text before the cursor alone.

The island's text up to the word being typed is parsed by itself; the parser's repairs carry the
automaton over earlier mistakes, and the state that it is in tells which tokens may come next.
"""

import re
from collections.abc import Sequence
from typing import NamedTuple

from kindsl.features.tree_path import path_to
from kindsl.features.value_place import ValuePlace, value_place
from kindsl.rules.analysis import Analysis
from kindsl.syntax.automaton import ROWS, Stack, initial, is_complete, step
from kindsl.syntax.document import PlacedIsland
from kindsl.syntax.parser import parse_island
from kindsl.syntax.tree import Island, Node, Token
from kindsl.syntax.words import BLOCK_STARTS
from kindsl.text.span import Span

_WORD_BEFORE = re.compile(r"\^?[^\W\d]\w*\Z")
_WORD_AFTER = re.compile(r"\w*")
_NUMBER_BEFORE = re.compile(r"[\d.]\w*\Z")
_LONGEST_WORD = 200
_LABELS = {
    "children": "children",
    "frames": "frame_group",
    "INERTIA": "inertia",
    "ref_frame": "joint_frame",
    "link": "link",
    "RobotBase": "base",
    "JOINT_KIND": "joint",
    "Robot": "document",
}


class CompletionContext(NamedTuple):
    """The surroundings of the word being typed.

    Attributes:
        start: Absolute start of the word; where it is empty, the cursor.
        end: Its absolute end.
        word: What of it stands before the cursor.
        expected: The kinds of tokens that the grammar allows instead of the word.
        block: The innermost open block: `document`, `base`, `link`, `joint`, `inertia`,
            `children`, `frame_group`, `frame` or `joint_frame`.
        previous: The token before the word, None at the start.
        value: The place of the value that is being typed, if one is.
        sections: What stands in the open block before the word.
        place: The island of the cursor.
        typed: The whole word, what stands behind the cursor included.
    """

    start: int
    end: int
    word: str
    expected: frozenset[str]
    block: str
    previous: Token | None
    value: ValuePlace | None
    sections: tuple[Node, ...]
    place: PlacedIsland
    typed: str


def completion_context(analysis: Analysis, offset: int) -> CompletionContext | None:
    """Return what may stand at an offset; None in a comment and behind a digit."""
    offset = min(max(offset, 0), analysis.syntax.length)
    place = analysis.syntax.island_at(offset)
    local = offset - place.start
    word = None if _is_in_comment(place.island, local) else _word_at(place.island.text, local)
    return None if word is None else _context(place, local, word)


def _context(place: PlacedIsland, local: int, word: Span) -> CompletionContext:
    """Return what the text of an island before a word allows."""
    text = place.island.text
    before = parse_island(text[: word.start])
    tokens = _without_supplied_end(before.tokens, before.skipped)
    last = tokens[-1] if tokens else None
    path = path_to(before, last) if last is not None else ()
    block = _open_block(tokens)
    return CompletionContext(
        place.start + word.start,
        place.start + word.end,
        text[word.start : local],
        _expected(tokens),
        block,
        last,
        value_place(path, last.end) if last is not None else None,
        _sections(path, block),
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
    word = _WORD_BEFORE.search(before)
    if _NUMBER_BEFORE.search(before[: word.start()] if word is not None else before):
        return None
    after = _WORD_AFTER.match(text, local)
    start = local if word is None else local - len(word[0])
    return Span(start, local if after is None else after.end())


def _without_supplied_end(tokens: tuple[Token, ...], skipped: tuple[Token, ...]) -> list[Token]:
    """Return the tokens that the automaton reads, up to the last that is written."""
    left_out = {id(token) for token in skipped}
    kept = [token for token in tokens if id(token) not in left_out]
    while kept and kept[-1].is_missing:
        kept.pop()
    return kept


def _expected(tokens: list[Token]) -> frozenset[str]:
    """Return the kinds that may follow; at the end of a block the words that begin one."""
    stack: Stack | None = None
    start = ""
    for token in tokens:
        stack = step(stack, token.kind) if stack is not None else None
        if stack is None:
            start = BLOCK_STARTS.get(token.kind, "")
            stack = step(initial(start), token.kind) if start else None
    if stack is None:
        return frozenset(BLOCK_STARTS)
    followers = {kind for kind in ROWS[stack.state] if kind != "$END" and step(stack, kind)}
    if start and is_complete(stack, start):
        followers |= BLOCK_STARTS.keys()
    return frozenset(followers)


def _open_block(tokens: list[Token]) -> str:
    """Return the label of the innermost block that no brace closes."""
    blocks: list[str] = []
    closed = ""
    for index, token in enumerate(tokens):
        if token.kind == "{":
            blocks.append(_label(tokens[max(index - 3, 0) : index], closed))
        elif token.kind == "}" and blocks:
            closed = blocks.pop()
    return blocks[-1] if blocks else "document"


def _label(before: list[Token], closed: str) -> str:
    """Return what block a brace opens, told by the three tokens before it."""
    kinds = [token.kind for token in before]
    if kinds and kinds[-1] == "FLOATING":
        kinds.pop()
    if kinds and kinds[-1] == "}":
        return closed
    label = _LABELS.get(kinds[-1]) if kinds else None
    if label is None and len(kinds) > 1:
        label = _LABELS.get(kinds[-2])
    return label or "frame"


def _sections(path: Sequence[Node], block: str) -> tuple[Node, ...]:
    """Return what is written in the innermost construct of a kind."""
    node = next((node for node in reversed(path) if node.kind == block), None)
    children = node.children if node is not None else ()
    return tuple(c for c in children if isinstance(c, Node) and c.start < c.end)
