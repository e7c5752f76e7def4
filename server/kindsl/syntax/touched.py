"""Which nodes a repair has changed."""

from collections.abc import Sequence

from kindsl.syntax.tables import PUNCTUATION
from kindsl.syntax.tree import Node, Token


def touched_nodes(nodes: Sequence[Node], skipped: Sequence[Token]) -> frozenset[int]:
    """Return the `id` of each node that a supplied or a skipped token belongs to.

    What such a block has or lacks is explained by its repair.
    """
    touched: set[int] = set()
    places = [(token.start, token.end) for token in skipped]
    pending = list(nodes)
    while pending:
        node = pending.pop()
        if any(isinstance(child, Token) and _is_repaired(child) for child in node.children):
            touched.add(id(node))
        inner = [child for child in node.children if isinstance(child, Node)]
        pending += inner
        start, end = node.start, node.end
        within = [place for place in places if start <= place[0] and place[1] <= end]
        if any(not any(c.start <= s and e <= c.end for c in inner) for s, e in within):
            touched.add(id(node))
    return frozenset(touched)


def _is_repaired(token: Token) -> bool:
    return token.is_missing or (token.kind in PUNCTUATION and token.text != token.kind)
