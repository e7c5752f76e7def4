"""The analysis of each version of a document: made once, in the worker, while someone waits."""

import asyncio
import logging
from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING, Any, Generic, TypeVar, cast

from kindsl.frontends.lsp.session.worker import Job, Urgency, Worker
from kindsl.frontends.lsp.session.workspace import Workspace
from kindsl.frontends.lsp.text.document import Document
from kindsl.language.text.facts import Fact

if TYPE_CHECKING:
    from kindsl.judgement.analysis.analysis import Analysis
    from kindsl.judgement.analysis.diagnostics import Diagnostic
    from kindsl.judgement.analysis.settings import Settings

logger = logging.getLogger(__name__)

T = TypeVar("T")
_FINDINGS = "findings"
_JOBS: "Fact[tuple[object, dict[str, _SharedJob[Any]]]]" = Fact("jobs")
_ANALYSIS: "Fact[tuple[object, Analysis]]" = Fact("analysis")


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
        known = document.facts.get(_ANALYSIS)
        if known is not None and known[0] == settings:
            return known[1]
        jobs = _jobs(document, settings)
        make = partial(_analysis, document, settings)
        return await self._shared(jobs, "analysis", make, Urgency.ANSWER)

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
        settings = await self.settings(document)
        if settings.twins:
            await self.findings_without_twins(document, urgency)
            urgency = Urgency.BACKGROUND
        return await self._all_findings(document, settings, urgency)

    async def findings_without_twins(
        self, document: Document, urgency: Urgency = Urgency.ANSWER
    ) -> "tuple[Diagnostic, ...]":
        """Return all findings if they are known or there are no twins, else those of the text."""
        settings = await self.settings(document)
        jobs = _jobs(document, settings)
        known = jobs.get(_FINDINGS)
        if not settings.twins or (known is not None and known.future.done()):
            return await self._all_findings(document, settings, urgency)

        def check() -> "tuple[Diagnostic, ...]":
            return _analysis(document, settings).check_without_twins(self._worker.checkpoint)

        return await self._shared(jobs, "findings without twins", check, urgency)

    async def _all_findings(
        self, document: Document, settings: "Settings", urgency: Urgency
    ) -> "tuple[Diagnostic, ...]":
        check = partial(self._check, document, settings)
        return await self._shared(_jobs(document, settings), _FINDINGS, check, urgency)

    def _check(self, document: Document, settings: "Settings") -> "tuple[Diagnostic, ...]":
        """Return the findings as long as somebody waits; rules that failed are logged."""
        analysis = _analysis(document, settings)
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
            job = jobs[name] = _SharedJob(self._worker.submit(work, urgency))
        elif job.future.done():
            return cast(T, job.future.result())
        job.waiters += 1
        try:
            return cast(T, await asyncio.shield(job.future))
        finally:
            job.waiters -= 1
            if not job.waiters and not job.future.done():
                job.abandon()
                jobs.pop(name, None)


class _SharedJob(Generic[T]):
    """Work under way, and how many wait for it."""

    __slots__ = ("_job", "future", "waiters")

    def __init__(self, job: Job[T]) -> None:
        self._job = job
        self.future = asyncio.wrap_future(job.future)
        self.waiters = 0

    def abandon(self) -> None:
        """Leave it out, or end it at its next checkpoint."""
        self._job.is_abandoned = True
        self.future.cancel()


def _jobs(document: Document, settings: "Settings") -> "dict[str, _SharedJob[Any]]":
    """Return what has been asked of a version under these settings; other settings start anew."""
    return document.facts.made_of(_JOBS, settings, dict)


def _analysis(document: Document, settings: "Settings") -> "Analysis":
    """Return the analysis of a version, its model made; only jobs make one."""
    from kindsl.judgement.analysis.analysis import Analysis

    def made() -> Analysis:
        analysis = Analysis(document.tree, settings)
        analysis.model  # noqa: B018
        return analysis

    return document.facts.made_of(_ANALYSIS, settings, made)
