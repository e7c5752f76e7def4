"""Checks values that a caller gives to parameters, by name."""

from collections.abc import Collection, Mapping
from math import isfinite
from typing import SupportsFloat

from kindsl.language.semantics.parameters import Binding
from kindsl.language.text.nearest import hint, nearest_name
from kindsl.robots.mechanism.errors import ParameterValueError


def checked_values(
    given: Mapping[str, object], known: Collection[str], bindings: Mapping[str, Binding]
) -> dict[str, float]:
    """Return the values as floats.

    Args:
        given: Values by name, as a caller gives them.
        known: Names of the parameters that the document uses.
        bindings: Values and ranges from the configuration.

    Raises:
        ParameterValueError: A name is unknown; a value is no finite number or out of its range.
    """
    return {name: _checked(name, value, known, bindings.get(name)) for name, value in given.items()}


def _checked(name: str, value: object, known: Collection[str], binding: Binding | None) -> float:
    if name not in known:
        message = f"the document has no parameter '{name}'{hint(nearest_name(name, known))}"
        raise ParameterValueError(message, name)
    number = _number(name, value)
    limits = (binding.minimum, binding.maximum) if binding is not None else (None, None)
    message = ""
    if limits[0] is not None and number < limits[0]:
        message = f"{name} = {number:g} is below its minimum {limits[0]:g}"
    elif limits[1] is not None and number > limits[1]:
        message = f"{name} = {number:g} is above its maximum {limits[1]:g}"
    if message:
        raise ParameterValueError(message, name)
    return number


def _number(name: str, value: object) -> float:
    is_text = isinstance(value, str | bytes | bool)
    if is_text or not isinstance(value, SupportsFloat) or getattr(value, "shape", ()) != ():
        kind = "an array" if getattr(value, "shape", ()) else type(value).__name__
        message = f"the value of parameter '{name}' is {kind}, not a number"
        raise ParameterValueError(message, name)
    number = float(value)
    if not isfinite(number):
        raise ParameterValueError(f"the value of parameter '{name}' is {number}, not finite", name)
    return number
