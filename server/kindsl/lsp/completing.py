"""Completion: what may be typed, and the text beside the list for one item."""

from typing import TYPE_CHECKING, Any

from lsprotocol import types

from kindsl.lsp.handlers import Handlers
from kindsl.lsp.view import View, plain

if TYPE_CHECKING:
    from kindsl.features.completion import Completions
    from kindsl.features.completion_item import CompletionItem
    from kindsl.lsp.server import KindslLanguageServer

handlers = Handlers()

_OPTIONS = types.CompletionOptions(
    trigger_characters=[" ", "{", "(", "=", "<", "^"], resolve_provider=True
)
_KINDS = {
    "keyword": types.CompletionItemKind.Keyword,
    "snippet": types.CompletionItemKind.Snippet,
    "link": types.CompletionItemKind.Class,
    "joint": types.CompletionItemKind.Method,
    "frame": types.CompletionItemKind.Property,
    "parameter": types.CompletionItemKind.Variable,
    "constant": types.CompletionItemKind.Constant,
    "value": types.CompletionItemKind.Value,
}
_ITEM = "text_document.completion.completion_item"


@handlers.place(types.TEXT_DOCUMENT_COMPLETION, _OPTIONS)
def complete(view: View, params: types.CompletionParams) -> types.CompletionList:
    """Offer what may be typed, the best first."""
    from kindsl.features.completion import completions

    found = completions(view.analysis, view.offset(params.position))
    place = _place(view, found, params.position)
    items = [_item(view, item, number, place) for number, item in enumerate(found.items)]
    return types.CompletionList(found.is_incomplete, items)


@handlers.server(types.COMPLETION_ITEM_RESOLVE)
def resolve(server: "KindslLanguageServer", item: types.CompletionItem) -> Any:
    """Add the text beside the list."""
    data = item.data if isinstance(item.data, dict) else {}
    return server.ask(_with_documentation, str(data.get("uri", "")), item)


def _with_documentation(view: View, item: types.CompletionItem) -> types.CompletionItem:
    from kindsl.features.completion import documentation

    data = item.data if isinstance(item.data, dict) else {}
    text = documentation(view.analysis, str(data.get("kind", "")), item.label)
    if text is not None:
        formats = f"{_ITEM}.documentation_format"
        is_told = bool(view.client.values(formats))
        item.documentation = view.markup(text, formats) if is_told else plain(text)
    return item


def _place(
    view: View, found: "Completions", position: types.Position
) -> tuple[types.Range, types.Range | None]:
    """Return the word to replace, and the part before the cursor for a client that can choose."""
    whole = view.range(found.start, found.end)
    if not view.client.can(f"{_ITEM}.insert_replace_support"):
        return whole, None
    return whole, types.Range(whole.start, view.document.position(view.offset(position)))


def _item(
    view: View,
    item: "CompletionItem",
    number: int,
    place: tuple[types.Range, types.Range | None],
) -> types.CompletionItem:
    is_snippet = item.is_snippet and view.client.can(f"{_ITEM}.snippet_support")
    text = item.text if is_snippet else item.plain_text
    whole, inserted = place
    adjusts = view.client.values(f"{_ITEM}.insert_text_mode_support.value_set")
    return types.CompletionItem(
        label=item.label,
        kind=_KINDS[item.kind],
        detail=item.detail or None,
        sort_text=f"{number:04}",
        insert_text_format=types.InsertTextFormat.Snippet if is_snippet else None,
        insert_text_mode=types.InsertTextMode.AdjustIndentation
        if types.InsertTextMode.AdjustIndentation in adjusts
        else None,
        text_edit=types.InsertReplaceEdit(text, inserted, whole)
        if inserted is not None
        else types.TextEdit(whole, text),
        data={"uri": view.document.uri, "kind": item.kind},
    )
