"""Texts of other formats as they are pasted, by a command."""

from typing import cast

from lsprotocol import types
from pygls.exceptions import JsonRpcInvalidParams

from kindsl.frontends.lsp.handlers.commands import view_of
from kindsl.frontends.lsp.handlers.table import Handlers
from kindsl.frontends.lsp.session.session import Session
from kindsl.frontends.lsp.session.view import View
from kindsl.frontends.lsp.wire.edits import text_edits

handlers = Handlers()


@handlers.command("kindsl.paste")
async def paste(
    session: Session, uri: object = None, at: object = None, text: object = None, *_: object
) -> list[dict[str, object]]:
    """Return how a text may be pasted: titles, edits, and whether each is the only way.

    The arguments are the document's address, the range that is replaced, and the text. The list is
    empty for a text that is pasted as it is.
    """
    place = _range(session, at)
    if place is None or not isinstance(text, str):
        raise JsonRpcInvalidParams("the arguments must be an address, a range and a text")
    view = await view_of(session, uri)
    return await session.worker.run(lambda: _ways(view, place, text))


def _range(session: Session, at: object) -> types.Range | None:
    """Return what is in the form of a range, None for anything else."""
    try:
        return session.editor.protocol.structured(cast("dict[str, object]", at), types.Range)
    except (TypeError, KeyError, ValueError, ExceptionGroup):
        return None


def _ways(view: View, at: types.Range, text: str) -> list[dict[str, object]]:
    from kindsl.frontends.features.pasting import pastings

    start, end = view.offset(at.start), view.offset(at.end)
    return [
        {
            "title": way.title,
            "edits": text_edits(view.document, way.edits),
            "isCertain": way.is_certain,
        }
        for way in pastings(view.analysis, start, end, text)
    ]
