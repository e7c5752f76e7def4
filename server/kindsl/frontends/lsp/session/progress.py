"""Progress of work that takes a while, shown by clients that can."""

import asyncio
import os
import time
import uuid
from collections import deque
from collections.abc import AsyncGenerator, Awaitable, Callable, Sequence
from typing import Any, TypeVar

from lsprotocol import types
from pygls.exceptions import JsonRpcException

from kindsl.frontends.lsp.session.state import State

S = TypeVar("S")
T = TypeVar("T")

# Enough for all processors, and so few that what they take in the message loop holds up no answer.
AT_A_TIME = max(8, 2 * (os.cpu_count() or 1))
_WHOLE = 100
PATIENCE = 0.5


class Progress:
    """`async with Progress(...)` shows a title until the end; says nothing to others.

    With a token of the client's it is shown at once, else when the work has taken half a second
    and the client, which is asked for a token, can show it.
    """

    def __init__(self, state: State, title: str, token: types.ProgressToken | None) -> None:
        self._state = state
        self._title = title
        self._token = token
        self._shown = 0
        self._start = time.monotonic()
        self._may_begin = token is None and state.client.can("window.work_done_progress")

    async def __aenter__(self) -> "Progress":
        self._send(types.WorkDoneProgressBegin(self._title, percentage=0))
        return self

    async def report(self, done: int, total: int) -> None:
        """Tell how much is done of something, when that is a per cent more than told before."""
        if self._may_begin and time.monotonic() - self._start > PATIENCE:
            await self._begin()
        percentage = _WHOLE * done // total
        if percentage > self._shown:
            self._shown = percentage
            self._send(types.WorkDoneProgressReport(percentage=percentage))

    async def over(
        self, items: Sequence[S], work: Callable[[S], Awaitable[T]]
    ) -> AsyncGenerator[T, None]:
        """Yield what work on each item comes to, in order; report how much is done."""
        ahead = deque(map(asyncio.ensure_future, map(work, items[:AT_A_TIME])))
        try:
            for done in range(len(items)):
                await self.report(done, len(items))
                yield await ahead[0]
                ahead.popleft()
                ahead.extend(map(asyncio.ensure_future, map(work, items[done + AT_A_TIME :][:1])))
        finally:
            for each in ahead:
                each.cancel()

    async def __aexit__(self, *_: object) -> None:
        self._send(types.WorkDoneProgressEnd())

    async def _begin(self) -> None:
        self._may_begin = False
        token = str(uuid.uuid4())
        params = types.WorkDoneProgressCreateParams(token)
        try:
            await self._state.editor.window_work_done_progress_create_async(params)
        except JsonRpcException:
            return
        self._token = token
        self._send(types.WorkDoneProgressBegin(self._title, percentage=0))

    def _send(self, value: Any) -> None:
        if self._token is not None:
            self._state.editor.progress(types.ProgressParams(self._token, value))
