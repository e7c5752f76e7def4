"""The hover of a parameter or a constant: its class, its value, its uses."""

from collections.abc import Iterator, Sequence
from typing import assert_never

from kindsl.frontends.features.symbol_at import parameter_named
from kindsl.frontends.features.value_place import place_of_name
from kindsl.frontends.features.wording import number, paragraph, quantity
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.semantics.parameters import Constant, Parameter
from kindsl.language.semantics.places import Name
from kindsl.language.semantics.unknown import Unknown, why_unknown
from kindsl.language.syntax.tables import ValueKind
from kindsl.language.text.phrases import counted, listed

_SHOWN = 8


def parameter_hover(analysis: Analysis, name: str) -> str:
    """Return the hover of a parameter: its class, its value, its uses."""
    parameter = parameter_named(analysis, name)
    if parameter is None:
        return f"There is no parameter `{name}`."
    kinds = dict.fromkeys(use.kind for use in parameter.uses)
    classes = listed(map(_class, kinds))
    lines = [*_binding(analysis, parameter), *_uses([use.name for use in parameter.uses])]
    return paragraph(f"**parameter `{name}`**: {classes}", lines)


def constant_hover(analysis: Analysis, name: str) -> str:
    """Return the hover of a named constant: its value and its uses."""
    constant = next((c for c in analysis.model.constants if c.name == name), None)
    if constant is None:
        return f"There is no constant `{name}`."
    value = analysis.context.values.get(f"<{name}>")
    value_line = f"value {number(value)}" if value is not None else _no_value(constant)
    lines = [value_line, *_uses([use.name for use in constant.uses])]
    return paragraph(f"**constant `{name}`**", lines)


def _class(kind: ValueKind) -> str:
    match kind:
        case ValueKind.LENGTH:
            return "kinematics parameter, a length"
        case ValueKind.ANGLE:
            return "kinematics parameter, an angle"
        case ValueKind.DYNAMICS:
            return "dynamics parameter"
        case _:
            assert_never(kind)


def _no_value(constant: Constant) -> str:
    values = [use.value for use in constant.definitions if use.value is not None]
    reason = (
        why_unknown(values, {}) if values else Unknown(f"write `<{constant.name}=1.0>` somewhere")
    )
    return f"no value: {reason.reason}"


def _binding(analysis: Analysis, parameter: Parameter) -> Iterator[str]:
    binding = analysis.settings.bindings.get(str(parameter.name))
    if binding is not None:
        value = quantity(binding.value, parameter.kind)
        yield f"value {value}, from {binding.origin or 'the settings'}"
        if binding.minimum is not None or binding.maximum is not None:
            ends = (binding.minimum, binding.maximum)
            low, high = ("…" if end is None else number(end) for end in ends)
            yield f"range {low} to {high}"
    if parameter.value is not None:
        default = f"default {quantity(parameter.value, parameter.kind)}, in the document"
        yield default + (", not used" if binding is not None else "")
    elif binding is None:
        yield "unbound: no default in the document, no value in `kindsl.toml` or the settings"


def _uses(names: Sequence[Name]) -> Iterator[str]:
    found = map(place_of_name, names)
    places = dict.fromkeys("somewhere" if place is None else place.title for place in found)
    more = f" and {len(places) - _SHOWN} more" if len(places) > _SHOWN else ""
    shown = list(places)[:_SHOWN]
    yield f"{counted(len(names), 'use')}: {'; '.join(shown)}{more}"
