"""The analysis of a version is made once, for all who ask, and not when nobody asks any more."""

import asyncio
import gc
import threading
import weakref
from collections.abc import Callable, Iterator

import pytest
from lsprotocol import types

from kindsl.frontends.lsp.session.analyses import Analyses
from kindsl.frontends.lsp.session.worker import Urgency, Worker
from kindsl.frontends.lsp.session.workspace import Workspace
from kindsl.frontends.lsp.text.document import Document, document
from kindsl.judgement.analysis import analysis
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.rules.base import Finding, Rule, Severity
from kindsl.judgement.rules.registry import checking_rules
from kindsl.language.semantics.aspects import Aspect

TEXT = "Robot R {\nRobotBase base { children { one via first } }\n}\n"


@pytest.fixture
def worker() -> Worker:
    return Worker()


@pytest.fixture
def workspace() -> Workspace:
    return Workspace()


@pytest.fixture
def analyses(worker: Worker, workspace: Workspace) -> Analyses:
    return Analyses(worker, workspace)


async def findings_of(analyses: Analyses, shown: Document) -> tuple[Diagnostic, ...]:
    return await (await analyses.version(shown)).findings()


async def test_all_who_ask_share_one_analysis(analyses: Analyses) -> None:
    shown = document("untitled:r", 1, TEXT, "utf-16")
    one, other = await asyncio.gather(analyses.of(shown), analyses.of(shown))
    assert one is other
    findings = await findings_of(analyses, shown)
    assert [found.code for found in findings] == ["KD008"]
    assert await findings_of(analyses, shown) is findings
    assert await analyses.of(shown) is one


async def test_what_is_known_is_no_job_again(
    analyses: Analyses, monkeypatch: pytest.MonkeyPatch
) -> None:
    shown = document("untitled:r", 1, TEXT, "utf-16")
    findings = await findings_of(analyses, shown)
    monkeypatch.setattr(Worker, "submit", None)
    assert await findings_of(analyses, shown) is findings


async def test_other_settings_make_another_analysis(
    analyses: Analyses, workspace: Workspace
) -> None:
    shown = document("untitled:r", 1, TEXT, "utf-16")
    before = await analyses.of(shown)
    workspace.set_editor_settings({"ignore": ["KD1"]})
    after = await analyses.of(shown)
    assert after is not before
    assert after.settings.ignore == ("KD1",)
    assert after.syntax is before.syntax


async def test_a_cancelled_waiter_leaves_the_analysis_to_the_others(
    analyses: Analyses, worker: Worker
) -> None:
    shown = document("untitled:r", 1, TEXT, "utf-16")
    await analyses.of(document("untitled:r", 0, "", "utf-16"))
    release = busy(worker)
    first = asyncio.ensure_future(analyses.of(shown))
    second = asyncio.ensure_future(analyses.of(shown))
    await asyncio.sleep(0.01)
    first.cancel()
    with pytest.raises(asyncio.CancelledError):
        await first
    release()
    assert (await second).syntax.text == TEXT


async def test_what_a_check_has_made_is_there_while_the_worker_is_busy(
    analyses: Analyses, worker: Worker
) -> None:
    shown = document("untitled:r", 1, TEXT, "utf-16")
    await findings_of(analyses, shown)
    release = busy(worker)
    try:
        known = await asyncio.wait_for(analyses.of(shown), 20)
    finally:
        release()
    assert known.syntax.text == TEXT


async def test_what_nobody_waits_for_any_more_is_not_begun(
    analyses: Analyses, worker: Worker
) -> None:
    shown = document("untitled:r", 1, TEXT, "utf-16")
    await analyses.of(document("untitled:r", 0, "", "utf-16"))
    release = busy(worker)
    waiting = asyncio.ensure_future(analyses.of(shown))
    await asyncio.sleep(0.01)
    waiting.cancel()
    with pytest.raises(asyncio.CancelledError):
        await waiting
    release()
    await worker.run(lambda: None, Urgency.BACKGROUND)
    assert shown._tree is None
    assert (await analyses.of(shown)).syntax.text == TEXT


async def test_answers_go_before_diagnostics_and_those_before_the_rest(worker: Worker) -> None:
    done: list[str] = []
    release = busy(worker)
    urgencies = {
        "the rest": Urgency.BACKGROUND, "diagnostics": Urgency.DIAGNOSTICS,
        "answer": Urgency.ANSWER,
    }  # fmt: skip
    jobs = [
        asyncio.ensure_future(worker.run(lambda name=name: done.append(name), urgency))
        for name, urgency in urgencies.items()
    ]
    await asyncio.sleep(0)
    release()
    await asyncio.gather(*jobs)
    assert done == ["answer", "diagnostics", "the rest"]


async def test_a_job_under_way_ends_when_nobody_waits_any_more(worker: Worker) -> None:
    begun, ended = threading.Event(), []

    def endless() -> None:
        begun.set()
        try:
            while True:
                worker.checkpoint()
        finally:
            ended.append(True)

    waiting = asyncio.ensure_future(worker.run(endless))
    await asyncio.to_thread(begun.wait)
    waiting.cancel()
    assert await worker.run(lambda: 3) == 3
    assert ended == [True]


async def test_findings_under_way_are_abandoned_and_those_that_are_left_made_later(
    analyses: Analyses, worker: Worker, monkeypatch: pytest.MonkeyPatch
) -> None:
    shown = document("untitled:r", 1, TEXT, "utf-16")
    begun, gate, ended = threading.Event(), threading.Event(), []

    def slow(*_: object) -> Iterator[Finding]:
        begun.set()
        gate.wait()
        ended.append(True)
        yield from ()

    reads = Aspect.STRUCTURE
    rule = Rule("kd999_slow", Severity.ERROR, check_document=slow, reads=reads)
    later = Rule("kd999_later", Severity.ERROR, check_document=slow)
    monkeypatch.setattr(analysis, "checking_rules", lambda: (rule, later))
    monkeypatch.setattr(analysis, "running_rules", analysis.running_rules.__wrapped__)
    waiting = asyncio.ensure_future(findings_of(analyses, shown))
    await asyncio.to_thread(begun.wait)
    waiting.cancel()
    with pytest.raises(asyncio.CancelledError):
        await waiting
    await asyncio.sleep(0)
    gate.set()
    await worker.run(lambda: None)
    assert ended == [True]
    assert [each.code for each in await findings_of(analyses, shown)] == ["KD008"]
    assert ended == [True] * 2  # What the first one found had been kept.


async def test_a_rule_that_fails_is_logged(
    analyses: Analyses, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    def failing(*_: object) -> Iterator[Finding]:
        raise KeyError("oh")
        yield

    rule = Rule("kd999_faulty", Severity.ERROR, check_document=failing)
    shown = document("untitled:r", 1, TEXT, "utf-16")
    expected = (await analyses.of(shown)).findings
    monkeypatch.setattr(analysis, "checking_rules", lambda: (rule, *checking_rules()))
    monkeypatch.setattr(analysis, "running_rules", analysis.running_rules.__wrapped__)
    again = document("untitled:r", 2, TEXT, "utf-16")
    assert await findings_of(analyses, again) == expected != ()
    assert "KD999 failed: KeyError: 'oh'" in caplog.text


async def test_a_job_that_fails_tells_whoever_waits(worker: Worker) -> None:
    def fail() -> None:
        raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        await worker.run(fail)
    assert await worker.run(lambda: 3) == 3


def busy(worker: Worker) -> Callable[[], None]:
    """Keep the worker busy until the returned function is called."""
    gate = threading.Event()
    worker.submit(gate.wait)
    return gate.set


async def test_a_version_is_freed_without_the_collector(analyses: Analyses) -> None:
    first = document("untitled:r", 1, TEXT, "utf-16")
    await findings_of(analyses, first)
    known = weakref.ref(await analyses.of(first)), weakref.ref((await analyses.of(first)).model)
    gc.disable()
    try:
        second = first.changed([types.TextDocumentContentChangeWholeDocument(TEXT + " ")], 2)
        del first
        await findings_of(analyses, second)
        assert [each() for each in known] == [None, None]
    finally:
        gc.enable()
