"""The commands of `workspace/executeCommand`."""

import asyncio
from collections.abc import Callable
from typing import Any

from lsprotocol import types
from pygls.exceptions import JsonRpcInvalidParams

from kindsl.frontends.lsp.handlers.table import Handlers
from kindsl.frontends.lsp.session.publishing import STATUS
from kindsl.frontends.lsp.session.session import Session
from kindsl.frontends.lsp.session.view import View
from kindsl.frontends.lsp.wire.client import asked
from kindsl.frontends.lsp.wire.edits import text_edits, workspace_edit
from kindsl.frontends.lsp.wire.protocol import RequestFailed

handlers = Handlers()

_GRAVITY = [0.0, 0.0, -9.81]
_OURS = ("gravity", "forward", "parameters", "configurations")


@handlers.command("kindsl.preview")
async def preview(
    session: Session, uri: object = None, options: object = None, *_: object
) -> dict[str, str]:
    """Show a document, or the only open one, in the live preview; return its page's address.

    An editor that has no panel of its own for it is told the address. The option `origin` names
    the address under which a tunnel or proxy of the editor shows it.
    """
    origin = _own(options, "origin", None)
    url = await session.previews.open(_only_document(session) if uri is None else _uri(uri), origin)
    if url.startswith("http") and not session.client.announces(STATUS):
        session.until_told = asyncio.ensure_future(_tell_address(session, url))
    return {"url": url}


@handlers.command("kindsl.compute")
async def compute(session: Session, uri: object = None, options: object = None, *_: object) -> Any:
    """Return poses, inertia and forces in some configurations."""
    return await _of_document(session, uri, lambda view: _computed(view, options))


@handlers.command("kindsl.applyFixAll")
async def apply_fix_all(session: Session, uri: object = None, *_: object) -> bool:
    """Make every safe fix of a document; return whether there was one and the client made it."""
    edit = await _of_document(session, uri, _all_fixes)
    if edit is None:
        return False
    params = types.ApplyWorkspaceEditParams(edit, label="Apply all safe fixes")
    answer = await asked(session.editor.workspace_apply_edit_async(params))
    return answer is not None and answer.applied


@handlers.command("kindsl.difference")
async def difference(
    session: Session, old: object = None, new: object = None, old_text: object = None, *_: object
) -> dict[str, object]:
    """Return the rows and notes of `kindsl diff` between two open documents.

    The arguments are the addresses of both, and what the old one said if that is not what it says
    now: as in its file, or in an earlier version.
    """
    if not isinstance(old_text, str | None):
        raise JsonRpcInvalidParams("the third argument must be a text, or null")
    views = await view_of(session, old), await view_of(session, new)
    return await session.worker.run(lambda: _difference(*views, old_text))


async def _of_document(session: Session, uri: object, handler: Callable[[View], Any]) -> Any:
    """Ask a handler in the worker: commands may take long."""
    view = await view_of(session, uri)
    return await session.worker.run(lambda: handler(view))


async def view_of(session: Session, uri: object) -> View:
    """Return a document as it is now.

    Raises:
        RequestFailed: There is no such document of the language.
    """
    document = session.documents.get(_uri(uri))
    if document is None or not document.is_robot:
        raise RequestFailed(f"'{uri}' is not a document of the language")
    return await session.view(document)


async def _tell_address(session: Session, url: str) -> None:
    if session.client.can("window.show_document.support"):
        shown = types.ShowDocumentParams(url, external=True)
        answer = await asked(session.editor.window_show_document_async(shown))
        if answer is not None and answer.success:
            return
    message = f"The preview is at {url}"
    session.editor.window_show_message(types.ShowMessageParams(types.MessageType.Info, message))


def _only_document(session: Session) -> str:
    robots = [document.uri for document in session.documents if document.is_robot]
    if len(robots) != 1:
        raise JsonRpcInvalidParams("the first argument must be the URI of a document")
    return robots[0]


def _uri(uri: object) -> str:
    if not isinstance(uri, str):
        raise JsonRpcInvalidParams("the first argument must be the URI of a document")
    return uri


def _all_fixes(view: View) -> types.WorkspaceEdit | None:
    from kindsl.frontends.features.actions.code_actions import fix_all

    edits = text_edits(view.document, fix_all(view.analysis))
    return workspace_edit(view.client, [(view.document, edits)]) if edits else None


def _computed(view: View, options: object) -> dict[str, Any]:
    """Return poses, inertia and forces in some configurations.

    Args:
        view: The document.
        options: None for the zero configuration; a configuration (`q`, `qd`, ...); an array of
            them; or an object with `configurations`. An object may also have `gravity` (three
            numbers), `forward` (compute accelerations from forces) and `parameters` (by name).

    Raises:
        RequestFailed: The options or the document make no sense; says why.
    """
    try:
        from kindsl.products.reports.computation import compute
        from kindsl.products.reports.motions import ConfigurationSpace, motions_from

        mechanism = view.analysis.mechanism(parameters=_own(options, "parameters", {}))
        gravity = _own(options, "gravity", _GRAVITY)
        if not isinstance(gravity, list) or len(gravity) != 3:
            raise ValueError("'gravity' must be three numbers")
        robot = ConfigurationSpace(mechanism.bodies.joint_names, mechanism.bodies.is_floating)
        motions = motions_from(_configurations(options), robot)
        is_forward = bool(_own(options, "forward", False))
        numbers = [float(number) for number in gravity]
        found = compute(view.analysis, mechanism, motions, numbers, is_forward=is_forward)
        return found.as_json()
    except ModuleNotFoundError as error:
        hint = "install with: pip install 'kindsl[numpy]'"
        problem = f"the computation needs {error.name}; {hint}"
        raise RequestFailed(problem, {"missing": ["numpy"]}) from None
    except (ValueError, TypeError) as error:
        raise RequestFailed(str(error)) from None


def _configurations(options: object) -> object:
    if not isinstance(options, dict):
        return {} if options is None else options
    if "configurations" in options:
        return options["configurations"]
    return {key: value for key, value in options.items() if key not in _OURS}


def _own(options: object, name: str, default: Any) -> Any:
    return options.get(name, default) if isinstance(options, dict) else default


def _difference(old: View, new: View, old_text: str | None) -> dict[str, object]:
    from kindsl.judgement.analysis.analysis import analyse
    from kindsl.products.reports.comparison import compared
    from kindsl.products.reports.difference_text import change_rows

    before = old.analysis if old_text is None else analyse(old_text, old.analysis.settings)
    found = compared(before, new.analysis)
    if found.difference is None:
        side = "new" if found.treeless else "old"
        raise RequestFailed(f"the {side} document does not describe a tree of links")
    rows = [row._asdict() for row in change_rows(found.difference)]
    return {"rows": rows, "notes": list(found.notes)}
