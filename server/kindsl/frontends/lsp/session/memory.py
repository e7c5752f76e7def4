"""Runs of the garbage collector: seldom while someone types, surely when documents are closed.

A document is many objects that live long: ten thousand links are some millions, and walking through
them in vain takes a good part of a second, in which nothing else runs. So what is there once a
document has been checked is set aside until a document is closed. Edits then leave behind at most
what was set aside, since what they make anew is looked at as ever.
"""

import asyncio
import gc

from kindsl.frontends.lsp.session.worker import Urgency, Worker, start_task
from kindsl.frontends.lsp.text.document import Document
from kindsl.frontends.lsp.text.open_documents import Documents

_THRESHOLDS = (10_000, 10, 3)
LATER = 0.5


def tune() -> None:
    """Let the collector look at young objects less often."""
    gc.set_threshold(*_THRESHOLDS)


def set_aside() -> None:
    """Let the collector pass over everything that is there now."""
    gc.freeze()


def collect_after_close(documents: Documents, worker: Worker) -> None:
    """Collect once some documents have been closed and nothing else is to be done."""
    pending: list[asyncio.Task[None]] = []

    async def collect() -> None:
        await asyncio.sleep(LATER)
        await worker.run(_collect_all, Urgency.BACKGROUND)

    def closed(_: Document) -> None:
        while pending:
            pending.pop().cancel()
        pending.append(start_task(collect()))

    documents.on_close.append(closed)


def _collect_all() -> None:
    gc.unfreeze()
    gc.collect()
    gc.freeze()
