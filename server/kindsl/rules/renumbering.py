"""The fix for link numbers: parents before children, without gaps, changing as few as possible."""

from heapq import heapify, heappop, heappush

from kindsl.rules.base import Change, Fix
from kindsl.semantics.declarations import Link
from kindsl.semantics.model import Model

_TITLE = "Renumber the links"
_MOST_CHANGES = 200_000
_KEY = "renumbering"


def renumbering(model: Model, findings: int = 1) -> Fix | None:
    """Return the fix that gives the links regular numbers, or None where the tree has defects.

    Args:
        model: The model.
        findings: How many findings carry it; None when that would be too much text in total.
    """
    if _KEY not in model.facts:
        model.facts[_KEY] = _renumbering(model)
    fix = model.facts[_KEY]
    if not isinstance(fix, Fix) or len(fix.changes) * findings > _MOST_CHANGES:
        return None
    return fix


def regular_order(model: Model) -> list[Link] | None:
    """Return the links with parents first, otherwise by their present numbers; None for no tree.

    Source: Kahn 1962, with the present number as priority.
    """
    tree = model.tree
    if tree.loops or any(len(edges) > 1 for edges in tree.above.values()):
        return None
    index = {link: number for number, link in enumerate(model.links)}
    ready = [(link.id or 0, index[link], link) for link in model.links if not _parent(model, link)]
    heapify(ready)
    order: list[Link] = []
    while ready:
        _, _, link = heappop(ready)
        order.append(link)
        for edge in tree.successor_edges(link):
            if edge.link is not None and edge.link in index:
                heappush(ready, (edge.link.id or 0, index[edge.link], edge.link))
    return order


def _parent(model: Model, link: Link) -> bool:
    edge = model.tree.supporting_edge(link)
    return edge is not None and not edge.predecessor.is_base


def _renumbering(model: Model) -> Fix | None:
    order = regular_order(model)
    if order is None or any(link.id_place is None for link in order):
        return None
    changes = tuple(
        Change(link.id_place, str(number))
        for number, link in enumerate(order, 1)
        if link.id != number and link.id_place is not None
    )
    return Fix(_TITLE, changes) if changes else None
