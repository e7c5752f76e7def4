"""Fixes and refactorings."""

from pathlib import Path
from typing import TYPE_CHECKING

from lsprotocol import types

from kindsl.frontends.lsp.handlers.table import Handlers
from kindsl.frontends.lsp.session.binding import bound
from kindsl.frontends.lsp.session.companions import TransformsView
from kindsl.frontends.lsp.session.findings import diagnostics
from kindsl.frontends.lsp.session.view import Sight, View
from kindsl.frontends.lsp.text import uris
from kindsl.frontends.lsp.text.document import Document, document
from kindsl.frontends.lsp.wire.edits import text_edits, workspace_edit
from kindsl.language.text.edits import TextEdit

if TYPE_CHECKING:
    from collections.abc import Iterable

    from kindsl.frontends.features.actions.action import CodeAction

handlers = Handlers()

_MARK = "\ufeff"
FIX_ALL = "source.fixAll.kindsl"
_KINDS = types.CodeActionOptions(
    code_action_kinds=[
        types.CodeActionKind.QuickFix,
        types.CodeActionKind.RefactorExtract,
        types.CodeActionKind.RefactorInline,
        types.CodeActionKind.RefactorRewrite,
        types.CodeActionKind.SourceFixAll,
        FIX_ALL,
    ]
)


@handlers.judged(types.TEXT_DOCUMENT_CODE_ACTION, _KINDS)
def offer(view: View, params: types.CodeActionParams) -> list[types.CodeAction]:
    """Offer what can be done about a selection, of the kinds that are asked for."""
    from kindsl.frontends.features.actions.code_actions import code_actions, fix_all_action

    found = [*code_actions(view.analysis, *view.span(params.range)), fix_all_action(view.analysis)]
    return _wanted(view, found, params.context.only)


@handlers.transforms(types.TEXT_DOCUMENT_CODE_ACTION)
def offer_for_transforms(
    view: TransformsView, params: types.CodeActionParams
) -> list[types.CodeAction]:
    """Offer what can be done about a selection in a transforms document."""
    from kindsl.frontends.features.transforms import transforms_actions

    found = transforms_actions(view.document.text, view.model, *view.span(params.range))
    return _wanted(view, found, params.context.only)


@handlers.xml(types.TEXT_DOCUMENT_CODE_ACTION)
def offer_for_xml(view: View, params: types.CodeActionParams) -> list[types.CodeAction]:
    """Offer what can be done about a selection in a robot in XML."""
    from kindsl.frontends.features.actions.code_actions import xml_actions

    found = xml_actions(view.analysis, *view.span(params.range))
    return _wanted(view, found, params.context.only)


def _wanted(
    view: Sight, found: "Iterable[CodeAction | None]", only: object
) -> list[types.CodeAction]:
    kinds = None
    if isinstance(only, list | tuple):
        kinds = tuple(f"{kind}.".lstrip(".") for kind in (getattr(k, "value", k) for k in only))
    wanted = (
        _action(view, each)
        for each in found
        if each and (kinds is None or f"{each.kind}.".startswith(kinds))
    )
    return [action for action in wanted if action is not None]


def _action(view: Sight, action: "CodeAction") -> types.CodeAction | None:
    """Return an action as the client takes it; None if the client cannot make it."""
    edits = [(view.document, text_edits(view.document, action.edits))] if action.edits else []
    new = []
    if action.bindings:
        binding = bound(view.state, view.document, action.bindings)
        if binding is None:
            return None
        edits.append((binding.document, text_edits(binding.document, [binding.edit])))
        new = [binding.document] if binding.is_new else []
    if action.other_file:
        other = _other_file_edits(view, action)
        if other is None:
            return None
        edits.append(other)
    return types.CodeAction(
        title=action.title,
        kind=action.kind,
        diagnostics=[
            view.state.editor.protocol.structured(each, types.Diagnostic)
            for each in diagnostics(
                view.document, action.diagnostics, view.client.shows_in_diagnostics
            )
        ]
        or None,
        is_preferred=action.is_preferred or None,
        edit=workspace_edit(view.client, edits, new),
    )


def _other_file_edits(
    view: Sight, action: "CodeAction"
) -> tuple[Document, list[types.TextEdit]] | None:
    """Return the edits of an action's other file; None if that has changed since it was read."""
    path = Path(action.other_file).absolute()
    try:
        content = path.read_bytes().decode("utf-8")
    except (OSError, UnicodeDecodeError):
        return None
    opened = view.state.documents.get(uris.uri(path))
    plain = content.removeprefix(_MARK)
    found = opened or document(uris.uri(path), None, plain, view.state.documents.encoding)
    # Offsets count a byte order mark, which editors take off.
    off = found.text.startswith(_MARK) - content.startswith(_MARK)
    edits = [e._replace(start=e.start + off, end=e.end + off) for e in action.other_edits]
    if any(found.text[edit.start : edit.end] != edit.old for edit in edits):
        return None
    return found, text_edits(found, [TextEdit(e.start, e.end, e.new) for e in edits])
