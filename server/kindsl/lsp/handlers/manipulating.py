"""What is set by hand in the picture, or by a command, and written into the text."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from lsprotocol import types
from pygls.exceptions import JsonRpcInvalidParams

from kindsl.lsp.handlers.binding import bound
from kindsl.lsp.handlers.commands import view_of
from kindsl.lsp.handlers.table import Handlers
from kindsl.lsp.session.session import Session
from kindsl.lsp.session.view import View
from kindsl.lsp.text.document import Document
from kindsl.lsp.wire.client import asked
from kindsl.lsp.wire.edits import text_edits, workspace_edit

if TYPE_CHECKING:
    from kindsl.features.manipulation.set_component import Change

handlers = Handlers()

_CHANGED = "the document has changed meanwhile"
_NO_FILE = "the configuration file cannot be written"


@handlers.command("kindsl.setComponent")
async def set_component(
    session: Session, uri: object = None, options: object = None, *_: object
) -> dict[str, Any]:
    """Write one number of a joint, an optional frame or a centre of mass, as one undoable edit.

    The options are `kind` (`joint`, `frame`, `com`), `name`, `component` (`x y z rx ry rz`),
    `value` in metres or radians, and `step`, what the value is to be a multiple of, or null.
    """
    from kindsl.features.manipulation.gesture import Refusal
    from kindsl.features.manipulation.set_component import set_component
    from kindsl.features.manipulation.things import Thing

    kind, name, component, value, step = _checked(options)
    view = await view_of(session, uri)
    change = set_component(view.analysis, Thing(kind, name), component, value, step)
    if isinstance(change, Refusal):
        return _answer("", change.reason)
    return await applied(session, view, change, f"Set {component} of {kind} '{name}'")


async def applied(session: Session, view: View, change: "Change", label: str) -> dict[str, Any]:
    """Have the client make a change, as one step of its undo, and return how it went."""
    for name, value in change.preview:
        session.previews.set_parameter(view.document.uri, name, value)
    edits: list[tuple[Document, list[types.TextEdit]]] = []
    if change.edits:
        edits.append((view.document, text_edits(view.document, change.edits)))
    if change.bindings:
        binding = bound(view, change.bindings)
        if binding is None or binding.is_new:
            return _answer("", _NO_FILE)
        edits.append((binding.document, text_edits(binding.document, [binding.edit])))
    if edits and not await _made(session, workspace_edit(session.client, edits), label):
        return _answer("", _CHANGED)
    return _answer(change.text, "")


async def _made(session: Session, edit: types.WorkspaceEdit, label: str) -> bool:
    params = types.ApplyWorkspaceEditParams(edit, label=label)
    answer = await asked(session.editor.workspace_apply_edit_async(params))
    return answer is not None and answer.applied


def _answer(text: str, reason: str) -> dict[str, Any]:
    return {"applied": not reason, "text": text, "reason": reason or None}


def _checked(options: object) -> tuple[str, str, str, float, float | None]:
    """Return kind, name, component, value and step.

    Raises:
        JsonRpcInvalidParams: One is missing or of another type.
    """
    given = options if isinstance(options, Mapping) else getattr(options, "__dict__", {})
    words = tuple(given.get(key) for key in ("kind", "name", "component"))
    value, step = given.get("value"), given.get("step")
    if not all(isinstance(word, str) for word in words):
        raise JsonRpcInvalidParams("'kind', 'name' and 'component' must be texts")
    if isinstance(value, bool) or not isinstance(value, int | float) or not _is_step(step):
        raise JsonRpcInvalidParams("'value' must be a number, 'step' a number or null")
    kind, name, component = map(str, words)
    snap = None if step is None else float(step)
    return kind, name, component, float(value), snap


def _is_step(step: object) -> bool:
    return step is None or (isinstance(step, int | float) and not isinstance(step, bool))
