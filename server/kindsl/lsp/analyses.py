"""The analysis of each version of a document: made once, in the worker, while someone waits."""

import asyncio
from typing import TYPE_CHECKING

from kindsl.lsp import uris
from kindsl.lsp.document import Document
from kindsl.lsp.worker import Worker

if TYPE_CHECKING:
    from kindsl.rules.analysis import Analysis


class Analyses:
    """What is known about each version, shared by all who ask for it."""

    __slots__ = ("_worker",)

    def __init__(self, worker: Worker) -> None:
        self._worker = worker

    async def of(self, document: Document) -> "Analysis":
        """Return the analysis of a version; several who ask share one.

        Cancelling all who wait leaves it out, if it has not begun.
        """
        job = document.facts.get(_Job)
        if not isinstance(job, _Job):
            job = document.facts[_Job] = _Job(self._start(document))
        job.waiters += 1
        try:
            return await asyncio.shield(job.future)
        finally:
            job.waiters -= 1
            if not job.waiters and not job.future.done():
                job.future.cancel()
                document.facts.pop(_Job, None)

    def _start(self, document: Document) -> "asyncio.Future[Analysis]":
        return asyncio.ensure_future(self._worker.run(lambda: _analyse(document)))


class _Job:
    """An analysis under way, and how many wait for it."""

    __slots__ = ("future", "waiters")

    def __init__(self, future: "asyncio.Future[Analysis]") -> None:
        self.future = future
        self.waiters = 0


def _analyse(document: Document) -> "Analysis":
    raise NotImplementedError(uris.key(document.uri))
