"""Names and what they stand for: links, joints, frames, parameters, constants and the robot.

One walk over an island finds all its names; the result lives as long as the island.
"""

from bisect import bisect_right
from collections.abc import Iterator
from enum import StrEnum
from typing import NamedTuple

from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.semantics.lowering import NAME
from kindsl.language.syntax.tree import Island, Node, Token
from kindsl.language.text.facts import kept


class EntityKind(StrEnum):
    """The kind of thing that a name stands for."""

    ROBOT = "robot"
    LINK = "link"
    JOINT = "joint"
    FRAME = "frame"
    PARAMETER = "parameter"
    CONSTANT = "constant"


class Role(StrEnum):
    """The role of a name at its place."""

    DECLARATION = "declaration"
    READ = "read"
    WRITE = "write"


class Entity(NamedTuple):
    """A named thing of the document.

    Attributes:
        kind: Its kind; the base counts as a link.
        name: Its name, without the escape `^`.
        link: For a frame, the link that carries it.
    """

    kind: EntityKind
    name: str
    link: str = ""


class Symbol(NamedTuple):
    """One place of an entity; offsets in code points of the document or of an island."""

    start: int
    end: int
    entity: Entity
    role: Role


class NamedPlaces(NamedTuple):
    """The names in one island, in the order of the text, and the same by entity."""

    symbols: tuple[Symbol, ...]
    of: dict[Entity, tuple[Symbol, ...]]


def symbol_at(analysis: Analysis, offset: int) -> Symbol | None:
    """Return the name at an offset, or ending there, with absolute offsets."""
    place = analysis.syntax.island_at(offset)
    local = offset - place.start
    symbols = named_places(place.island).symbols
    index = bisect_right(symbols, local, key=_start)
    if index and local <= symbols[index - 1].end:
        return _moved(symbols[index - 1], place.start)
    return None


def occurrences(analysis: Analysis, entity: Entity) -> tuple[Symbol, ...]:
    """Return all places of an entity in the order of the text, with absolute offsets."""
    syntax = analysis.syntax
    return tuple(
        _moved(symbol, start)
        for island, start in zip(syntax.islands, syntax.starts, strict=True)
        for symbol in named_places(island).of.get(entity, ())
    )


@kept
def named_places(island: Island) -> NamedPlaces:
    """Return the names in an island, offsets from its start; computed once in its life."""
    symbols = sorted(s for node in island.nodes for s in _symbols(node, ""))
    return NamedPlaces(tuple(symbols), _by_entity(symbols))


def _by_entity(symbols: list[Symbol]) -> dict[Entity, tuple[Symbol, ...]]:
    found: dict[Entity, list[Symbol]] = {}
    for symbol in symbols:
        found.setdefault(symbol.entity, []).append(symbol)
    return {entity: tuple(places) for entity, places in found.items()}


_DECLARED = {
    "head": EntityKind.ROBOT,
    "base": EntityKind.LINK,
    "link": EntityKind.LINK,
    "joint": EntityKind.JOINT,
    "frame": EntityKind.FRAME,
}
_NAMELESS = frozenset(("number", "pi", "id"))
_VALUES = {
    "parameter": (EntityKind.PARAMETER, Role.READ),
    "juxtaposed_parameter": (EntityKind.PARAMETER, Role.READ),
    "defaulted": (EntityKind.PARAMETER, Role.WRITE),
    "constant_use": (EntityKind.CONSTANT, Role.READ),
    "constant": (EntityKind.CONSTANT, Role.WRITE),
}


def _symbols(node: Node, link: str) -> Iterator[Symbol]:
    """Yield the names below a node; `link` is the name of the block around it."""
    kind = node.kind
    names = [t for t in node.children if isinstance(t, Token) and t.kind == NAME]
    if kind in _DECLARED:
        name = _text(names[0])
        yield from _named(names, Entity(_DECLARED[kind], name, link), Role.DECLARATION)
        link = name
    elif kind in _VALUES and names:
        what, role = _VALUES[kind]
        yield from _named(names, Entity(what, _text(names[0])), role)
    elif kind == "inertia_frame" and names:
        yield from _named(names, Entity(EntityKind.FRAME, _text(names[0]), link), Role.READ)
    elif kind == "child":
        for token, what in zip(names, (EntityKind.LINK, EntityKind.JOINT), strict=True):
            yield from _named([token], Entity(what, _text(token)), Role.READ)
    for child in node.children:
        if isinstance(child, Node) and child.kind not in _NAMELESS:
            yield from _symbols(child, link)


def _named(tokens: list[Token], entity: Entity, role: Role) -> Iterator[Symbol]:
    for token in tokens:
        if not token.is_missing:
            yield Symbol(token.start, token.end, entity, role)


def _text(token: Token) -> str:
    return token.text.removeprefix("^")


def _start(symbol: Symbol) -> int:
    return symbol.start


def _moved(symbol: Symbol, origin: int) -> Symbol:
    return Symbol(origin + symbol.start, origin + symbol.end, symbol.entity, symbol.role)
