"""When the garbage collector runs: seldom while someone types, surely when documents are closed."""

import asyncio
import gc

from kindsl.lsp import tasks
from kindsl.lsp.document import Document
from kindsl.lsp.documents import Documents
from kindsl.lsp.worker import Urgency, Worker

# A document is many objects that live long; looking at the young ones every 700 finds nothing.
# What islands know refers back to them, so what an edit leaves behind does need the collector.
_THRESHOLDS = (10_000, 10, 3)
_LATER = 0.5


def tune() -> None:
    """Let the collector look at young objects less often."""
    gc.set_threshold(*_THRESHOLDS)


def collect_after_close(documents: Documents, worker: Worker) -> None:
    """Collect once some documents have been closed and nothing else is to be done."""
    pending: list[asyncio.Task[None]] = []

    async def collect() -> None:
        await asyncio.sleep(_LATER)
        await worker.run(gc.collect, Urgency.BACKGROUND)

    def closed(_: Document) -> None:
        while pending:
            pending.pop().cancel()
        pending.append(tasks.start(collect()))

    documents.on_close.append(closed)
