"""What may stand for a number: parameters of the right class, constants, forms of pi."""

from collections.abc import Iterator

from kindsl.analysis.analysis import Analysis
from kindsl.features.completion.context import CompletionContext
from kindsl.features.completion.item import CompletionItem
from kindsl.features.quantity_text import number
from kindsl.features.value_place import ValuePlace
from kindsl.rules.context import ROBCOGEN
from kindsl.semantics.declarations import ValueKind

_PI_FORMS = (("PI/2.0", "90°"), ("-PI/2.0", "-90°"), ("PI", "180°"), ("-PI", "-180°"))


def value_items(
    analysis: Analysis, context: CompletionContext, place: ValuePlace
) -> Iterator[CompletionItem]:
    """Yield what may stand in a value, what fits its class first."""
    yield from _parameters(analysis, context, place)
    if context.previous is not None and context.previous.text in ("(", ",", "="):
        yield from _plain(place)
    else:
        yield CompletionItem("PI", "value", "PI", "3.142", 3)
    if not (analysis.settings.targets and ROBCOGEN in analysis.settings.targets):
        yield from constant_items(analysis, "<{}>")


def constant_items(analysis: Analysis, form: str) -> Iterator[CompletionItem]:
    """Yield the named constants, each written in a form such as `<{}>`."""
    for constant in analysis.model.constants:
        value = analysis.context.values.get(f"<{constant.name}>")
        detail = "constant" if value is None else f"constant, {number(value)}"
        text = form.format(constant.name)
        yield CompletionItem(text, "constant", text, detail, 4)


def _plain(place: ValuePlace) -> Iterator[CompletionItem]:
    if place.kind is ValueKind.ANGLE:
        for text, detail in _PI_FORMS:
            yield CompletionItem(text, "value", text, detail, 3)
    yield CompletionItem("0.0", "value", "0.0", place.unit, 4)


def _parameters(
    analysis: Analysis, context: CompletionContext, place: ValuePlace
) -> Iterator[CompletionItem]:
    """Yield the parameters; one of another class stands at the end of the list."""
    for parameter in sorted(analysis.model.parameters, key=lambda p: p.kind is not place.kind):
        if not parameter.name or (parameter.name == context.typed and len(parameter.uses) == 1):
            continue
        value = analysis.context.values.get(str(parameter.name))
        told = "unbound" if value is None else number(value)
        rank = 1 if parameter.kind is place.kind else 8
        detail = f"{parameter.kind} parameter, {told}"
        yield CompletionItem(str(parameter.name), "parameter", str(parameter.name), detail, rank)
