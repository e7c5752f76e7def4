"""Changes by hand outside the text, written into it: one labelled step of undo."""

from collections.abc import Sequence

from lsprotocol import types

from kindsl.frontends.lsp.session.binding import bound
from kindsl.frontends.lsp.session.state import State
from kindsl.frontends.lsp.session.view import View
from kindsl.frontends.lsp.text.document import Document
from kindsl.frontends.lsp.wire.client import asked
from kindsl.frontends.lsp.wire.edits import text_edits, workspace_edit
from kindsl.language.text.edits import TextEdit

_CHANGED = "the document has changed in the meantime"
_NO_FILE = "the configuration file cannot be written"


async def written(
    state: State,
    view: View,
    label: str,
    edits: Sequence[TextEdit],
    bindings: Sequence[tuple[str, float]] = (),
) -> str:
    """Have the client make edits of the version that a view shows.

    Args:
        state: The session.
        view: The document as it was seen.
        label: Title of the edits, in the imperative.
        edits: Of the document.
        bindings: Values of parameters for the configuration file.

    Returns:
        Why nothing was written, or an empty text.
    """
    made: list[tuple[Document, list[types.TextEdit]]] = []
    if edits:
        made.append((view.document, text_edits(view.document, edits)))
    if bindings:
        binding = bound(view.state, view.document, bindings)
        if binding is None or binding.is_new:
            return _NO_FILE
        made.append((binding.document, text_edits(binding.document, [binding.edit])))
    if not made:
        return ""
    params = types.ApplyWorkspaceEditParams(workspace_edit(state.client, made), label=label)
    answer = await asked(state.editor.workspace_apply_edit_async(params))
    return "" if answer is not None and answer.applied else _CHANGED
