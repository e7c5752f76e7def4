"""The edit of one drag: one number of one thing, or the parameter that carries it."""

from collections.abc import Sequence
from math import inf, isclose, isfinite
from typing import NamedTuple

from kindsl.frontends.features.manipulation.gesture import Refusal
from kindsl.frontends.features.manipulation.things import (
    ANGLES,
    Carrier,
    Thing,
    component,
    declared,
)
from kindsl.frontends.features.manipulation.value_text import ValueText, angle_text, number_text
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.semantics.expressions import Expression, ParameterUse, Values
from kindsl.language.semantics.parameters import Parameter
from kindsl.language.text.edits import TextEdit

_NO_VALUES: Values = {}
_UNCHANGED = 1e-12  # below the ten decimals that are written


class ComponentChange(NamedTuple):
    """The change of a component to a new value; empty where it has the value already.

    Attributes:
        label: Its title, in the imperative.
        text: The component, or the value that carries it, as it is written afterwards.
        value: The component's value afterwards, metres or radians.
        edits: Of the document: one, or one for each place that gives a symbol its value.
        bindings: Parameters to bind anew in the configuration file that binds them.
        preview: Parameters to set in the preview only.
    """

    label: str
    text: str
    value: float
    edits: tuple[TextEdit, ...] = ()
    bindings: tuple[tuple[str, float], ...] = ()
    preview: tuple[tuple[str, float], ...] = ()


def set_component(
    analysis: Analysis,
    thing: Thing,
    name: str,
    value: float,
    step: float | None = None,
    typed: Values = _NO_VALUES,
) -> ComponentChange | Refusal:
    """Return what to write so that a component has a value.

    Args:
        thing: A joint, frame or centre of mass.
        name: `x y z` in metres, `rx ry rz` in radians.
        value: The new value.
        step: The value becomes a multiple of this; None for any value.
        typed: Values of parameters that the preview shows instead of the document's.
    """
    is_step = step is None or (isfinite(step) and step > 0.0)
    if not isfinite(value) or not is_step or not isfinite(value / (step or 1.0)):
        return Refusal("a component takes a finite number")
    found = component(analysis.model, thing, name)
    if isinstance(found, Refusal):
        return found
    expression, carrier = found
    value = value if step is None else round(value / step) * step
    label = f"Set {name} of {thing.kind} '{thing.name}'"
    now = expression.value({**analysis.context.values, **typed})
    if now is not None and isclose(now, value, rel_tol=_UNCHANGED, abs_tol=_UNCHANGED):
        return ComponentChange(label, expression.text, now)
    if isinstance(carrier, Refusal):
        return carrier
    if carrier is not None:
        return _of_symbol(analysis, label, carrier, value / carrier.factor, typed)
    is_angle = name in ANGLES
    new = angle_text(value, expression) if is_angle else number_text(value, expression.text)
    return ComponentChange(label, new.text, new.value, _edits(analysis, [expression], new))


def _of_symbol(
    analysis: Analysis, label: str, carrier: Carrier, value: float, typed: Values
) -> ComponentChange | Refusal:
    """Return the change of the symbol in a component, made where the symbol gets its value."""
    name, is_parameter = str(carrier.use.name), isinstance(carrier.use, ParameterUse)
    binding = analysis.settings.bindings.get(name) if is_parameter else None
    is_bound = binding is not None and name not in typed
    given = [] if is_bound or name in typed else _given(analysis, carrier)
    new = number_text(value, given[0].text if given else "")
    change = ComponentChange(label, new.text, new.value * carrier.factor)
    if is_bound and binding is not None:
        least = -inf if binding.minimum is None else binding.minimum
        most = inf if binding.maximum is None else binding.maximum
        if not least <= new.value <= most:
            return Refusal(f"parameter '{name}' would be out of bounds at {new.text}")
        return change._replace(bindings=((name, new.value),))
    if given:
        return change._replace(edits=_edits(analysis, given, new))
    if not is_parameter:
        return Refusal(f"constant '{name}' is not defined")
    return change._replace(preview=((name, new.value),))


def _given(analysis: Analysis, carrier: Carrier) -> list[Expression]:
    """Return the defaults or definitions from which a symbol has the value that it has here."""
    symbol, own = declared(analysis.model, carrier.use), None
    if isinstance(symbol, Parameter):
        found = [each.default for each in symbol.uses]
    else:
        found = [each.value for each in symbol.definitions]
        own = None if isinstance(carrier.use, ParameterUse) else carrier.use.value
    given = [each for each in found if each is not None]
    value = (own or given[0]).value({}) if given else None
    return [each for each in given if each.value({}) == value]


def _edits(
    analysis: Analysis, places: Sequence[Expression], new: ValueText
) -> tuple[TextEdit, ...]:
    """Return the edits that write a number where values stand with another text."""
    others = (place for place in places if place.text != new.text)
    return tuple(sorted(analysis.resolver.edit(place, new.text) for place in others))
