"""The edit of one drag: one number of one thing, or the parameter that carries it."""

from collections.abc import Mapping
from math import inf, isclose, isfinite
from typing import NamedTuple

from kindsl.frontends.features.manipulation.carrier import Carrier, carrier_of
from kindsl.frontends.features.manipulation.gesture import Refusal
from kindsl.frontends.features.manipulation.things import ANGLES, Missing, Thing, component
from kindsl.frontends.features.manipulation.written_value import (
    Written,
    written_angle,
    written_number,
)
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.semantics.expressions import ConstantUse, Expression, ParameterUse
from kindsl.language.semantics.parameters import Binding
from kindsl.language.text.edits import TextEdit

_NO_VALUES: Mapping[str, float] = {}
_UNCHANGED = 1e-12


class ComponentChange(NamedTuple):
    """The change of a component to a new value; empty where it has the value already.

    Attributes:
        text: The component, or the value that carries it, as it is written afterwards.
        value: The component's value afterwards, metres or radians.
        edits: Of the document: one, or one for each place that gives a symbol its value.
        bindings: Parameters to bind anew in the configuration file that binds them.
        preview: Parameters to set in the preview only.
    """

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
    typed: Mapping[str, float] = _NO_VALUES,
) -> ComponentChange | Refusal:
    """Return what to write so that a component has a value.

    Args:
        analysis: The document.
        thing: A joint, frame or centre of mass.
        name: `x y z` in metres, `rx ry rz` in radians.
        value: The new value.
        step: The value becomes a multiple of this; None for any value.
        typed: Values of parameters that the preview shows instead of the document's.
    """
    is_step = step is None or (isfinite(step) and step > 0.0)
    if not isfinite(value) or not is_step or not isfinite(value / (step or 1.0)):
        return Refusal("a component takes a finite number")
    expression = component(analysis, thing, name)
    if isinstance(expression, Missing):
        return Refusal(expression.reason)
    value = value if step is None else round(value / step) * step
    now = expression.value({**analysis.context.values, **typed})
    if now is not None and isclose(now, value, rel_tol=_UNCHANGED, abs_tol=_UNCHANGED):
        return ComponentChange(expression.text, now)
    carrier = carrier_of(expression)
    if isinstance(carrier, Refusal):
        return carrier
    if carrier is not None:
        return _of_symbol(analysis, carrier, value / carrier.factor, typed)
    if name in ANGLES:
        return _written(analysis, expression, written_angle(value, expression))
    return _written(analysis, expression, written_number(value, expression.text))


def _of_symbol(
    analysis: Analysis, carrier: Carrier, value: float, typed: Mapping[str, float]
) -> ComponentChange | Refusal:
    """Return the change of what carries a component, where it has its value from."""
    name = str(carrier.use.name)
    binding = analysis.settings.bindings.get(name)
    if isinstance(carrier.use, ParameterUse) and name not in typed and binding is not None:
        return _bound(name, binding, value, carrier.factor)
    given = [] if name in typed else _given(analysis, carrier.use)
    if given:
        new = written_number(value, given[0].text)
        edits = [edit for at in given for edit in _edits(analysis, at, new)]
        return ComponentChange(new.text, new.value * carrier.factor, tuple(sorted(edits)))
    if isinstance(carrier.use, ConstantUse):
        return Refusal(f"constant '{name}' is not defined")
    new = written_number(value, "")
    return ComponentChange(new.text, new.value * carrier.factor, preview=((name, new.value),))


def _given(analysis: Analysis, use: ParameterUse | ConstantUse) -> list[Expression]:
    """Return the defaults or definitions from which a symbol has the value that it has here."""
    model = analysis.model
    found: list[Expression | None]
    if isinstance(use, ParameterUse):
        parameter = next(p for p in model.parameters if p.name == use.name)
        found, own = [each.default for each in parameter.uses], None
    else:
        constant = next(c for c in model.constants if c.name == use.name)
        found, own = [each.value for each in constant.definitions], use.value
    given = [each for each in found if each is not None]
    value = (own or given[0]).value({}) if given else None
    return [each for each in given if each.value({}) == value]


def _bound(name: str, binding: Binding, value: float, factor: float) -> ComponentChange | Refusal:
    """Return the change of a parameter that has its value from outside the document."""
    new = written_number(value, "")
    least = -inf if binding.minimum is None else binding.minimum
    most = inf if binding.maximum is None else binding.maximum
    if not least <= new.value <= most:
        return Refusal(f"parameter '{name}' would be out of bounds at {new.text}")
    return ComponentChange(new.text, new.value * factor, bindings=((name, new.value),))


def _written(analysis: Analysis, at: Expression, new: Written) -> ComponentChange:
    return ComponentChange(new.text, new.value, _edits(analysis, at, new))


def _edits(analysis: Analysis, at: Expression, new: Written) -> tuple[TextEdit, ...]:
    """Return the edit that writes a number where a value stands, if it changes the text."""
    if new.text == at.text:
        return ()
    return (TextEdit(*analysis.resolver.span(at), new.text),)
