"""All places of the thing that is named at an offset."""

from kindsl.frontends.features.symbol_at import Role, Symbol, occurrences, symbol_at
from kindsl.judgement.analysis.analysis import Analysis


def references(analysis: Analysis, offset: int) -> tuple[Symbol, ...]:
    """Return the places of the named thing in the order of the text, the defining ones included.

    Each place tells its role, so that a caller can leave out declarations.
    """
    symbol = symbol_at(analysis, offset)
    return () if symbol is None else occurrences(analysis, symbol.entity)


def uses(analysis: Analysis, offset: int) -> tuple[Symbol, ...]:
    """Return the places of the named thing without its declarations."""
    found = references(analysis, offset)
    return tuple(place for place in found if place.role is not Role.DECLARATION)
