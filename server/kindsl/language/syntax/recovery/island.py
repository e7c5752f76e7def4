"""An island that does not fit the grammar: the blocks that are read of it, and what to say."""

from collections.abc import Sequence
from typing import NamedTuple

from kindsl.language.syntax.recovery.block import BlockProgress
from kindsl.language.syntax.recovery.block_kinds import opening
from kindsl.language.syntax.recovery.progress import RepairProgress
from kindsl.language.syntax.tree import Node, Problem, Token


class Recovered(NamedTuple):
    """The result of reading an island's tokens.

    Attributes:
        nodes: The blocks.
        tokens: All tokens in order: read, supplied and skipped.
        skipped: Those that are in no node.
        problems: One for each repair but those in `leftovers`.
        leftovers: One for each repair that does nothing but leave tokens out.
    """

    nodes: tuple[Node, ...]
    tokens: tuple[Token, ...]
    skipped: tuple[Token, ...]
    problems: tuple[Problem, ...]
    leftovers: tuple[Problem, ...]


def recover(text: str, tokens: Sequence[Token], *, is_cut: bool) -> Recovered:
    """Return the nodes and problems of tokens that the grammar does not take as they are.

    Args:
        text: The island's text.
        tokens: Its tokens.
        is_cut: Whether a comment without an end hides the rest of it.
    """
    island = RepairProgress(text, list(tokens), is_cut)
    while island.index < len(island.tokens):
        previous = island.nodes[-1].kind if island.nodes else ""
        block = island.lost or opening(island.tokens, island.index, previous)
        island.lost = None
        if island.is_hopeless:
            island.skip_rest()
        elif block is None:
            island.skip_to_block()
        else:
            island.open(block)
            BlockProgress(island, block.start).read()
    return Recovered(
        tuple(island.nodes),
        tuple(island.written),
        tuple(island.skipped),
        tuple(island.problems),
        tuple(island.leftovers),
    )
