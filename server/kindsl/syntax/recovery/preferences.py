"""What speaks for and against a repair at a place: its surroundings and its spelling."""

from collections.abc import Sequence

from kindsl.syntax.recovery.repair import Preferences
from kindsl.syntax.scanner import word_kind
from kindsl.syntax.tables import KEYWORDS
from kindsl.syntax.token_names import BLOCK_STARTS, SPELLINGS
from kindsl.syntax.tree import Token
from kindsl.text.nearest import is_near

_SECTIONS = frozenset(SPELLINGS) - frozenset(BLOCK_STARTS) - {"via", "FLOATING", "PI", "LOWER_PI"}
_OPEN, _CLOSED = frozenset("{("), frozenset("})")
_WITHIN_VALUES = frozenset("(,-*/")
_REACH = 400


def preferences(
    text: str, read: Sequence[Token], tokens: Sequence[Token], index: int
) -> Preferences:
    """Return the extra costs of changes at a place.

    Args:
        text: The island's text.
        read: What is read of the block so far.
        tokens: All tokens of the island.
        index: The first token that does not fit.
    """
    words = _section_words(read, tokens, index)
    present = {word_kind(word) for word in words}
    if sum(count for word, count in words.items() if word_kind(word) == "MOMENT") < 6:
        present.discard("MOMENT")

    def insertion(kind: str, place: int) -> float:
        if kind in _SECTIONS and kind in present:
            return 0.5
        if kind == "(" and _is_within_value(tokens, place):
            return 1.0
        if kind in ("NAME", "FLOAT", "INT") and _is_at_line_end(text, tokens, place):
            return -0.2
        return 0.0

    def replacement(kind: str, place: int) -> float:
        old = tokens[place]
        cost = 0.0
        if kind in _SECTIONS:
            cost = 0.5 if kind in present else -0.4
        spellings = SPELLINGS.get(kind)
        is_word = old.text[:1].isidentifier()
        if spellings and is_word and old.text not in KEYWORDS:
            return cost - (0.6 if any(is_near(old.text, word) for word in spellings) else 0.0)
        if kind == "NAME" and old.text in KEYWORDS:
            return cost + 0.6
        if kind == "NAME" or bool(spellings) == is_word:
            return cost
        return cost + 0.3

    def deletion(place: int) -> float:
        token = tokens[place]
        if place > 0 and token.text == tokens[place - 1].text and token.kind not in "{}":
            return -0.3
        return 0.8 if words.get(token.text) == 1 else 0.0

    return Preferences(insertion, replacement, deletion)


def moments_around(read: Sequence[Token], tokens: Sequence[Token], index: int) -> set[str]:
    """Return the moments that the inertia around a place has already."""
    near = [*read[-_REACH:], *tokens[index : index + _REACH]]
    return {token.text for token in near if token.kind == "MOMENT"}


def _section_words(read: Sequence[Token], tokens: Sequence[Token], index: int) -> dict[str, int]:
    """Return how often the block around a place has the keyword of each section."""
    words: dict[str, int] = {}
    for near, inward in (
        (reversed(read[-_REACH:]), _CLOSED),
        (tokens[index : index + _REACH], _OPEN),
    ):
        depth = 0
        for token in near:
            if token.kind in _OPEN or token.kind in _CLOSED:
                depth += 1 if token.kind in inward else -1
                if depth < 0:
                    break
            elif depth == 0 and token.kind in _SECTIONS:
                words[token.text] = words.get(token.text, 0) + 1
    return words


def _is_within_value(tokens: Sequence[Token], place: int) -> bool:
    """Return whether no vector can begin at a place: a value goes on there, or one has begun."""
    before = tokens[place - 1].kind if place > 0 else ""
    return before in _WITHIN_VALUES or (place < len(tokens) and tokens[place].kind == "(")


def _is_at_line_end(text: str, tokens: Sequence[Token], place: int) -> bool:
    """Return whether the token at a place is the first on its line."""
    if not 0 < place < len(tokens):
        return place > 0
    between = text[tokens[place - 1].end : tokens[place].start]
    return "\n" in between or "\r" in between
