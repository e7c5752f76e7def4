"""Problems in blocks that have the shape of the grammar."""

from collections.abc import Sequence

from kindsl.language.syntax.sections import section_problems
from kindsl.language.syntax.tree import Node, Problem
from kindsl.language.syntax.values import value_problems
from kindsl.language.syntax.vocabulary import BLOCKS


def meaning_problems(text: str, nodes: Sequence[Node], touched: frozenset[int]) -> list[Problem]:
    """Return what is wrong with sections and values.

    Args:
        text: The island's text.
        nodes: Its blocks.
        touched: Ids of the nodes that were repaired, of which less can be said.
    """
    problems: list[Problem] = []
    for node in nodes:
        if node.kind in BLOCKS:
            problems += section_problems(text, node, touched)
            problems += value_problems(text, node, touched)
    return problems
