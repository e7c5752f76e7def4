"""The tokens that the grammar allows at a place, also in half-typed text."""

from collections.abc import Sequence
from typing import NamedTuple

from kindsl.language.syntax.automaton import CONSTRUCTS, ROWS, Stack, initial, is_complete, settled
from kindsl.language.syntax.tables import KEYWORDS, NEITHER
from kindsl.language.syntax.token_names import BLOCK_STARTS
from kindsl.language.syntax.tree import Island, Token
from kindsl.language.syntax.vocabulary import NAMES, PIS

_OTHER_NAMES = (NAMES | PIS | NEITHER.keys()) - set(KEYWORDS.values()) - {"NAME"}


class Expected(NamedTuple):
    """The tokens that may come next.

    Attributes:
        kinds: Token kinds; any name is `NAME`. Sections that the block has already are among them.
        constructs: Kinds of the nodes that the place is in, outermost first; empty between blocks.
        prefix: The word that is being typed up to the place, maybe empty.
        start: Where that word begins, code points from the island's start.
    """

    kinds: frozenset[str]
    constructs: tuple[str, ...]
    prefix: str
    start: int


def expected_at(island: Island, offset: int) -> Expected:
    """Return what the grammar allows at an offset of an island.

    Args:
        offset: Code points from the island's start; a word that ends there is being typed.
    """
    before = _before(island, offset)
    prefix, start = "", offset
    if before and before[-1].end >= offset and before[-1].text[:1].isidentifier():
        typed = before.pop()
        start = typed.start
        prefix = island.text[start:offset]
        while before and before[-1].is_missing:
            before.pop()
    stack, block = _read(before)
    if stack is None:
        return Expected(frozenset(BLOCK_STARTS), (), prefix, start)
    kinds = {kind for kind in ROWS[stack.state] if kind != "$END" and stack.after(kind)}
    if is_complete(stack, block):
        kinds |= set(BLOCK_STARTS)
    return Expected(frozenset(kinds - _OTHER_NAMES), _constructs(stack), prefix, start)


def _before(island: Island, offset: int) -> list[Token]:
    tokens = [token for token in island.tokens if token.start < offset]
    while tokens and tokens[-1].is_missing:
        tokens.pop()
    return tokens


def _read(tokens: Sequence[Token]) -> tuple[Stack | None, str]:
    """Return the stack behind tokens and the construct it belongs to, None behind a whole block.

    Tokens that do not fit are passed over, and supplied ones that are not needed.
    """
    stack: Stack | None = None
    block = ""
    for index, token in enumerate(tokens):
        if token.is_missing and _fits(stack, tokens[index:]):
            continue
        after = stack.after(token.kind) if stack is not None else None
        is_between = stack is None or is_complete(stack, block)
        if after is None and is_between and token.kind in BLOCK_STARTS:
            block = BLOCK_STARTS[token.kind]
            after = initial(block).after(token.kind)
        stack = after if after is not None else stack
    if stack is not None and is_complete(stack, block):
        return None, block
    return stack, block


def _fits(stack: Stack | None, tokens: Sequence[Token]) -> bool:
    written = next((token for token in tokens if not token.is_missing), None)
    return stack is not None and written is not None and stack.after(written.kind) is not None


def _constructs(stack: Stack) -> tuple[str, ...]:
    stack = settled(stack)
    found: list[str] = []
    level: Stack | None = stack
    while level is not None:
        construct = CONSTRUCTS[level.state]
        if construct and (not found or found[-1] != construct):
            found.append(construct)
        level = level.below
    return tuple(reversed(found))
