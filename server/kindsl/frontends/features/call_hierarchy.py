"""The kinematic tree one step at a time: who carries a link, and whom it carries.

Editors show it as a call hierarchy: the callers of a link are its predecessors, its callees the
links that it carries, each with the place where `link via joint` is written.
"""

from typing import NamedTuple

from kindsl.frontends.features.outline import DocumentSymbol, body_symbol
from kindsl.frontends.features.symbol_at import EntityKind, symbol_at
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.semantics.declarations import Link
from kindsl.language.semantics.kinematic_tree import Edge
from kindsl.language.text.span import Span


class HierarchyCall(NamedTuple):
    """A neighbour in the tree, and where the connection is written."""

    item: DocumentSymbol
    places: tuple[Span, ...]


def hierarchy_items(analysis: Analysis, offset: int) -> tuple[DocumentSymbol, ...]:
    """Return the body named at an offset; for a joint, the link that it moves."""
    symbol = symbol_at(analysis, offset)
    if symbol is None:
        return ()
    name, edges = symbol.entity.name, analysis.model.tree.edges
    body: Link | None = None
    if symbol.entity.kind is EntityKind.LINK:
        body = analysis.model.body_named.get(name)
    elif symbol.entity.kind is EntityKind.JOINT:
        body = next((e.link for e in edges if e.joint is not None and e.joint.name == name), None)
    return () if body is None else (_item(analysis, body),)


def predecessors(analysis: Analysis, name: str) -> tuple[HierarchyCall, ...]:
    """Return the bodies that carry a body, more than one only in a broken tree."""
    return tuple(
        HierarchyCall(_item(analysis, edge.predecessor), (_place(analysis, edge),))
        for edge in analysis.model.tree.edges
        if edge.link is not None and edge.link.name == name
    )


def successors(analysis: Analysis, name: str) -> tuple[HierarchyCall, ...]:
    """Return the links that a body carries."""
    body = analysis.model.body_named.get(name)
    return tuple(
        HierarchyCall(_item(analysis, edge.link), (_place(analysis, edge),))
        for edge in analysis.model.tree.edges
        if edge.predecessor is body and edge.link is not None
    )


def _item(analysis: Analysis, body: Link) -> DocumentSymbol:
    edge = analysis.model.tree.supporting_edge(body)
    detail = "base" if body.is_base else "link"
    if edge is not None and edge.joint is not None:
        detail = f"via {edge.joint.name} ({edge.joint.kind})"
    return body_symbol(analysis, body, detail)


def _place(analysis: Analysis, edge: Edge) -> Span:
    return Span(*analysis.resolver.span(edge.child))
