"""The command that tells the mechanical changes between two documents."""

from pygls.exceptions import JsonRpcInvalidParams

from kindsl.frontends.lsp.handlers.commands import view_of
from kindsl.frontends.lsp.handlers.table import Handlers
from kindsl.frontends.lsp.session.session import Session
from kindsl.frontends.lsp.session.view import View
from kindsl.frontends.lsp.wire.protocol import RequestFailed

handlers = Handlers()


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
