"""Write a parameter's value wherever its name stands."""

from collections.abc import Iterator

from kindsl.frontends.features.actions.action import CodeAction
from kindsl.frontends.features.symbol_at import EntityKind, symbol_at
from kindsl.frontends.features.tree_path import path_at
from kindsl.frontends.features.value_place import expression_at
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.semantics.expressions import symbols
from kindsl.language.semantics.parameters import Use
from kindsl.language.text.decimals import exact_decimal
from kindsl.language.text.edits import TextEdit

_KIND = "refactor.inline"


def inline_parameter(analysis: Analysis, start: int, end: int) -> Iterator[CodeAction]:
    """Offer to replace the parameter at a range by its value, where that is known.

    A value such as `-x/2.0` is replaced as a whole by what it comes to, since no generator takes
    arithmetic of numbers everywhere.
    """
    symbol = symbol_at(analysis, start)
    if symbol is None or symbol.entity.kind is not EntityKind.PARAMETER or end > symbol.end:
        return
    name = symbol.entity.name
    parameter = next((p for p in analysis.model.parameters if p.name == name), None)
    if parameter is None:
        return
    edits = [_edit(analysis, use) for use in parameter.uses]
    known = tuple(dict.fromkeys(edit for edit in edits if edit is not None))
    if len(known) == len(dict.fromkeys(edits)):
        yield CodeAction(f"Inline the parameter '{name}'", _KIND, known)


def _edit(analysis: Analysis, use: Use) -> TextEdit | None:
    """Return the replacement of the value that a use stands in, None if it has other names."""
    island = use.name.island
    expression = expression_at(island, path_at(island, use.name.start))
    assert expression is not None
    value = expression.value(analysis.context.values)
    if value is None or any(symbol.name != use.name for symbol in symbols(expression)):
        return None
    return TextEdit(*analysis.resolver.span(expression), exact_decimal(value))
