"""Formatting of documents, ranges, and what has just been typed."""

from collections.abc import Callable

from lsprotocol import types

from kindsl.frontends.lsp.handlers.table import Handlers
from kindsl.frontends.lsp.session.view import View
from kindsl.frontends.lsp.wire.edits import text_edits
from kindsl.language.text.edits import TextEdit
from kindsl.language.text.span import Span

handlers = Handlers()

_ON_TYPE = types.DocumentOnTypeFormattingOptions(
    first_trigger_character="}", more_trigger_character=["\n"]
)


@handlers.document(types.TEXT_DOCUMENT_FORMATTING)
def document(view: View, _: types.DocumentFormattingParams) -> list[types.TextEdit] | None:
    """Bring a document into the one style; refuse a broken one and say why."""
    from kindsl.language.formatting import format_document

    return _formatted(view, lambda: format_document(view.analysis.syntax), view.refuse)


@handlers.document(types.TEXT_DOCUMENT_RANGE_FORMATTING)
def part(view: View, params: types.DocumentRangeFormattingParams) -> list[types.TextEdit] | None:
    """Bring a part of a document into the one style."""
    from kindsl.language.formatting import format_range

    span = view.span(params.range)
    return _formatted(view, lambda: format_range(view.analysis.syntax, span), view.refuse)


@handlers.document(types.TEXT_DOCUMENT_ON_TYPE_FORMATTING, _ON_TYPE)
def typed(view: View, params: types.DocumentOnTypeFormattingParams) -> list[types.TextEdit] | None:
    """Bring the block that was closed, or the line that was ended, into the one style."""
    from kindsl.frontends.features.ranges import selection_ranges
    from kindsl.language.formatting import format_range

    offset = view.offset(params.position)
    before = view.document.line_start(params.position.line - 1)
    spans = [s for s in selection_ranges(view.analysis, offset) if s.end == offset]
    span = spans[-1] if params.ch == "}" and spans else Span(before, offset)
    return _formatted(view, lambda: format_range(view.analysis.syntax, span), lambda _: None)


def _formatted(
    view: View, format_: Callable[[], list[TextEdit]], refuse: Callable[[str], None]
) -> list[types.TextEdit] | None:
    from kindsl.language.formatting import FormattingRefusedError

    try:
        edits = text_edits(view.document, format_())
    except FormattingRefusedError as error:
        refuse(f"Not formatted: {error}")
        return None
    view.state.refused.discard(view.document.uri)
    return edits
