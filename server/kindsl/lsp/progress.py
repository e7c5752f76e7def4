"""Progress of work that takes a while, shown by clients that can."""

import uuid
from typing import TYPE_CHECKING, Any

from lsprotocol import types
from pygls.exceptions import JsonRpcException

if TYPE_CHECKING:
    from kindsl.lsp.server import KindslLanguageServer

_REPORTS = 100


class Progress:
    """`async with Progress(...)` shows a title until the end; says nothing to others.

    Args:
        server: Whom the client talks to.
        title: What is being done.
        token: The client's, if it gave one; else one is asked for, if the client can show it.
    """

    def __init__(
        self, server: "KindslLanguageServer", title: str, token: types.ProgressToken | None
    ) -> None:
        self._server = server
        self._title = title
        self._token = token
        self._shown = -1

    async def __aenter__(self) -> "Progress":
        if self._token is None and self._server.client.can("window.work_done_progress"):
            self._token = await self._created(str(uuid.uuid4()))
        self._send(types.WorkDoneProgressBegin(self._title, percentage=0))
        return self

    async def _created(self, token: str) -> str | None:
        params = types.WorkDoneProgressCreateParams(token)
        try:
            await self._server.window_work_done_progress_create_async(params)
        except JsonRpcException:
            return None
        return token

    def report(self, done: int, total: int) -> None:
        """Tell how much is done, when that is a per cent more than told before."""
        percentage = _REPORTS * done // max(total, 1)
        if percentage > self._shown:
            self._shown = percentage
            self._send(types.WorkDoneProgressReport(percentage=min(percentage, _REPORTS)))

    async def __aexit__(self, *_: object) -> None:
        self._send(types.WorkDoneProgressEnd())

    def _send(self, value: Any) -> None:
        if self._token is not None:
            self._server.progress(types.ProgressParams(self._token, value))
