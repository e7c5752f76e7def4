"""The parameters' rows in the panel: value, range, whether it is the document's own."""

import math
from collections.abc import Mapping
from typing import assert_never

from kindsl.language.semantics.declarations import ValueKind
from kindsl.language.semantics.expressions import Values
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.parameters import Binding, Parameter
from kindsl.robots.scene.messages import ParameterMessage, path_of


def parameter_messages(
    model: Model, bindings: Mapping[str, Binding], typed: Values, guessed: Values
) -> list[ParameterMessage]:
    """Return a row for each parameter, in the order of the document.

    Args:
        bindings: Values and ranges from its surroundings.
        typed: Values that were set in the page; they win.
        guessed: Values that are drawn where there is none; a mass or moment counts as zero.
    """
    rows = []
    for index, parameter in enumerate(model.parameters):
        name = str(parameter.name)
        binding = bindings.get(name)
        own = binding.value if binding else parameter.value
        is_guess = own is None and name not in typed
        shown = guessed.get(name, 0.0) if own is None else own
        minimum, maximum = _range(parameter, binding, shown)
        row = ParameterMessage(
            path=path_of("parameters", name),
            index=index,
            name=name,
            kind=parameter.kind,
            value=typed.get(name, shown),
            is_guess=is_guess,
            is_bound=binding is not None,
            minimum=minimum,
            maximum=maximum,
            has_range=binding is not None and None not in (binding.minimum, binding.maximum),
            is_overridden=name in typed,
        )
        rows.append(row)
    return rows


def _range(parameter: Parameter, binding: Binding | None, value: float) -> tuple[float, float]:
    """Return the slider's range: the configured one, else one around the value."""
    low, high = _usual_range(parameter.kind, value)
    if binding is not None:
        low = low if binding.minimum is None else binding.minimum
        high = high if binding.maximum is None else binding.maximum
    return (low, high) if low < high else (low, low + 1.0)


def _usual_range(kind: ValueKind, value: float) -> tuple[float, float]:
    """Return a range around a value; without one what parameters of its kind usually take."""
    if value and kind is not ValueKind.ANGLE:
        return min(0.0, 2.0 * value), max(0.0, 2.0 * value)
    match kind:
        case ValueKind.LENGTH:
            return -1.0, 1.0
        case ValueKind.ANGLE:
            return -math.pi, math.pi
        case ValueKind.DYNAMICS:
            return 0.0, 10.0
        case _:
            assert_never(kind)
