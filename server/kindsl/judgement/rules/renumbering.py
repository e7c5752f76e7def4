"""The fix for link numbers: parents before children, without gaps, changing as few as possible."""

from heapq import heapify, heappop, heappush
from itertools import pairwise
from typing import NamedTuple

from kindsl.judgement.rules.base import Fix, Replacement
from kindsl.judgement.rules.duplicates import repeats
from kindsl.language.semantics.declarations import Link
from kindsl.language.semantics.model import Model
from kindsl.language.text.facts import kept

_TITLE = "Renumber the links"
_MOST_CHANGES = 200_000


def renumbering(model: Model, findings: int = 1) -> Fix | None:
    """Return the fix that gives the links regular numbers, or None where the tree has defects.

    Args:
        findings: How many findings carry it; None when that would be too much text in total.
    """
    fix = _renumbering(model)
    if fix is None or len(fix.changes) * findings > _MOST_CHANGES:
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
    ready = [
        (link.id or 0, index[link], link)
        for link in model.links
        if (edge := tree.supporting_edge(link)) is None or edge.predecessor.is_base
    ]
    heapify(ready)
    order: list[Link] = []
    while ready:
        _, _, link = heappop(ready)
        order.append(link)
        for edge in tree.successor_edges(link):
            if edge.link is not None and edge.link in index:
                heappush(ready, (edge.link.id or 0, index[edge.link], edge.link))
    return order


class CopiedId(NamedTuple):
    """A number that two links have, while another number is missing.

    Attributes:
        copy: The link that has it by mistake.
        owner: The link that it belongs to.
        missing: The number of `copy`.
    """

    copy: Link
    owner: Link
    missing: int


def copied_id(model: Model) -> CopiedId | None:
    """Return the new id for one copied id, None if other ids must change as well.

    The tree, the joints' numbers and the order of the document decide which of the two links has
    the copy; if none of them does, the later one.
    """
    doubled = repeats(model.links, lambda link: link.id)
    missing = set(range(1, len(model.links) + 1)).difference(link.id or 0 for link in model.links)
    if len(doubled) != 1 or len(missing) != 1:
        return None
    (first, again), (number,) = doubled[0], missing
    pairs = (CopiedId(again, first, number), CopiedId(first, again, number))
    oddities, _, copied = min((_oddities(model, c), n, c) for n, c in enumerate(pairs))
    is_in_order = not any(
        (parent.id or 0) >= (link.id or 0)
        for parent, _, link, _ in model.tree.edges
        if link is not None and not {parent, link} & {first, again}
    )
    has_better = oddities[0] and is_in_order and regular_order(model) is not None
    return None if has_better else copied


def _oddities(model: Model, copied: CopiedId) -> tuple[int, int, int]:
    """Return the penalty of assigning this number, the worst part first.

    These are children numbered before their parents, joints that have not their link's number, and
    links that do not follow on each other as they, or their joints, are written.
    """

    def id_of(link: Link) -> int:
        return copied.missing if link is copied.copy else link.id or 0

    moved = [(id_of(e.predecessor), id_of(e.link), e.joint) for e in model.tree.edges if e.link]
    of_joint = {joint: number for _, number, joint in moved if joint is not None}
    orders = (
        [id_of(link) for link in model.links],
        [of_joint[joint] for joint in model.joints if joint in of_joint],
        [number for _, number, _ in moved],
    )
    return (
        sum(parent >= number for parent, number, _ in moved),
        sum(joint.id not in (None, number) for joint, number in of_joint.items()),
        sum(one + 1 != other for order in orders for one, other in pairwise(order)),
    )


@kept
def _renumbering(model: Model) -> Fix | None:
    order = regular_order(model)
    if order is None or any(link.id_place is None for link in order):
        return None
    changes = tuple(
        Replacement(link.id_place, str(number))
        for number, link in enumerate(order, 1)
        if link.id != number and link.id_place is not None
    )
    return Fix(_TITLE, changes) if changes else None
