"""Names and keywords as robcogen2 reads them: `link link {`, `linkl1 {`."""

from collections.abc import Sequence

from kindsl.language.syntax.automaton import Stack
from kindsl.language.syntax.recovery.block_kinds import LONGEST_FIRST, unglue
from kindsl.language.syntax.tables import KEYWORDS
from kindsl.language.syntax.tree import Token

_GLUED = (*LONGEST_FIRST, "via")


def goes_on(stack: Stack, tokens: Sequence[Token]) -> bool:
    """Return whether tokens fit, a keyword also where a name is."""
    following: Stack | None = stack
    for token in tokens:
        assert following is not None
        after = following.after(token.kind)
        if after is None and token.text in KEYWORDS:
            after = following.after("KEYWORD_NAME")
        if after is None:
            return False
        following = after
    return True


def unglued(stack: Stack, token: Token) -> tuple[Token, Token] | None:
    """Return the keyword and the name of `viajoint` where that keyword may stand, else None."""
    for word in _GLUED:
        if token.text.startswith(word) and len(token.text) > len(word):
            pair = unglue(token, word)
            if pair is not None and stack.after(pair[0].kind) is not None:
                return pair
    return None
