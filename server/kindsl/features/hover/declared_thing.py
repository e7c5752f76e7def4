"""From a name to the link, joint or frame that it means."""

from collections.abc import Iterator

from kindsl.analysis.analysis import Analysis
from kindsl.features.symbol_at import EntityKind, Role, Symbol
from kindsl.semantics.declarations import Declarations, Frame, Joint, Link
from kindsl.semantics.lowering import declarations


def declared_thing(analysis: Analysis, symbol: Symbol) -> Link | Joint | Frame | None:
    """Return what a name means; where it is declared, exactly that of several of one name."""
    if symbol.role is Role.DECLARATION:
        place = analysis.syntax.island_at(symbol.start)
        local = symbol.start - place.start
        here = _things(declarations(place.island))
        return next((thing for thing in here if thing.name.start == local), None)
    entity = symbol.entity
    if entity.kind is EntityKind.LINK:
        return analysis.model.body_named.get(entity.name)
    if entity.kind is EntityKind.JOINT:
        return analysis.model.joint_named.get(entity.name)
    body = analysis.model.body_named.get(entity.link)
    frames = body.frames if body is not None else ()
    return next((frame for frame in frames if frame.name == entity.name), None)


def _things(declared: Declarations) -> Iterator[Link | Joint | Frame]:
    yield from declared.joints
    for body in declared.bodies():
        yield body
        yield from body.frames
