"""The subtree of a link: its mass, the number of its joints."""

from typing import NamedTuple

from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.semantics.declarations import Link
from kindsl.language.semantics.unknown import Unknown
from kindsl.language.text.facts import kept
from kindsl.robots.mechanism.total_mass import Weight, added, body_mass, edge_mass


class Subtree(NamedTuple):
    """A link with all that it carries: its weight, and the joints in it.

    A fixed base itself weighs nothing; the supporting joint of the link is left out.
    """

    weight: Weight
    dof: int


_NO_TREE = Subtree(Weight(0.0, 1, Unknown("the links below it are no tree")), 0)


def subtree_of(analysis: Analysis, body: Link) -> Subtree:
    """Return what a body carries, itself included; every body is weighed once an analysis."""
    return _all(analysis).get(body, _NO_TREE)


@kept
def _all(analysis: Analysis) -> dict[Link, Subtree]:
    """Return the subtree of each body that the base reaches."""
    tree = analysis.model.tree
    found: dict[Link, Subtree] = {}
    for root in (body for body in analysis.model.bodies if body not in tree.above):
        for link in reversed([root, *tree.in_topological_order(root)]):
            found[link] = _sum(analysis, link, found)
    return found


def _sum(analysis: Analysis, body: Link, known: dict[Link, Subtree]) -> Subtree:
    weight = body_mass(body, analysis.context.values)
    dof = 0
    for edge in analysis.model.tree.successor_edges(body):
        weight = added(weight, edge_mass(edge))
        if edge.link is None:
            continue
        below = known.get(edge.link, _NO_TREE)
        weight = added(weight, below.weight)
        dof += 1 + below.dof
    return Subtree(weight, dof)
