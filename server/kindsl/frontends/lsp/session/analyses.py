"""The analysis of each version of a document: made once, in the worker, while someone waits."""

import asyncio
import logging
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Generic, NamedTuple, TypeVar, cast

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

    async def version(self, document: Document) -> "Version":
        """Return a version under the present settings, which are read in the worker."""
        settings = self._workspace.known_settings(document)
        if settings is None:
            settings = await self._worker.run(lambda: self._workspace.read_settings(document))
        return Version(document, settings, self._worker)

    async def of(self, document: Document) -> "Analysis":
        """Return the analysis of a version under the present settings, its model made."""
        return await (await self.version(document)).analysis()


class Version(NamedTuple):
    """One version of a document under the settings that hold for it."""

    document: Document
    settings: "Settings"
    worker: Worker

    async def analysis(self) -> "Analysis":
        """Return the analysis, its model made."""
        known = self.document.facts.get(_ANALYSIS)
        if known is not None and known[0] == self.settings:
            return known[1]
        return await self._shared("analysis", self._made, Urgency.ANSWER)

    async def shown(self) -> "Analysis":
        """Return the analysis to draw and compute: of XML the document that it would become.

        Raises:
            UnreadableRobotError: It is XML without a robot that can be shown.
        """
        if not self.document.is_xml:
            return await self.analysis()
        return await self._shared("translation", self._translated, Urgency.ANSWER)

    def _translated(self) -> "Analysis":
        from kindsl.judgement.analysis.translated_robot import analysed_robot

        return analysed_robot(self.document.uri, self.document.text, self.settings)

    async def findings(self, urgency: Urgency = Urgency.ANSWER) -> "tuple[Diagnostic, ...]":
        """Return what is wrong; twins are read when all else is known."""
        if self.settings.twins:
            await self.findings_without_twins(urgency)
            urgency = Urgency.BACKGROUND
        return await self._shared(_FINDINGS, self._checked, urgency)

    async def findings_without_twins(self, urgency: Urgency) -> "tuple[Diagnostic, ...]":
        """Return all findings if they are known or there are no twins, else those of the text."""
        known = self._jobs.get(_FINDINGS)
        if not self.settings.twins or (known is not None and known.future.done()):
            return await self._shared(_FINDINGS, self._checked, urgency)
        check = lambda: self._made().check_without_twins(self.worker.checkpoint)  # noqa: E731
        return await self._shared("findings without twins", check, urgency)

    @property
    def _jobs(self) -> "dict[str, _SharedJob[Any]]":
        return self.document.facts.made_of(_JOBS, self.settings, dict)

    def _made(self) -> "Analysis":
        """Return the analysis of a version, its model made; only jobs make one."""
        from kindsl.judgement.analysis.analysis import Analysis

        def made() -> Analysis:
            analysis = Analysis(self.document.tree, self.settings)
            analysis.model  # noqa: B018
            return analysis

        return self.document.facts.made_of(_ANALYSIS, self.settings, made)

    def _checked(self) -> "tuple[Diagnostic, ...]":
        """Return the findings as long as somebody waits; rules that failed are logged."""
        analysis = self._made()
        findings = analysis.check(self.worker.checkpoint)
        for fault in analysis.faults:
            logger.error("a rule failed: %s", fault.message, exc_info=fault.error)
        return findings

    async def _shared(self, name: str, work: Callable[[], T], urgency: Urgency) -> T:
        jobs = self._jobs
        job = jobs.get(name)
        if job is None:
            job = jobs[name] = _SharedJob(self.worker.submit(work, urgency))
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
