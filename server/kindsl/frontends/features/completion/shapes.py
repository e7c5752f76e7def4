"""Shapes in an empty inertia; a fix writes what they come to."""

from collections.abc import Iterator

from kindsl.frontends.features.completion import snippets
from kindsl.frontends.features.completion.context import CompletionContext
from kindsl.frontends.features.completion.item import CompletionItem
from kindsl.language.syntax.passages import SHAPES

_DETAILS = {
    "box": "x, y, z",
    "cylinder": "radius, length",
    "hollow_cylinder": "outer radius, inner radius, length",
    "sphere": "radius",
    "capsule": "radius, length of its cylinder",
}
_UNITS = {"mass": "kg", "density": "kg/m³"}


def shape_items(context: CompletionContext) -> Iterator[CompletionItem]:
    """Yield each shape with a mass and with a density, where an inertia is empty."""
    behind = context.place.island.text[context.end - context.place.start :].lstrip()
    if context.block != "inertia" or context.sections or behind[:1] not in ("", "}"):
        return
    for name in SHAPES:
        for heavy, unit in _UNITS.items():
            detail = f"{_DETAILS[name]} (m), {heavy} ({unit})"
            text = snippets.shape(name, heavy)
            yield CompletionItem(f"{name} of a {heavy}", "snippet", text, detail, True, True)
