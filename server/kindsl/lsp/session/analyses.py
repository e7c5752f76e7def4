"""The analysis of each version of a document: made once, in the worker, while someone waits."""

import asyncio
import logging
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Generic, TypeVar, cast

from kindsl.lsp.session.worker import Urgency, Worker
from kindsl.lsp.session.workspace import Workspace
from kindsl.lsp.text.document import Document
from kindsl.text.facts import Fact

if TYPE_CHECKING:
    from kindsl.analysis.analysis import Analysis
    from kindsl.analysis.diagnostics import Diagnostic
    from kindsl.analysis.settings import Settings

logger = logging.getLogger(__name__)

T = TypeVar("T")
_FINDINGS = "findings"
_JOBS: "Fact[tuple[Settings, dict[str, _SharedJob[Any]]]]" = Fact("jobs")


class Analyses:
    """The analyses of each version, shared by all who ask for them.

    Cancelling all who wait for something leaves it out, or ends it soon if it has begun.
    """

    __slots__ = ("_worker", "_workspace")

    def __init__(self, worker: Worker, workspace: Workspace) -> None:
        self._worker = worker
        self._workspace = workspace

    async def of(self, document: Document) -> "Analysis":
        """Return the analysis of a version under the present settings, its model made."""
        settings = await self.settings(document)
        jobs = _jobs(document, settings)
        return await self._shared(jobs, "model", lambda: _model(document, settings), Urgency.ANSWER)

    async def settings(self, document: Document) -> "Settings":
        """Return the decisions for a document; files are read in the worker."""
        known = self._workspace.known_settings(document)
        if known is not None:
            return known
        return await self._worker.run(lambda: self._workspace.read_settings(document))

    async def findings(
        self, document: Document, urgency: Urgency = Urgency.ANSWER
    ) -> "tuple[Diagnostic, ...]":
        """Return what is wrong with a version; twins are read when all else is known."""
        analysis = await self.of(document)
        jobs = _jobs(document, analysis.settings)
        if analysis.settings.twins:
            await self.findings_without_twins(document, urgency)
            urgency = Urgency.BACKGROUND
        return await self._shared(jobs, _FINDINGS, lambda: self._check(analysis), urgency)

    async def findings_without_twins(
        self, document: Document, urgency: Urgency = Urgency.ANSWER
    ) -> "tuple[Diagnostic, ...]":
        """Return all findings if they are known or there are no twins, else those of the text."""
        analysis = await self.of(document)
        jobs = _jobs(document, analysis.settings)
        known = jobs.get(_FINDINGS)
        if not analysis.settings.twins or (known is not None and known.future.done()):
            return await self._shared(jobs, _FINDINGS, lambda: self._check(analysis), urgency)

        def check() -> "tuple[Diagnostic, ...]":
            return analysis.check_without_twins(self._worker.checkpoint)

        return await self._shared(jobs, "findings without twins", check, urgency)

    def _check(self, analysis: "Analysis") -> "tuple[Diagnostic, ...]":
        """Return the findings as long as somebody waits; rules that failed are logged."""
        findings = analysis.check(self._worker.checkpoint)
        for fault in analysis.faults:
            logger.error("a rule failed: %s", fault.message, exc_info=fault.error)
        return findings

    async def _shared(
        self, jobs: "dict[str, _SharedJob[Any]]", name: str, work: Callable[[], T], urgency: Urgency
    ) -> T:
        """Await a job that others may wait for, too."""
        job = jobs.get(name)
        if job is None:
            job = jobs[name] = _SharedJob(asyncio.ensure_future(self._worker.run(work, urgency)))
        elif job.future.done():
            return cast(T, job.future.result())
        job.waiters += 1
        try:
            return cast(T, await asyncio.shield(job.future))
        finally:
            job.waiters -= 1
            if not job.waiters and not job.future.done():
                job.future.cancel()
                jobs.pop(name, None)


class _SharedJob(Generic[T]):
    """Work under way, and how many wait for it."""

    __slots__ = ("future", "waiters")

    def __init__(self, future: "asyncio.Future[T]") -> None:
        self.future = future
        self.waiters = 0


def _jobs(document: Document, settings: "Settings") -> "dict[str, _SharedJob[Any]]":
    """Return what has been asked of a version under these settings; other settings start anew."""
    known = document.facts.get(_JOBS)
    if known is None or known[0] != settings:
        known = document.facts.keep(_JOBS, (settings, {}))
    return known[1]


def _model(document: Document, settings: "Settings") -> "Analysis":
    from kindsl.analysis.analysis import Analysis

    analysis = Analysis(document.tree, settings)
    analysis.model  # noqa: B018
    return analysis
