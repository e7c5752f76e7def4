"""Semantic tokens: whole and in a range."""

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from lsprotocol import types

from kindsl.frontends.lsp.handlers.table import Handlers
from kindsl.frontends.lsp.session.view import View
from kindsl.frontends.lsp.text.document import Document

if TYPE_CHECKING:
    from kindsl.frontends.features.semantic_tokens import SemanticToken

handlers = Handlers()

TYPES = (
    "namespace", "class", "method", "property", "parameter", "variable", "keyword", "number",
    "comment", "operator",
)  # fmt: skip
MODIFIERS = ("declaration", "readonly", "modification", "defaultLibrary", "deprecated")

_LEGEND = types.SemanticTokensLegend(TYPES, MODIFIERS)
_OPTIONS = types.SemanticTokensRegistrationOptions(_LEGEND, full=True, range=True)
_TYPE_NUMBERS = {name: number for number, name in enumerate(TYPES)}
_MODIFIER_BITS = {name: 1 << number for number, name in enumerate(MODIFIERS)}


@handlers.document(types.TEXT_DOCUMENT_SEMANTIC_TOKENS_FULL, _OPTIONS)
def whole(view: View, _: types.SemanticTokensParams) -> dict[str, Any]:
    """Tell all tokens."""
    return {"data": _data(view)}


@handlers.document(types.TEXT_DOCUMENT_SEMANTIC_TOKENS_RANGE, _OPTIONS)
def part(view: View, params: types.SemanticTokensRangeParams) -> dict[str, Any]:
    """Tell the tokens of what is visible."""
    return {"data": _data(view, *view.span(params.range))}


def _data(view: View, start: int = 0, end: int | None = None) -> list[int]:
    from kindsl.frontends.features.semantic_tokens import semantic_tokens

    return encoded(view.document, semantic_tokens(view.analysis, start, end))


def encoded(document: Document, tokens: "Iterable[SemanticToken]") -> list[int]:
    """Return five numbers a token: line and column from the one before, length, type, modifiers."""
    lines, encoding = document.lines, document.encoding
    data: list[int] = []
    line = line_start = column = 0
    line_end = -1
    for start, end, kind, modifiers in tokens:
        before, column_before = line, column
        if start >= line_end:
            line = lines.line(start)
            line_start, line_end = lines.start(line), lines.start(line + 1)
        column = lines.units(line_start, start, encoding)
        step = column if line != before else column - column_before
        length = lines.units(start, end, encoding)
        bits = sum(map(_MODIFIER_BITS.__getitem__, modifiers))
        data.extend((line - before, step, length, _TYPE_NUMBERS[kind], bits))
    return data
