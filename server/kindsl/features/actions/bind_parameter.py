"""Give an unbound parameter a value in `kindsl.toml`."""

from collections.abc import Iterator

from kindsl.analysis.analysis import Analysis
from kindsl.features.actions.action import CodeAction
from kindsl.features.symbol_at import EntityKind, symbol_at
from kindsl.semantics.declarations import ValueKind

_KIND = "quickfix"
_CODE = "KD401"


def bind_parameter(analysis: Analysis, start: int, end: int) -> Iterator[CodeAction]:
    """Offer a binding for the parameter at a range, if it has no value.

    The value is a stand-in, 0.0 or for a dynamics parameter 1.0, to be replaced by the right one.
    """
    symbol = symbol_at(analysis, start)
    if symbol is None or symbol.entity.kind is not EntityKind.PARAMETER or end > symbol.end:
        return
    name = symbol.entity.name
    parameter = next((p for p in analysis.model.parameters if p.name == name), None)
    if parameter is None or name in analysis.context.values:
        return
    value = 1.0 if parameter.kind is ValueKind.DYNAMICS else 0.0
    first, _ = analysis.resolver.span(parameter.name)
    mended = tuple(d for d in analysis.findings if d.code == _CODE and d.start == first)
    title = f"Bind '{name}' in kindsl.toml"
    yield CodeAction(title, _KIND, (), mended, bindings=((name, value),))
