"""What a hover tells of a value: what it is for, and how much it comes to."""

from kindsl.analysis.analysis import Analysis
from kindsl.features.quantity_text import quantity
from kindsl.features.unknown import why_unknown
from kindsl.features.value_place import ValuePlace
from kindsl.semantics.expressions import Expression


def value_hover(analysis: Analysis, expression: Expression, place: ValuePlace) -> str:
    """Return the value of an expression in SI units, angles in degrees too."""
    values = analysis.context.values
    value = expression.value(values)
    title = f"{place.label} of {place.owner}" if place.owner else place.label
    if value is None:
        return f"{title}: not known, {why_unknown((expression,), values).reason}"
    return f"{title}: **{quantity(value, place.kind, place.unit)}**"
