"""Notices configuration files that change unseen by the client.

Many clients watch no files. Others watch those below their folders only, and hear nothing of the
files in a folder that is deleted as a whole.
"""

import asyncio
from collections.abc import Callable

from kindsl.frontends.lsp.session.publishing import Publisher
from kindsl.frontends.lsp.session.state import State
from kindsl.frontends.lsp.session.worker import Urgency

_INTERVAL = 1.0  # seconds


async def watch_disk(state: State, publisher: Publisher, on_change: Callable[[], None]) -> None:
    """Look again and again at the files that decide for documents, until cancelled.

    Args:
        state: State of the session.
        publisher: Tells what is wrong with files that were broken when it last looked.
        on_change: Called when one of the files has appeared, changed or gone.
    """
    while True:
        await asyncio.sleep(_INTERVAL)
        if await state.worker.run(state.workspace.is_outdated, Urgency.BACKGROUND):
            state.workspace.forget()
            on_change()
        else:
            await publisher.look_at_broken_files()
