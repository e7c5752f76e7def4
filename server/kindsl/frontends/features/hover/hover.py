"""The hover under the pointer."""

from collections.abc import Iterator

from kindsl.frontends.features.hover.keyword import keyword_hover
from kindsl.frontends.features.hover.parameter import constant_hover, parameter_hover
from kindsl.frontends.features.hover.things import frame_hover, joint_hover, link_hover, robot_hover
from kindsl.frontends.features.symbol_at import EntityKind, Role, Symbol, symbol_at
from kindsl.frontends.features.tree_path import TokenAt, token_at
from kindsl.frontends.features.value_place import ValuePlace, expression_at, value_place
from kindsl.frontends.features.wording import Hover, quantity
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.semantics.declarations import Declarations, Frame, Joint, Link
from kindsl.language.semantics.expressions import Expression
from kindsl.language.semantics.lowering import declarations
from kindsl.language.semantics.unknown import why_unknown


def hover(analysis: Analysis, offset: int) -> Hover | None:
    """Return the hover of the word at an offset, None where there is none."""
    found = token_at(analysis.syntax, offset)
    if found is None:
        return None
    symbol = symbol_at(analysis, offset)
    if symbol is not None:
        return Hover(symbol.start, symbol.end, _named(analysis, found, symbol))
    return _keyword(analysis, found) or _value(analysis, found)


def _named(analysis: Analysis, found: TokenAt, symbol: Symbol) -> str:
    """Return the hover of a named thing, followed by the hover of the value around it."""
    name = symbol.entity.name
    if symbol.entity.kind is EntityKind.ROBOT:
        return robot_hover(analysis, name)
    if symbol.entity.kind in (EntityKind.PARAMETER, EntityKind.CONSTANT):
        is_parameter = symbol.entity.kind is EntityKind.PARAMETER
        text = parameter_hover(analysis, name) if is_parameter else constant_hover(analysis, name)
        value = _value(analysis, found)
        return f"{text}\n\n{value.markdown}" if value is not None else text
    thing = _declared_thing(analysis, symbol)
    if isinstance(thing, Link):
        return link_hover(analysis, thing)
    if isinstance(thing, Joint):
        return joint_hover(analysis, thing)
    if isinstance(thing, Frame):
        return frame_hover(analysis, thing)
    return f"There is no {symbol.entity.kind} `{name}`."


def _keyword(analysis: Analysis, found: TokenAt) -> Hover | None:
    is_number_of_link = bool(found.path) and found.path[-1].kind == "id"
    text = keyword_hover("id" if is_number_of_link else found.token.text)
    if text is None:
        return None
    value = _value(analysis, found)
    if value is not None:
        return Hover(value.start, value.end, f"{value.markdown}\n\n{text}")
    return Hover(found.start, found.end, text)


def _value(analysis: Analysis, found: TokenAt) -> Hover | None:
    expression = expression_at(found.island, found.path)
    place = value_place(found.path, found.token.start)
    if expression is None or place is None:
        return None
    start, end = found.origin + expression.start, found.origin + expression.end
    return Hover(start, end, _value_hover(analysis, expression, place))


def _value_hover(analysis: Analysis, expression: Expression, place: ValuePlace) -> str:
    """Return the value of an expression in SI units, angles in degrees too."""
    values = analysis.context.values
    value = expression.value(values)
    if value is None:
        return f"{place.title}: not known, {why_unknown((expression,), values).reason}"
    return f"{place.title}: **{quantity(value, place.meaning.kind, place.meaning.unit)}**"


def _declared_thing(analysis: Analysis, symbol: Symbol) -> Link | Joint | Frame | None:
    """Return the thing that a name means; at a declaration that very one."""
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
