"""The names in the text of a file that is not open: a search needs no analysis of thousands."""

import re
from bisect import bisect_right
from collections.abc import Iterator

from kindsl.frontends.features.outline import WorkspaceSymbol
from kindsl.language.syntax.tables import HOLDS, PATTERNS, WORDS
from kindsl.language.syntax.vocabulary import BLOCKS, of_kind, words_of

# What begins a block, by its kind; the head names the robot.
_KINDS = {
    word: name if name in BLOCKS else "robot"
    for name in HOLDS["document"]
    for word in WORDS[name]
    if word.isidentifier()
}
_GROUPS = words_of(*of_kind("groups"))
_COMMENT = f"{PATTERNS['LINE_COMMENT']}|{PATTERNS['BLOCK_COMMENT']}"
_BLANK = rf"(?:\s|{_COMMENT})*+"
_NAME = rf"(\^?[^\W\d]\w*){_BLANK}"
_COMMENTS = re.compile(_COMMENT)
# One search a word is quicker than one for all: each knows how it begins.
_WORDS = tuple(re.compile(rf"{word}\b") for word in (*_KINDS, *_GROUPS))
_BLOCK = re.compile(rf"({'|'.join(_KINDS)})\b{_BLANK}{_NAME}(?:\w+{_BLANK})?\{{")
_OPENED = re.compile(rf"(?:{'|'.join(_GROUPS)}){_BLANK}\{{")
_GROUP = re.compile(rf"{_BLANK}{_NAME}\{{(?:{_COMMENT}|[^{{}}])*+\}}")


def symbols_in_text(text: str) -> Iterator[WorkspaceSymbol]:
    """Yield what a text without mistakes names, in its order, without an analysis."""
    robot = ""
    for start in _marks(text):
        if (block := _BLOCK.match(text, start)) is not None:
            kind, name = _KINDS[block[1]], block[2].removeprefix("^")
            yield WorkspaceSymbol(name, kind, robot, *block.span(2))
            robot = robot or (name if kind == "robot" else "")
        elif (opened := _OPENED.match(text, start)) is not None:
            position = opened.end()
            while (group := _GROUP.match(text, position)) is not None:
                yield WorkspaceSymbol(group[1].removeprefix("^"), "frame", robot, *group.span(1))
                position = group.end()


def _marks(text: str) -> Iterator[int]:
    """Yield where a block or a list of groups may begin."""
    comments = [span for found in _COMMENTS.finditer(text) for span in found.span()]
    for start in sorted(found.start() for word in _WORDS for found in word.finditer(text)):
        before = text[start - 1] if start else " "
        is_commented = bisect_right(comments, start) % 2
        if not (is_commented or before == "^" or before == "_" or before.isalnum()):
            yield start
