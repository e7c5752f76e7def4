"""Extra costs of a repair at a place: its surroundings and its spelling."""

from collections.abc import Sequence

from kindsl.language.syntax.recovery.costs import COSTS
from kindsl.language.syntax.recovery.repair import Preferences
from kindsl.language.syntax.scanner import word_kind
from kindsl.language.syntax.tables import KEYWORDS
from kindsl.language.syntax.token_names import SPELLINGS
from kindsl.language.syntax.tree import Token
from kindsl.language.syntax.vocabulary import SECTION_TOKENS
from kindsl.language.text.nearest import is_near

_OPEN, _CLOSED = frozenset("{("), frozenset("})")
_REACH = 400
_WITHIN_VALUES = frozenset("(,-*/")


def preferences(read: Sequence[Token], tokens: Sequence[Token], index: int) -> Preferences:
    """Return the extra costs of changes at a place.

    Args:
        read: Tokens of the block so far.
        tokens: All tokens of the island.
        index: The first token that does not fit.
    """
    words = _section_words(read, tokens, index)
    present = {word_kind(word) for word in words}
    if sum(count for word, count in words.items() if word_kind(word) == "MOMENT") < 6:
        present.discard("MOMENT")

    def insertion(kind: str, place: int) -> float:
        if kind == "(" and _is_within_value(tokens, place):
            return COSTS["insert '(' in a value, more"]
        is_present = kind in SECTION_TOKENS and kind in present
        return COSTS["insert a present section, more"] if is_present else 0.0

    def replacement(kind: str, place: int) -> float:
        old = tokens[place]
        price = 0.0
        if kind in SECTION_TOKENS:
            state = "present" if kind in present else "lacking"
            price = COSTS[f"replace by a {state} section, more"]
        spellings = SPELLINGS.get(kind, ())
        if old.text[:1].isidentifier() and old.text not in KEYWORDS:
            is_near_one = any(is_near(old.text, word) for word in spellings)
            price += COSTS["replace by a near word, more"] if is_near_one else 0.0
        return price

    def deletion(place: int) -> float:
        token = tokens[place]
        if place > 0 and token.text == tokens[place - 1].text and token.kind not in "{}":
            return COSTS["delete what is doubled, more"]
        return COSTS["delete the only section, more"] if words.get(token.text) == 1 else 0.0

    return Preferences(insertion, replacement, deletion)


def _is_within_value(tokens: Sequence[Token], place: int) -> bool:
    """Return whether no vector can begin at a place: a value goes on there, or one has begun."""
    before = tokens[place - 1].kind if place > 0 else ""
    return before in _WITHIN_VALUES or (place < len(tokens) and tokens[place].kind == "(")


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
            elif depth == 0 and token.kind in SECTION_TOKENS:
                words[token.text] = words.get(token.text, 0) + 1
    return words
