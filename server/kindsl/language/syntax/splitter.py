"""The starts of the islands of a text.

A block keyword begins an island when it stands first on its line or behind a brace, or is followed
by a name and `{`, unless what follows shows that it is a name itself (`link via j1`). Braces are
not counted: a lost one would move every island behind it.
"""

import re
from typing import NamedTuple

from kindsl.language.syntax.tables import HOLDS, KEYWORDS
from kindsl.language.syntax.vocabulary import BLOCKS, POSE, words_of
from kindsl.language.text.lines import is_first_on_line

BLOCK_KEYWORDS = frozenset(words_of(*BLOCKS))

_HEADS = frozenset(words_of("head"))
_OTHER_KEYWORDS = frozenset(KEYWORDS) - BLOCK_KEYWORDS - _HEADS
_FIRST_SECTIONS = frozenset(words_of(*(part for block in BLOCKS for part in HOLDS[block])))
_POSE = frozenset(words_of(*POSE))
_LONGEST_FIRST = "|".join(sorted(BLOCK_KEYWORDS | _HEADS, key=len, reverse=True))
_CANDIDATE = re.compile(rf"//[^\r\n]*|/\*|(?<![\w^])({_LONGEST_FIRST})(\w*)")
_BLOCK_LINE = rf"(?:^|(?<=\r))[ \t]*(?:{'|'.join(sorted(BLOCK_KEYWORDS))})\b"
_AHEAD = re.compile(r"[ \t\r\n]*+(?://[^\r\n]*+[ \t\r\n]*+)*+(\^?\w+|/\*|(?s:.))?")
_WORD = re.compile(r"\^?[^\W\d]\w*")
LOOKAHEAD = 6


class Split(NamedTuple):
    """The starts of islands, and whether a comment in them has no end."""

    starts: list[int]
    has_open_comment: bool


def split(text: str) -> Split:
    """Return where the islands of a text begin; the first always at 0."""
    starts = [0]
    last_close = text.rfind("*/")
    comments: list[tuple[int, int]] = []
    has_open_comment = False
    position = 0
    while match := _CANDIDATE.search(text, position):
        begin, position = match.span()
        if match[1] is None:
            if match[0] == "/*":
                if last_close < position:
                    has_open_comment = True
                    line = re.compile(_BLOCK_LINE, re.M).search(text, position)
                    position = line.start() if line else len(text)
                else:
                    position = text.find("*/", position) + 2
            comments.append((begin, position))
        elif begin > 0 and _begins_block(text, match, comments, last_close):
            starts.append(begin)
    return Split(starts, has_open_comment)


def _begins_block(
    text: str, match: re.Match[str], comments: list[tuple[int, int]], last_close: int
) -> bool:
    """Return whether a keyword, or a word that begins with one, begins a block."""
    before = _before(text, match.start(), comments)
    ahead = _ahead(text, match.end(), last_close)
    if match[2]:
        return before in "{}" and _is_glued_block(match[1], ahead)
    if ahead[0] == "floating" and text[: match.start()].rstrip().endswith("RobotBase"):
        return False
    is_first = before in "{}" or is_first_on_line(text, match.start())
    if match[1] in _HEADS:
        return ahead[1] == "{" and (is_first or ahead[2] in BLOCK_KEYWORDS)
    if _WORD.fullmatch(ahead[0]):
        is_same_line = "\n" not in text[match.end() : match.end() + 80].split(ahead[0])[0]
        return _begins_named_block(ahead, is_first, is_same_line)
    if ahead[0] == "{":
        return is_first and (not ahead[1] or ahead[1] in _FIRST_SECTIONS)
    return is_first and ahead[0] not in tuple("}),=/*[]<>+-")


def _begins_named_block(ahead: list[str], is_first: bool, is_same_line: bool) -> bool:
    name, sign, inner = ahead[0], ahead[1], ahead[2]
    if sign == "floating":
        sign, inner = ahead[2], ahead[3]
    if sign in ("via", "="):
        return False
    if name in _OTHER_KEYWORDS:
        return sign == "{" and inner in _FIRST_SECTIONS
    if name in BLOCK_KEYWORDS:
        return is_first and not _WORD.fullmatch(sign)
    if sign == "{":
        return inner not in _POSE or (is_first and is_same_line)
    return is_first


def _is_glued_block(keyword: str, ahead: list[str]) -> bool:
    """Return whether `linkl1 {` means `link l1 {`."""
    sign, inner = (ahead[1], ahead[2]) if ahead[0] == "floating" else (ahead[0], ahead[1])
    if keyword in _HEADS:
        return sign == "{" and inner.startswith("RobotBase")
    return sign == "{" and inner in _FIRST_SECTIONS


def _before(text: str, position: int, comments: list[tuple[int, int]]) -> str:
    last = len(comments) - 1
    while position > 0:
        if last >= 0 and comments[last][1] == position:
            position = comments[last][0]
            last -= 1
        elif text[position - 1] in " \t\r\n":
            position -= 1
        else:
            return text[position - 1]
    return "{"


def _ahead(text: str, position: int, last_close: int) -> list[str]:
    """Return the next four words or signs, empty past the end."""
    words: list[str] = []
    while len(words) < 4:
        match = _AHEAD.match(text, position)
        assert match is not None
        position = match.end()
        if match[1] != "/*":
            words.append(match[1] or "")
        elif last_close < position:
            words.append("")
            position = len(text)
        else:
            position = text.find("*/", position) + 2
    return words
