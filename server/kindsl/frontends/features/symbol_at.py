"""Names of links, joints, frames, parameters, constants and the robot, with their places.

They are read from an island's blocks; the result lives as long as the island.
"""

from bisect import bisect_right
from collections.abc import Iterator
from enum import StrEnum
from typing import NamedTuple

from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.semantics.blocks import Block, NameReference
from kindsl.language.semantics.expressions import ConstantUse, Expression, symbols
from kindsl.language.semantics.lowering import declarations
from kindsl.language.semantics.parameters import Parameter
from kindsl.language.semantics.places import Name
from kindsl.language.syntax.tables import DECLARES, REFERS
from kindsl.language.syntax.tree import Island
from kindsl.language.text.facts import kept
from kindsl.language.text.groups import grouped


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
    """A named thing of the document, its name without the escape `^`; the base counts as a link.

    A frame has the link that carries it.
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
    index = bisect_right(symbols, local, key=lambda symbol: symbol.start)
    if index and local <= symbols[index - 1].end:
        return _moved(symbols[index - 1], place.start)
    return None


def parameter_at(analysis: Analysis, start: int, end: int) -> Parameter | None:
    """Return the parameter whose name holds a range."""
    symbol = symbol_at(analysis, start)
    if symbol is None or symbol.entity.kind is not EntityKind.PARAMETER or end > symbol.end:
        return None
    return parameter_named(analysis, symbol.entity.name)


def parameter_named(analysis: Analysis, name: str) -> Parameter | None:
    """Return the parameter of a name."""
    return next((p for p in analysis.model.parameters if p.name == name), None)


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
    symbols = sorted(s for block in declarations(island).blocks for s in _symbols(block))
    return NamedPlaces(tuple(symbols), _by_entity(symbols))


def _by_entity(symbols: list[Symbol]) -> dict[Entity, tuple[Symbol, ...]]:
    found = grouped((symbol.entity, symbol) for symbol in symbols)
    return {entity: tuple(places) for entity, places in found.items()}


def _symbols(block: Block) -> Iterator[Symbol]:
    """Yield the names in a block: its own, those that it refers to, those in its values."""
    owner = str(block.name) or block.owner
    if block.node.kind in DECLARES:
        kind = EntityKind(DECLARES[block.node.kind])
        yield from _named(block.name, Entity(kind, str(block.name), block.owner), Role.DECLARATION)
    for part in block.parts:
        if isinstance(part, Block):
            yield from _symbols(part)
        elif isinstance(part, NameReference):
            for name, kind in zip(part.names, map(EntityKind, REFERS[part.section]), strict=True):
                entity = Entity(kind, str(name), owner if kind is EntityKind.FRAME else "")
                yield from _named(name, entity, Role.READ)
        elif isinstance(part, Expression) and part.literal is None:
            yield from _in_value(part)


def _in_value(value: Expression) -> Iterator[Symbol]:
    for use in symbols(value):
        is_constant = isinstance(use, ConstantUse)
        given = use.value if isinstance(use, ConstantUse) else use.default
        entity = Entity(EntityKind.CONSTANT if is_constant else EntityKind.PARAMETER, str(use.name))
        yield from _named(use.name, entity, Role.READ if given is None else Role.WRITE)


def _named(name: Name, entity: Entity, role: Role) -> Iterator[Symbol]:
    if name.start < name.end:
        yield Symbol(name.start, name.end, entity, role)


def _moved(symbol: Symbol, origin: int) -> Symbol:
    return Symbol(origin + symbol.start, origin + symbol.end, symbol.entity, symbol.role)
