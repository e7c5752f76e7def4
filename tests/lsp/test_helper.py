"""Long work in a process of its own, and what becomes of it where there is none."""

import asyncio
import os
import signal
import sys
import time
from pathlib import Path
from typing import Any

import pytest
from lsprotocol import types
from tests.cli.samples import GOOD, INTEGER
from tests.lsp.sessions import folder_of, opened, session_with
from tests.support.lsp import RawClient

from kindsl.frontends.features import names_in_text
from kindsl.frontends.lsp.handlers.diagnostics import pull_all
from kindsl.frontends.lsp.handlers.structure import workspace_symbols
from kindsl.frontends.lsp.session.helper import Helper
from kindsl.frontends.lsp.session.session import Session
from kindsl.frontends.lsp.session.worker import Worker
from kindsl.judgement.analysis.settings import Settings
from kindsl.robots.comparison.twins import TwinFile


def refuse(reason: str) -> None:
    raise ValueError(reason)


def slowly(seconds: float) -> int:
    time.sleep(seconds)
    return os.getpid()


async def test_a_job_is_done_in_another_process_until_that_ends() -> None:
    helper = Helper(Worker(), 1)
    other = await helper.run(os.getpid)
    assert other not in (0, os.getpid()) and await helper.run(os.getpid) == other
    with pytest.raises(RuntimeError, match="ValueError: not this"):
        await helper.run(refuse, "not this")
    left = asyncio.ensure_future(helper.run(len, "x" * 1_000_000))
    await asyncio.sleep(0)
    left.cancel()
    assert await helper.run(max, 3, 4) == 4
    helper.stop()


async def test_where_a_process_has_ended_the_worker_does_it(
    caplog: pytest.LogCaptureFixture,
) -> None:
    helper = Helper(Worker(), 1)
    os.kill(await helper.run(os.getpid), signal.SIGKILL)
    first, second = await asyncio.gather(helper.run(os.getpid), helper.run(os.getpid))
    assert first == second == os.getpid() == await helper.run(os.getpid)
    assert {record.message.partition(":")[0] for record in caplog.records} == {
        "no process for long work, the server does it"
    }
    helper.stop()


async def test_who_waits_when_it_is_stopped_is_cancelled() -> None:
    helper = Helper(Worker(), 1)
    waiting = asyncio.ensure_future(helper.run(time.sleep, 60))
    await asyncio.sleep(0)
    helper.stop()
    with pytest.raises(asyncio.CancelledError):
        await waiting
    assert await helper.run(os.getpid) == os.getpid()  # by the worker: none is begun any more


@pytest.mark.skipif(not Path("/proc/self/task").exists(), reason="only Linux tells of children")
@pytest.mark.parametrize("is_told", [True, False])
def test_no_process_outlives_the_server(tmp_path: Path, is_told: bool) -> None:
    (tmp_path / "a.kindsl").write_text(GOOD)
    client = RawClient()
    client.initialize(workspaceFolders=[{"uri": tmp_path.as_uri(), "name": "robots"}])
    assert client.request("workspace/diagnostic", {"previousResultIds": []})
    helper, *_ = children(client.process.pid)
    if is_told:
        client.request("shutdown")
        client.notify("exit")
        assert client.wait_for_end() == 0
    client.kill()
    for _ in range(6000):
        if not is_running(helper):
            return
        time.sleep(0.01)
    raise AssertionError("the process for long work runs on")


async def test_without_a_process_the_worker_does_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "executable", "/no/such/python")
    helper = Helper(Worker(), 1)
    assert await helper.run(os.getpid) == os.getpid()
    monkeypatch.undo()
    assert await helper.run(os.getpid) == os.getpid()  # it is not tried again


async def test_what_is_printed_is_no_answer_and_settings_cross(
    caplog: pytest.LogCaptureFixture,
) -> None:
    helper = Helper(Worker(), 1)
    assert await helper.run(os.write, 1, b"to the log\n") == 11
    settings = Settings(twins=(TwinFile("a.urdf", "a.urdf"),), known={"x": 1})
    assert (await helper.run(tuple, settings)) == tuple(settings)
    assert not caplog.records
    helper.stop()


async def test_a_workspace_is_read_once_and_again_where_a_text_has_changed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    files = [tmp_path / f"{name}.kindsl" for name in ("a", "b", "c")]
    for file in files:
        file.write_text(GOOD)
    with session_with() as (session, _):
        session.workspace.add_folders([folder_of(tmp_path)])
        jobs = counted(session, monkeypatch)
        read: list[str] = []
        names = names_in_text.symbols_in_text
        monkeypatch.setattr(
            names_in_text, "symbols_in_text", lambda text: (read.append(text), names(text))[1]
        )
        opened(session, files[0].as_uri(), GOOD.replace("upper", "shown"))
        found = await named(session, "upper")
        assert found == [(file.as_uri(), "upper") for file in files[1:]]
        assert await named(session, "SHWN") == [(files[0].as_uri(), "shown")]
        files[1].write_text(GOOD)
        os.utime(files[1], (1, 1))
        await named(session, "")
        assert len(read) == 2
        files[1].write_text(GOOD.replace("upper", "over"))
        assert await named(session, "over") == [(files[1].as_uri(), "over")]
        assert len(read) == 3 and jobs == []
        files[2].write_text(INTEGER)
        reports = await pull_all(session, types.WorkspaceDiagnosticParams([]))
        codes = {each["uri"]: [d["code"] for d in each["items"]] for each in reports["items"]}
        assert codes == {f.as_uri(): ["KD005"] if f is files[2] else [] for f in files}
        assert len(jobs) == 2
        ids = [types.PreviousResultId(each["uri"], each["resultId"]) for each in reports["items"]]
        again = await pull_all(session, types.WorkspaceDiagnosticParams(ids))
        assert {each["kind"] for each in again["items"]} == {"unchanged"} and len(jobs) == 2


async def test_jobs_are_shared_out_among_as_many_processes_as_are_wanted() -> None:
    helper = Helper(Worker(), 3)
    processes = await asyncio.gather(*(helper.run(slowly, 0.5) for _ in range(9)))
    assert len(set(processes)) == 3
    helper.stop()
    assert await helper.run(os.getpid) == os.getpid()


def children(process: int) -> list[int]:
    """Return the processes that another one has started."""
    lists = Path(f"/proc/{process}/task").glob("*/children")
    return [int(child) for each in lists for child in each.read_text().split()]


def is_running(process: int) -> bool:
    """Return whether a process has a command line still: one that nobody waits for has none."""
    try:
        return bool(Path(f"/proc/{process}/cmdline").read_bytes())
    except OSError:
        return False


def counted(session: Session, monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Return the names of the jobs that the helper gets, as they come."""
    jobs: list[str] = []
    run = session.helper.run

    async def noted(job: Any, *arguments: Any) -> Any:
        jobs.append(job.__name__)
        return await run(job, *arguments)

    monkeypatch.setattr(session.helper, "run", noted)
    return jobs


async def named(session: Session, query: str) -> list[tuple[str, str]]:
    """Return URI and name of what is found, the robots and joints left out."""
    found = await workspace_symbols(session, types.WorkspaceSymbolParams(query))
    return [(each["location"]["uri"], each["name"]) for each in found if each["kind"] == 5]
