"""The costs of the changes that a repair may make: their kinds, surroundings and spelling."""

from collections.abc import Sequence
from functools import cache
from math import inf

from kindsl.language.syntax.recovery.costs import COSTS
from kindsl.language.syntax.scanner import word_kind
from kindsl.language.syntax.tables import KEYWORDS
from kindsl.language.syntax.token_names import SPELLINGS
from kindsl.language.syntax.tree import Token
from kindsl.language.syntax.vocabulary import SECTION_TOKENS
from kindsl.language.text.nearest import is_near

_SIGNS = frozenset("{}()=,]>")
_VALUES = frozenset({"NAME", "FLOAT", "INT"})
_OPEN, _CLOSED = frozenset("{("), frozenset("})")
_REACH = 400
_WITHIN_VALUES = frozenset("(,-*/")


class Prices:
    """The costs of changes in a block, each found once.

    Attributes:
        insertion: The cost of inserting a kind before the token of an index.
        replacement: The cost of taking the token of an index for a kind.
        deletion: The cost of leaving out the token of an index, right after another or not.
    """

    def __init__(self, read: Sequence[Token], tokens: Sequence[Token], index: int) -> None:
        """Look at the surroundings of a place."""
        self._tokens = tokens
        self._words = words = _section_words(read, tokens, index)
        self._present = {word_kind(word) for word in words}
        if sum(count for word, count in words.items() if word_kind(word) == "MOMENT") < 6:
            self._present.discard("MOMENT")
        self.insertion = cache(self._insertion)
        self.replacement = cache(self._replacement)
        self.deletion = cache(self._deletion)

    def _insertion(self, kind: str, place: int) -> float:
        more = 0.0
        if kind == "(" and _is_within_value(self._tokens, place):
            more = COSTS["insert '(' in a value, more"]
        elif kind in SECTION_TOKENS and kind in self._present:
            more = COSTS["insert a present section, more"]
        return insertion_cost(kind) + more

    def _replacement(self, kind: str, place: int) -> float:
        old = self._tokens[place] if place < len(self._tokens) else None
        if old is None or old.kind == kind:
            return inf
        price = COSTS["replace an odd character" if old.kind == "BAD" else "replace"]
        if kind not in _VALUES:
            price += COSTS["replace by no value, more"]
        elif old.kind == "=":
            price = COSTS["replace '=' by a value"]
        more = 0.0
        if kind in SECTION_TOKENS:
            state = "present" if kind in self._present else "lacking"
            more = COSTS[f"replace by a {state} section, more"]
        is_no_keyword = old.text[:1].isidentifier() and old.text not in KEYWORDS
        if is_no_keyword and any(is_near(old.text, word) for word in SPELLINGS.get(kind, ())):
            more += COSTS["replace by a near word, more"]
        return price + more

    def _deletion(self, place: int, is_continued: bool) -> float:
        token, price, more = self._tokens[place], 1.0, 0.0
        if is_continued:
            price = COSTS["delete on"]
        elif token.kind in ("BAD", "="):
            price = COSTS["delete an odd character" if token.kind == "BAD" else "delete '='"]
        if place > 0 and token.text == self._tokens[place - 1].text and token.kind not in "{}":
            more = COSTS["delete what is doubled, more"]
        elif self._words.get(token.text) == 1:
            more = COSTS["delete the only section, more"]
        return price + more


def insertion_cost(kind: str) -> float:
    """Return how dear it is to suppose a lost token of that kind."""
    if kind in _SIGNS:
        return 1.0
    return COSTS["insert a value" if kind in _VALUES else "insert a word"]


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
