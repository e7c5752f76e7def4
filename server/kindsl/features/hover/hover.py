"""What an editor shows under the pointer."""

from kindsl.analysis.analysis import Analysis
from kindsl.features.hover.declared_thing import declared_thing
from kindsl.features.hover.hover_frame import frame_hover
from kindsl.features.hover.hover_value import value_hover
from kindsl.features.hover.joint import joint_hover
from kindsl.features.hover.keyword import keyword_hover
from kindsl.features.hover.link import link_hover
from kindsl.features.hover.parameter import constant_hover, parameter_hover
from kindsl.features.hover.robot import robot_hover
from kindsl.features.hover_text import Hover
from kindsl.features.symbol_at import EntityKind, Symbol, symbol_at
from kindsl.features.tree_path import TokenAt, token_at
from kindsl.features.value_place import expression_at, value_place
from kindsl.semantics.declarations import Frame, Joint, Link


def hover(analysis: Analysis, offset: int) -> Hover | None:
    """Return what there is to tell of the word at an offset, None where nothing stands."""
    found = token_at(analysis.syntax, offset)
    if found is None:
        return None
    symbol = symbol_at(analysis, offset)
    if symbol is not None:
        return Hover(symbol.start, symbol.end, _named(analysis, found, symbol))
    return _keyword(analysis, found) or _value(analysis, found)


def _named(analysis: Analysis, found: TokenAt, symbol: Symbol) -> str:
    """Return what there is to tell of a named thing, and of the value that it stands in."""
    name = symbol.entity.name
    if symbol.entity.kind is EntityKind.ROBOT:
        return robot_hover(analysis, name)
    if symbol.entity.kind in (EntityKind.PARAMETER, EntityKind.CONSTANT):
        is_parameter = symbol.entity.kind is EntityKind.PARAMETER
        text = parameter_hover(analysis, name) if is_parameter else constant_hover(analysis, name)
        value = _value(analysis, found)
        return f"{text}\n\n{value.markdown}" if value is not None else text
    thing = declared_thing(analysis, symbol)
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
    """Return the hover of the whole value that a token belongs to."""
    expression = expression_at(found.island, found.path)
    place = value_place(found.path, found.token.start)
    if expression is None or place is None:
        return None
    start, end = found.origin + expression.start, found.origin + expression.end
    return Hover(start, end, value_hover(analysis, expression, place))
