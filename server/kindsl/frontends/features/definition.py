"""The definitions of names."""

from typing import NamedTuple

from kindsl.frontends.features.symbol_at import (
    Entity,
    EntityKind,
    Role,
    Symbol,
    occurrences,
    symbol_at,
)
from kindsl.frontends.features.tree_path import token_at
from kindsl.judgement.analysis.analysis import Analysis


class Definition(NamedTuple):
    """A place where something is defined.

    Attributes:
        start: Start of the whole construct, for peeking.
        end: Its end.
        name_start: Start of the name.
        name_end: Its end.
    """

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
    places = defining_places(analysis, symbol.entity)
    return tuple(_definition(analysis, place) for place in places)


def defining_places(analysis: Analysis, entity: Entity) -> tuple[Symbol, ...]:
    """Return the places that give an entity its meaning."""
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
