"""Values set by hand in the picture, or by a command, and written into the text."""

from collections.abc import Mapping
from typing import Any

from pygls.exceptions import JsonRpcInvalidParams

from kindsl.frontends.lsp.handlers.commands import view_of
from kindsl.frontends.lsp.handlers.table import Handlers
from kindsl.frontends.lsp.session.binding import request_edits
from kindsl.frontends.lsp.session.session import Session

handlers = Handlers()


@handlers.command("kindsl.setComponent")
async def set_component(
    session: Session, uri: object = None, options: object = None, *_: object
) -> dict[str, Any]:
    """Write one number of a joint, an optional frame or a centre of mass, as one undoable edit.

    The options are `kind` (`joint`, `frame`, `com`), `name`, `component` (`x y z rx ry rz`),
    `value` in metres or radians, and `step`, what the value is to be a multiple of, or null.
    """
    from kindsl.frontends.features.manipulation.gesture import Refusal
    from kindsl.frontends.features.manipulation.set_component import set_component
    from kindsl.frontends.features.manipulation.things import Thing

    kind, name, component, value, step = _checked(options)
    view = await view_of(session, uri)
    change = set_component(view.analysis, Thing(kind, name), component, value, step)
    if isinstance(change, Refusal):
        return _answer("", change.reason)
    for parameter, shown in change.preview:
        session.previews.set_parameter(view.document.uri, parameter, shown)
    reason = await request_edits(view, change.label, change.edits, change.bindings)
    return _answer("" if reason else change.text, reason)


def _answer(text: str, reason: str) -> dict[str, Any]:
    return {"applied": not reason, "text": text, "reason": reason or None}


def _checked(options: object) -> tuple[str, str, str, float, float | None]:
    """Return kind, name, component, value and step.

    Raises:
        JsonRpcInvalidParams: One is missing or of another type.
    """
    given = options if isinstance(options, Mapping) else {}
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
