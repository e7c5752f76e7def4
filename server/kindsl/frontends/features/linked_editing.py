"""Places that an editor changes together while someone types in one of them.

Only the names of links, joints, frames and constants, and only while each is declared once: typing
in a parameter must not carry along the others, a new parameter is made that way.
"""

from kindsl.frontends.features.symbol_at import EntityKind, Role, occurrences, symbol_at
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.text.span import Span

_LINKED = frozenset((EntityKind.LINK, EntityKind.JOINT, EntityKind.FRAME, EntityKind.CONSTANT))


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
