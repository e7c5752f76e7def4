"""Places of the name at an offset: definitions, references, highlights, linked edits, hierarchy."""

from typing import NamedTuple

from kindsl.frontends.features.outline import DocumentSymbol, body_symbol
from kindsl.frontends.features.symbol_at import (
    Entity,
    EntityKind,
    Role,
    Symbol,
    occurrences,
    symbol_at,
)
from kindsl.frontends.features.tree_path import TokenAt, token_at
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.semantics.declarations import Link
from kindsl.language.syntax.tree import Token
from kindsl.language.text.span import Span

_PAIRS = {"{": "}", "(": ")", "[": "]", "<": ">"}
_CLOSING = {close: opening for opening, close in _PAIRS.items()}
_LINKED = frozenset((EntityKind.LINK, EntityKind.JOINT, EntityKind.FRAME, EntityKind.CONSTANT))


class Definition(NamedTuple):
    """A place where something is defined: the whole construct, for peeking, and its name."""

    start: int
    end: int
    name_start: int
    name_end: int


def definitions(analysis: Analysis, offset: int) -> tuple[Definition, ...]:
    """Return where the name at an offset is defined, most specific places first.

    A parameter is defined where it has a default, a constant where it has its value; one that has
    neither is taken to be defined where it stands first.
    """
    symbol = symbol_at(analysis, offset)
    if symbol is None:
        return ()
    places = _defining_places(analysis, symbol.entity)
    return tuple(_definition(analysis, place) for place in places)


def _defining_places(analysis: Analysis, entity: Entity) -> tuple[Symbol, ...]:
    places = occurrences(analysis, entity)
    defining = tuple(place for place in places if place.role is not Role.READ)
    if not defining and entity.kind is EntityKind.PARAMETER:
        return places[:1]
    return defining


def bound_parameter(analysis: Analysis, offset: int) -> str | None:
    """Return the name of the parameter at an offset if a value is given to it from outside.

    The editor then looks for the place in `kindsl.toml`.
    """
    symbol = symbol_at(analysis, offset)
    if symbol is None or symbol.entity.kind is not EntityKind.PARAMETER:
        return None
    name = symbol.entity.name
    return name if name in analysis.settings.bindings else None


def _definition(analysis: Analysis, place: Symbol) -> Definition:
    found = token_at(analysis.syntax, place.start)
    assert found is not None
    node, origin = found.path[-1], found.origin
    return Definition(origin + node.start, origin + node.end, place.start, place.end)


def references(analysis: Analysis, offset: int) -> tuple[Symbol, ...]:
    """Return the places of the named thing in the order of the text, the defining ones included.

    Each place has its role, so that a caller can leave out declarations.
    """
    symbol = symbol_at(analysis, offset)
    return () if symbol is None else occurrences(analysis, symbol.entity)


def uses(analysis: Analysis, offset: int) -> tuple[Symbol, ...]:
    """Return the places of the named thing without its declarations."""
    found = references(analysis, offset)
    return tuple(place for place in found if place.role is not Role.DECLARATION)


class Highlight(NamedTuple):
    """A stretch to light up: `text`, or `read` or `write` for a name."""

    start: int
    end: int
    kind: str


def highlights(analysis: Analysis, offset: int) -> tuple[Highlight, ...]:
    """Return all places of the name at an offset, or the bracket there and its partner."""
    symbol = symbol_at(analysis, offset)
    if symbol is not None:
        places = occurrences(analysis, symbol.entity)
        kinds = {Role.READ: "read"}
        return tuple(Highlight(p.start, p.end, kinds.get(p.role, "write")) for p in places)
    found = token_at(analysis.syntax, offset)
    return () if found is None else _brackets(found)


def _brackets(found: TokenAt) -> tuple[Highlight, ...]:
    if not found.path:
        return ()
    signs = [t for t in found.path[-1].children if isinstance(t, Token) and not t.is_missing]
    partner_kind = _PAIRS.get(found.token.kind) or _CLOSING.get(found.token.kind)
    partner = next((t for t in signs if t.kind == partner_kind), None)
    if partner is None:
        return ()
    pair = sorted((found.token, partner), key=lambda token: token.start)
    return tuple(Highlight(found.origin + t.start, found.origin + t.end, "text") for t in pair)


def linked_ranges(analysis: Analysis, offset: int) -> tuple[Span, ...]:
    """Return all places of the name declared at an offset, none if there is but one."""
    symbol = symbol_at(analysis, offset)
    if symbol is None or symbol.entity.kind not in _LINKED or symbol.role is Role.READ:
        return ()
    places = occurrences(analysis, symbol.entity)
    declared = [place for place in places if place.role is not Role.READ]
    if len(declared) != 1 or len(places) < 2:
        return ()
    texts = {analysis.text[place.start : place.end] for place in places}
    return tuple(Span(p.start, p.end) for p in places) if len(texts) == 1 else ()


class HierarchyCall(NamedTuple):
    """A neighbour in the tree, and where the connection is written."""

    item: DocumentSymbol
    place: Span


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
        HierarchyCall(_item(analysis, edge.predecessor), analysis.resolver.span(edge.child))
        for edge in analysis.model.tree.edges
        if edge.link is not None and edge.link.name == name
    )


def successors(analysis: Analysis, name: str) -> tuple[HierarchyCall, ...]:
    """Return the links that a body carries."""
    body = analysis.model.body_named.get(name)
    return tuple(
        HierarchyCall(_item(analysis, edge.link), analysis.resolver.span(edge.child))
        for edge in analysis.model.tree.edges
        if edge.predecessor is body and edge.link is not None
    )


def _item(analysis: Analysis, body: Link) -> DocumentSymbol:
    edge = analysis.model.tree.supporting_edge(body)
    detail = "base" if body.is_base else "link"
    if edge is not None and edge.joint is not None:
        detail = f"via {edge.joint.name} ({edge.joint.kind})"
    return body_symbol(analysis, body, detail)
