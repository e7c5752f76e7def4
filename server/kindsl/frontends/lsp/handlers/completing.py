"""Completion: what may be typed, and the text beside the list for one item."""

from typing import TYPE_CHECKING, Any, NamedTuple

from lsprotocol import types

from kindsl.frontends.lsp.handlers.table import Handlers
from kindsl.frontends.lsp.session.companions import TransformsView
from kindsl.frontends.lsp.session.session import Session
from kindsl.frontends.lsp.session.view import Sight, View, without_marks
from kindsl.language.text.facts import Fact

if TYPE_CHECKING:
    from kindsl.frontends.features.completion.completion import Completions
    from kindsl.frontends.features.completion.item import CompletionItem

handlers = Handlers()

_OPTIONS = types.CompletionOptions(trigger_characters=[" ", "(", "<", "^"], resolve_provider=True)
_KINDS = {
    "keyword": types.CompletionItemKind.Keyword.value,
    "snippet": types.CompletionItemKind.Snippet.value,
    "link": types.CompletionItemKind.Class.value,
    "joint": types.CompletionItemKind.Method.value,
    "frame": types.CompletionItemKind.Property.value,
    "parameter": types.CompletionItemKind.Variable.value,
    "constant": types.CompletionItemKind.Constant.value,
    "value": types.CompletionItemKind.Value.value,
}
_LIST = Fact[bool]("a list of completions was shown")
_KIND = types.CompletionTriggerKind
_NEVER_TYPED = " "
_ITEM = "text_document.completion.completion_item"


@handlers.place(types.TEXT_DOCUMENT_COMPLETION, _OPTIONS)
def complete(view: View, params: types.CompletionParams) -> dict[str, Any]:
    """Offer what may be typed, the best first; in the protocol's form, which is asked for often."""
    found = _found(view, view.offset(params.position), params.context)
    return _list(view, found, params.position)


@handlers.transforms(types.TEXT_DOCUMENT_COMPLETION)
def complete_transforms(view: TransformsView, params: types.CompletionParams) -> dict[str, Any]:
    """Offer what may be typed in a transforms document."""
    from kindsl.frontends.features.transforms import transforms_completions

    offset = view.offset(params.position)
    found = transforms_completions(view.document.text, offset, view.model)
    is_typed = params.context is not None and params.context.trigger_kind is _KIND.TriggerCharacter
    return _list(view, found._replace(items=()) if is_typed else found, params.position)


def _list(view: Sight, found: "Completions", position: types.Position) -> dict[str, Any]:
    form = _form(view, found, position)
    items = [_item(item, number, form) for number, item in enumerate(found.items)]
    return {"isIncomplete": bool(items), "items": items}


@handlers.session(types.COMPLETION_ITEM_RESOLVE)
async def resolve(session: Session, item: types.CompletionItem) -> Any:
    """Add the text beside the list, none where the document was closed meanwhile."""
    data = item.data if isinstance(item.data, dict) else {}
    found = await session.ask(_with_documentation, str(data.get("uri", "")), item)
    return item if found is None else found


def _found(view: View, offset: int, context: types.CompletionContext | None) -> "Completions":
    """Return everything that fits to a user who asks, less to an editor that asks by itself."""
    from kindsl.frontends.features.completion.completion import completions, narrowed, suggestions

    kind = _KIND.Invoked if context is None else context.trigger_kind
    is_unasked = _comes_by_itself(view, offset)
    if kind is _KIND.Invoked and not is_unasked:
        found = completions(view.analysis, offset)
        view.state.asked_list = (view.document.uri, found.start)
        return found
    if kind is _KIND.TriggerForIncompleteCompletions:
        found = narrowed(view.analysis, offset)
        if (view.document.uri, found.start) == view.state.asked_list:
            return found
    view.state.asked_list = None
    return suggestions(view.analysis, offset)


def _comes_by_itself(view: View, offset: int) -> bool:
    """Return whether a list is the first one for a word that was just typed.

    The protocol does not tell it from one that the user asks for. Who wants to see more than comes
    by itself asks once more.
    """
    document, is_first = view.document, view.document.facts.get(_LIST) is None
    document.facts.keep(_LIST, True)
    touched, before = document.touched, document.lines.text(max(offset - 1, 0), offset)
    is_typed = touched is not None and touched.start <= offset <= touched.end
    return is_first and is_typed and (before.isalnum() or before == "_")


def _with_documentation(view: View, item: types.CompletionItem) -> types.CompletionItem:
    from kindsl.frontends.features.completion.completion import documentation

    data = item.data if isinstance(item.data, dict) else {}
    text = documentation(view.analysis, str(data.get("kind", "")), item.label)
    if text is not None:
        formats = f"{_ITEM}.documentation_format"
        is_told = bool(view.client.values(formats))
        item.documentation = view.markup(text, formats) if is_told else without_marks(text)
    return item


class _Form(NamedTuple):
    """The properties that all items of an answer share.

    Attributes:
        uri: The document.
        place: The parts of a text edit but for the text: the word to replace, and for a client
            that can choose also the part of it before the cursor.
        has_snippets: Whether the client knows placeholders.
        mode: How it is to indent further lines, if it can be told.
    """

    uri: str
    place: dict[str, Any]
    has_snippets: bool
    mode: dict[str, int]


def _form(view: Sight, found: "Completions", position: types.Position) -> _Form:
    ranges = view.document.wire_range
    place = {"range": ranges(found.start, found.end)}
    if view.client.can(f"{_ITEM}.insert_replace_support"):
        before_cursor = ranges(found.start, view.offset(position))
        place = {"insert": before_cursor, "replace": place["range"]}
    adjusts = types.InsertTextMode.AdjustIndentation
    modes = view.client.values(f"{_ITEM}.insert_text_mode_support.value_set")
    return _Form(
        view.document.uri,
        place,
        view.client.can(f"{_ITEM}.snippet_support"),
        {"insertTextMode": adjusts.value} if adjusts in modes else {},
    )


def _item(item: "CompletionItem", number: int, form: _Form) -> dict[str, Any]:
    is_snippet = item.is_snippet and form.has_snippets
    format_ = types.InsertTextFormat.Snippet if is_snippet else types.InsertTextFormat.PlainText
    # Digits that are typed are never taken for the beginning of another number.
    filter_ = {"filterText": _NEVER_TYPED} if item.label[:1].isdigit() else {}
    return {
        "label": item.label,
        "kind": _KINDS[item.kind],
        "detail": item.detail,
        "sortText": f"{number:04}",
        "insertTextFormat": format_.value,
        "textEdit": {"newText": item.text if is_snippet else item.plain_text, **form.place},
        "data": {"uri": form.uri, "kind": item.kind},
        **form.mode,
        **filter_,
    }
