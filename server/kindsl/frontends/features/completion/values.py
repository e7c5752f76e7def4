"""Completions of values: parameters of the right class, constants, forms of pi, shapes."""

from collections.abc import Iterator

from kindsl.frontends.features.completion import snippets
from kindsl.frontends.features.completion.context import CompletionContext
from kindsl.frontends.features.completion.item import CompletionItem
from kindsl.frontends.features.value_place import ValuePlace
from kindsl.frontends.features.wording import number
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.judgement.rules.context import ROBCOGEN
from kindsl.language.semantics.declarations import ValueKind
from kindsl.language.syntax.passages import SHAPES
from kindsl.language.syntax.vocabulary import MOMENTS

_PI_FORMS = (("PI/2.0", "90°"), ("-PI/2.0", "-90°"), ("PI", "180°"), ("-PI", "-180°"))
_DIVISORS = {"2.0": "90°", "4.0": "45°", "3.0": "60°", "6.0": "30°"}
_NEVER_ZERO = frozenset(("mass", *MOMENTS[:3]))


_DETAILS = {
    "box": "x, y, z",
    "cylinder": "radius, length",
    "hollow_cylinder": "outer radius, inner radius, length",
    "sphere": "radius",
    "capsule": "radius, length of its cylinder",
}
_UNITS = {"mass": "kg", "density": "kg/m³"}


def value_items(
    analysis: Analysis, context: CompletionContext, place: ValuePlace
) -> Iterator[CompletionItem]:
    """Yield completions of a value, those of its class first."""
    before = context.previous.text
    if before == "/":
        yield from _divisors(context)
        return
    yield from _parameters(analysis, context, place)
    if before in ("(", ",", "="):
        yield from _usual(place)
    elif place.meaning.kind is ValueKind.ANGLE:
        if before == "-":
            yield CompletionItem("PI/2.0", "value", "PI/2.0", "90°")
        yield CompletionItem("PI", "value", "PI", "180°")
    if ROBCOGEN not in analysis.settings.targets:
        yield from constant_items(analysis, "<{}>")


def constant_items(analysis: Analysis, form: str) -> Iterator[CompletionItem]:
    """Yield the named constants, each written in a form such as `<{}>`."""
    for constant in filter(lambda constant: constant.name, analysis.model.constants):
        value = analysis.context.values.get(f"<{constant.name}>")
        detail = "constant" if value is None else f"constant, {number(value)}"
        text = form.format(constant.name)
        yield CompletionItem(text, "constant", text, detail)


def _usual(place: ValuePlace) -> Iterator[CompletionItem]:
    if place.meaning.kind is ValueKind.ANGLE:
        for text, detail in _PI_FORMS:
            yield CompletionItem(text, "value", text, detail)
    if place.meaning.section not in _NEVER_ZERO:
        yield CompletionItem("0.0", "value", "0.0", place.meaning.unit, is_asked_for=True)


def _divisors(context: CompletionContext) -> Iterator[CompletionItem]:
    """Yield numbers to divide by, with the angle that a fraction of pi comes to."""
    local = context.start - context.place.start
    tokens = [t.kind for t in context.place.island.tokens if t.end <= local and not t.is_missing]
    is_pi = tokens[-2:-1] == ["PI"]
    for text, angle in _DIVISORS.items():
        yield CompletionItem(text, "value", text, angle if is_pi else "")


def _parameters(
    analysis: Analysis, context: CompletionContext, place: ValuePlace
) -> Iterator[CompletionItem]:
    """Yield the parameters of the place's class, but for the one that is being typed."""
    for parameter in analysis.model.parameters:
        name = str(parameter.name)
        is_new = name == context.typed and len(parameter.uses) == 1
        if not name or is_new or parameter.kind is not place.meaning.kind:
            continue
        value = analysis.context.values.get(name)
        shown = "unbound" if value is None else number(value)
        yield CompletionItem(name, "parameter", name, f"{parameter.kind} parameter, {shown}")


def shape_items(context: CompletionContext) -> Iterator[CompletionItem]:
    """Yield each shape with a mass and with a density, where an inertia is empty."""
    behind = context.place.island.text[context.end - context.place.start :].lstrip()
    if context.block != "inertia" or context.sections or behind[:1] not in ("", "}"):
        return
    for name in SHAPES:
        for heavy, unit in _UNITS.items():
            detail = f"{_DETAILS[name]} (m), {heavy} ({unit})"
            text = snippets.shape(name, heavy)
            yield CompletionItem(f"{name} of a {heavy}", "snippet", text, detail, is_asked_for=True)
