"""The numbers of a thing as its card and its handles in the picture show them."""

from collections.abc import Iterator, Mapping

from kindsl.frontends.features.manipulation.carrier import Carrier, carrier_of
from kindsl.frontends.features.manipulation.places import places_moved_by
from kindsl.frontends.features.manipulation.things import ANGLES, LENGTHS, Missing, Thing, component
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.semantics.expressions import Expression
from kindsl.robots.scene.messages import Handle

_NO_VALUES: Mapping[str, float] = {}


def handles(
    analysis: Analysis, thing: Thing, typed: Mapping[str, float] = _NO_VALUES
) -> Iterator[Handle]:
    """Yield the components of a thing as they are now: three of a centre of mass, else six.

    Args:
        analysis: The document.
        thing: A joint, frame or centre of mass.
        typed: Values of parameters that the preview shows instead of the document's.
    """
    values = {**analysis.context.values, **typed}
    for name in LENGTHS if thing.kind == "com" else (*LENGTHS, *ANGLES):
        expression = component(analysis, thing, name)
        if isinstance(expression, Missing):
            yield Handle(name, None, "", locked=expression.reason)
        else:
            yield _handle(analysis, name, expression, values)


def _handle(
    analysis: Analysis, name: str, expression: Expression, values: Mapping[str, float]
) -> Handle:
    value, text = expression.value(values), expression.text
    carrier = carrier_of(expression)
    if isinstance(carrier, Carrier):
        along = places_moved_by(analysis, carrier.use, expression)
        return Handle(name, value, text, str(carrier.use.name), along)
    return Handle(name, value, text, locked=carrier.reason if carrier is not None else "")
