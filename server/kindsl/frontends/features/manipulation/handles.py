"""The numbers of a thing as its card and its handles in the picture show them."""

from collections.abc import Iterator

from kindsl.frontends.features.manipulation.gesture import Refusal
from kindsl.frontends.features.manipulation.things import (
    Carrier,
    Component,
    Thing,
    components,
    declared,
)
from kindsl.frontends.features.value_place import place_of_name
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.semantics.expressions import Values
from kindsl.language.semantics.model import Model
from kindsl.robots.scene.messages import Handle

_NO_VALUES: Values = {}


def handles(analysis: Analysis, thing: Thing, typed: Values = _NO_VALUES) -> Iterator[Handle]:
    """Yield the components of a thing: three of a centre of mass, else six.

    Args:
        thing: A joint, frame or centre of mass.
        typed: Values of parameters that the preview shows instead of the document's.
    """
    values = {**analysis.context.values, **typed}
    for name, found in components(analysis.model, thing).items():
        if isinstance(found, Refusal):
            yield Handle(name, None, "", locked=found.reason)
        else:
            yield _handle(analysis.model, name, found, values)


def _handle(model: Model, name: str, own: Component, values: Values) -> Handle:
    value, text, carrier = own.expression.value(values), own.expression.text, own.carrier
    if isinstance(carrier, Carrier):
        along = _places_moved_by(model, carrier, own)
        return Handle(name, value, text, str(carrier.use.name), along)
    return Handle(name, value, text, locked=carrier.reason if carrier is not None else "")


def _places_moved_by(model: Model, carrier: Carrier, own: Component) -> tuple[str, ...]:
    """Return the other values with a symbol: `joint 'knee' translation x`."""
    names = [use.name for use in declared(model, carrier.use).uses]
    own_value = own.expression
    elsewhere = (
        place_of_name(name)
        for name in names
        if name.island is not own_value.island or not own_value.start <= name.start < own_value.end
    )
    told = (f"{at.owner} '{at.owner_name}' {at.label}" for at in elsewhere if at is not None)
    return tuple(dict.fromkeys(told))
