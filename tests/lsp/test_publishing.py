"""What is pushed to the editor and when, and what is left to those that pull."""

import asyncio
import threading
from pathlib import Path
from typing import Any

import pytest
from lsprotocol import types
from tests.cli.samples import GOOD, INTEGER, UNBOUND, arm
from tests.lsp.sessions import Told, folder_of, opened, session_with

from kindsl.frontends.cli import main
from kindsl.frontends.lsp.handlers.diagnostics import pull
from kindsl.frontends.lsp.session import calm, publishing
from kindsl.frontends.lsp.session.analyses import Version
from kindsl.frontends.lsp.session.findings import diagnostics
from kindsl.frontends.lsp.session.publishing import Publisher
from kindsl.frontends.lsp.session.session import Session
from kindsl.frontends.lsp.text.document import Document
from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.judgement.analysis.twins import compared_twins

PUBLISH = "textDocument/publishDiagnostics"
URI = "untitled:arm"


def pulling(*, is_told: bool) -> types.ClientCapabilities:
    """Return the capabilities of a client that pulls, and perhaps can be asked to pull again."""
    return types.ClientCapabilities(
        text_document=types.TextDocumentClientCapabilities(
            diagnostic=types.DiagnosticClientCapabilities()
        ),
        workspace=types.WorkspaceClientCapabilities(
            diagnostics=types.DiagnosticWorkspaceClientCapabilities(refresh_support=is_told)
        ),
    )


async def published(told: Told, uri: str, n: int = 1) -> list[Any]:
    """Wait until something was published so often for a document; return all of it."""
    async with asyncio.timeout(60):
        while len(found := [p for p in told.named(PUBLISH) if p["uri"] == uri]) < n:
            await asyncio.sleep(0.002)
    return found


async def settled(session: Session) -> None:
    """Wait until nothing is under way any more."""
    while others := asyncio.all_tasks() - {asyncio.current_task()}:
        await asyncio.wait(others)
    await asyncio.sleep(0.01)


def codes(params: Any) -> list[str]:
    return [found.get("code") for found in params["diagnostics"]]


def change(session: Session, uri: str, version: int, text: str) -> None:
    whole = types.TextDocumentContentChangeWholeDocument(text)
    identifier = types.VersionedTextDocumentIdentifier(version, uri)
    session.documents.change(types.DidChangeTextDocumentParams(identifier, [whole]))


async def test_a_document_is_published_when_it_is_opened_and_after_the_last_keystroke() -> None:
    with session_with() as (session, told):
        session.workspace.set_editor_settings({"diagnostics": {"delay": 20}})
        opened(session, URI, INTEGER, 1)
        (first,) = await published(told, URI)
        assert (first["version"], codes(first)) == (1, ["KD005"])
        for version in range(2, 6):
            change(session, URI, version, GOOD if version == 5 else UNBOUND)
        found = await published(told, URI, 2)
        await settled(session)
        assert [(p["version"], codes(p)) for p in found[1:]] == [(5, [])]
        session.documents.close(URI)
        *_, cleared = await published(told, URI, 3)
        assert cleared == {"uri": URI, "diagnostics": []}


async def test_of_several_turns_to_publish_a_version_the_last_is_taken() -> None:
    with session_with() as (session, told):
        document = opened(session, URI, INTEGER)
        for _ in range(3):
            session.publisher.schedule(document, 0.0)
        await published(told, URI)
        await settled(session)
        assert len(told.named(PUBLISH)) == 1


async def test_only_a_keystroke_is_waited_after(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    schedule, delays = Publisher.schedule, list[float]()

    def noted(publisher: Publisher, document: Document, delay: float) -> None:
        delays.append(delay)
        schedule(publisher, document, delay)

    monkeypatch.setattr(Publisher, "schedule", noted)
    companion = (tmp_path / "kindsl.toml").as_uri()
    with session_with() as (session, told):
        session.workspace.set_editor_settings({"diagnostics": {"delay": 20}})
        opened(session, companion, "[parameters]\nlength = 1.0\n")
        await published(told, companion)
        opened(session, URI, UNBOUND)
        await published(told, companion, 2)
        session.publisher.refresh()
        await settled(session)
        assert set(delays) == {0.0}
        change(session, URI, 2, GOOD)
        assert delays[-1] == 0.02


async def test_what_a_document_needs_is_set_aside_once(monkeypatch: pytest.MonkeyPatch) -> None:
    told_of: list[str] = []
    monkeypatch.setattr(publishing.memory, "set_aside", lambda: told_of.append("once"))
    with session_with() as (session, told):
        for uri in (URI, "untitled:b"):
            opened(session, uri, GOOD, 1)
            await published(told, uri)
            change(session, uri, 2, INTEGER)
            await published(told, uri, 2)
    assert len(told_of) == 2


async def test_who_listens_hears_what_was_found() -> None:
    with session_with() as (session, told):
        heard: list[tuple[int | None, int]] = []
        session.on_findings.append(lambda shown, found: heard.append((shown.version, len(found))))
        opened(session, URI, INTEGER, 3)
        await published(told, URI)
        await settled(session)
        assert heard == [(3, 1)]


@pytest.mark.parametrize("number, is_here", [(199, True), (200, False)])
async def test_many_findings_are_made_ready_in_the_worker(
    monkeypatch: pytest.MonkeyPatch, number: int, is_here: bool
) -> None:
    threads: set[threading.Thread] = set()
    (found,) = analyse(INTEGER).findings

    def noted(*arguments: Any) -> Any:
        threads.add(threading.current_thread())
        return diagnostics(*arguments)

    async def many(*_: object) -> Any:
        return (found,) * number

    monkeypatch.setattr(publishing, "diagnostics", noted)
    for name in ("findings", "findings_without_twins"):
        monkeypatch.setattr(Version, name, many)
    with session_with() as (session, told):
        opened(session, URI, INTEGER)
        await published(told, URI)
        await settled(session)
        assert [thread is threading.current_thread() for thread in threads] == [is_here]


@pytest.mark.parametrize("length, is_long", [(50_000, False), (50_001, True)])
async def test_a_long_document_is_read_before_it_is_checked(
    monkeypatch: pytest.MonkeyPatch, length: int, is_long: bool
) -> None:
    asked: list[str] = []

    async def analysis(_: Version) -> Analysis:
        asked.append("analysis")
        return analyse(GOOD)

    async def findings(*_: object) -> Any:
        asked.append("findings")
        return ()

    monkeypatch.setattr(Version, "analysis", analysis)
    for name in ("findings", "findings_without_twins"):
        monkeypatch.setattr(Version, name, findings)
    with session_with() as (session, told):
        opened(session, "untitled:r", GOOD.ljust(length))
        await published(told, "untitled:r")
        await settled(session)
        assert (asked[0] == "analysis") is is_long


async def test_what_is_pulled_is_cleared_once_and_pushed_no_more() -> None:
    with session_with(pulling(is_told=True)) as (session, told):
        shown = opened(session, URI, INTEGER, 1)
        await published(told, URI)
        for _ in range(2):
            session.publisher.leave_to_pull(shown)
        assert [codes(p) for p in told.named(PUBLISH)] == [["KD005"], []]
        session.publisher.refresh()
        await settled(session)
        assert len(told.named(PUBLISH)) == 2
        other = opened(session, "untitled:b", GOOD)
        await published(told, "untitled:b")
        session.publisher.leave_to_pull(other)
        assert len([p for p in told.named(PUBLISH) if p["uri"] == "untitled:b"]) == 1


async def test_one_that_cannot_be_asked_to_pull_again_is_pushed_what_is_new() -> None:
    with session_with(pulling(is_told=False)) as (session, told):
        shown = opened(session, URI, INTEGER, 1)
        await published(told, URI)
        session.publisher.leave_to_pull(shown)
        session.publisher.refresh()
        assert codes((await published(told, URI, 3))[-1]) == ["KD005"]
        session.publisher.leave_to_pull(shown)
        session.documents.close(URI)
        opened(session, URI, INTEGER, 2)
        assert (await published(told, URI, 6))[-1]["version"] == 2


async def test_a_client_that_does_not_pull_is_pushed_on() -> None:
    with session_with() as (session, told):
        shown = opened(session, URI, INTEGER, 1)
        await published(told, URI)
        session.publisher.leave_to_pull(shown)
        session.publisher.refresh()
        assert [codes(p) for p in await published(told, URI, 2)] == [["KD005"]] * 2


async def test_what_a_configuration_file_says_wrong_is_told_until_it_is_mended(
    tmp_path: Path,
) -> None:
    file = tmp_path / "kindsl.toml"
    file.write_text("x = 1\n")
    with session_with() as (session, told):
        session.workspace.add_folders([folder_of(tmp_path)])
        opened(session, (tmp_path / "arm.kindsl").as_uri(), UNBOUND)
        (wrong,) = await published(told, file.as_uri())
        (problem,) = wrong["diagnostics"]
        assert problem["message"].startswith("unknown key 'x'") and "version" not in wrong
        assert (problem["severity"], problem["source"]) == (1, "kindsl")
        assert problem["range"]["start"] == {"line": 0, "character": 0}
        await session.closed.look_again()
        assert len(await published(told, file.as_uri())) == 1
        file.write_text("")
        await session.closed.look_again()
        assert [p["diagnostics"] for p in (await published(told, file.as_uri(), 2))[1:]] == [[]]
        file.write_text("x = 1\n")
        await session.closed.look_again()
        assert len(await published(told, file.as_uri())) == 2
        await session.closed.look([file.as_uri()])
        assert len((await published(told, file.as_uri(), 3))[2]["diagnostics"]) == 1
        file.unlink()
        await session.closed.look_again()
        assert (await published(told, file.as_uri(), 4))[3]["diagnostics"] == []


async def test_an_open_configuration_file_speaks_for_itself_and_names_what_nobody_uses(
    tmp_path: Path,
) -> None:
    file, robot = tmp_path / "kindsl.toml", tmp_path / "arm.kindsl"
    robot.write_text(UNBOUND)
    file.write_text("x = 1\n")
    with session_with() as (session, told):
        session.workspace.add_folders([folder_of(tmp_path)])
        opened(session, file.as_uri(), "[parameters]\nlength = 1.0\nwidth = 2.0\n", 4)
        (found,) = await published(told, file.as_uri())
        assert found["version"] == 4
        (unused,) = found["diagnostics"]
        assert "'width'" in unused["message"] and unused["range"]["start"]["line"] == 2
        opened(session, robot.as_uri(), arm(reach="width"), 1)
        *_, again = await published(told, file.as_uri(), 2)
        await settled(session)
        assert ["'length'" in each["message"] for each in again["diagnostics"]] == [True]
        opened(session, "file:///elsewhere/leg.kindsl", arm(reach="length"), 1)
        *_, still = await published(told, file.as_uri(), 3)
        await settled(session)
        assert still["diagnostics"] == again["diagnostics"]
        change(session, file.as_uri(), 5, "y = 1\n")
        *_, wrong = await until_says(told, file.as_uri(), "unknown key 'y'")
        assert wrong["version"] == 5
        session.documents.close(file.as_uri())
        assert (await until_says(told, file.as_uri(), "unknown key 'x'"))[-1]


async def until_says(told: Told, uri: str, message: str) -> list[Any]:
    async with asyncio.timeout(60):
        while True:
            found = [p for p in told.named(PUBLISH) if p["uri"] == uri]
            shown = found[-1]["diagnostics"] if found else []
            if len(shown) == 1 and shown[0]["message"].startswith(message):
                return found
            await asyncio.sleep(0.002)


async def test_companions_that_are_pulled_are_asked_for_again_when_names_change(
    tmp_path: Path,
) -> None:
    file, robot = tmp_path / "kindsl.toml", tmp_path / "arm.kindsl"
    with session_with(pulling(is_told=True)) as (session, told):
        session.workspace.set_editor_settings({"diagnostics": {"delay": 0}})
        shown = opened(session, file.as_uri(), "[parameters]\nlength = 1.0\n")
        await published(told, file.as_uri())
        session.publisher.leave_to_pull(shown)
        told.messages.clear()
        opened(session, robot.as_uri(), UNBOUND)
        await published(told, robot.as_uri())
        await settled(session)
        assert len(told.named("workspace_diagnostic_refresh")) == 1
        change(session, robot.as_uri(), 2, UNBOUND + "\n")
        await published(told, robot.as_uri(), 2)
        await settled(session)
        assert len(told.named("workspace_diagnostic_refresh")) == 1
        change(session, robot.as_uri(), 3, arm(reach="width"))
        await published(told, robot.as_uri(), 3)
        await settled(session)
        assert len(told.named("workspace_diagnostic_refresh")) == 2
        change(session, file.as_uri(), 2, "mistaken = 1\n")
        await settled(session)
        assert not [p for p in told.named(PUBLISH) if p["uri"] == file.as_uri()]


async def test_companions_that_nobody_pulls_are_pushed_again_when_names_change(
    tmp_path: Path,
) -> None:
    companion = (tmp_path / "kindsl.toml").as_uri()
    with session_with(pulling(is_told=True)) as (session, told):
        opened(session, companion, "[parameters]\nlength = 1.0\n")
        await published(told, companion)
        opened(session, URI, UNBOUND)
        await published(told, companion, 2)
        await settled(session)
        assert told.named("workspace_diagnostic_refresh") == []


async def test_of_a_companion_only_the_version_that_is_shown_is_told(tmp_path: Path) -> None:
    uri = (tmp_path / "kindsl.toml").as_uri()
    with session_with() as (session, told):
        session.workspace.set_editor_settings({"diagnostics": {"delay": 60_000}})
        old = opened(session, uri, "mistaken = 1\n")
        change(session, uri, 2, "wrong = 1\n")
        new = session.documents.get(uri)
        assert new is not None
        told.messages.clear()
        for each in (old, new):
            session.publisher.schedule(each, 0.0)
            await settled(session)
        assert [params["version"] for params in told.named(PUBLISH)] == [2]


async def test_the_disk_is_looked_at_for_files_that_decide(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("kindsl.frontends.lsp.session.closed_configurations.INTERVAL", 0.001)
    with session_with() as (session, told):
        opened(session, (tmp_path / "arm.kindsl").as_uri(), UNBOUND)
        await published(told, (tmp_path / "arm.kindsl").as_uri())
        changes: list[None] = []

        def changed() -> None:
            changes.append(None)
            session.publisher.refresh()

        watching = asyncio.ensure_future(session.closed.watch(changed))
        await asyncio.sleep(0.02)
        assert changes == []
        file = tmp_path / "kindsl.toml"
        file.write_text("x = 1\n")
        await until_says(told, file.as_uri(), "unknown key 'x'")
        assert len(changes) == 1
        file.write_text("")
        assert (await published(told, file.as_uri(), 2))[1]["diagnostics"] == []
        watching.cancel()
        with pytest.raises(asyncio.CancelledError):
            await watching


@pytest.fixture
def twinned(tmp_path: Path) -> str:
    """The URI of an arm whose URDF says 2.5 kg."""
    robot, twin = tmp_path / "arm.kindsl", tmp_path / "arm.urdf"
    robot.write_text(arm(mass="2.5"))
    assert main.main(["convert", "-q", str(robot), str(twin)]) == 0
    table = '[[twins]]\ndocument = "arm.kindsl"\nfile = "arm.urdf"\n'
    (tmp_path / "kindsl.toml").write_text(table)
    return robot.as_uri()


async def test_twins_are_compared_when_the_findings_of_the_text_are_out(
    tmp_path: Path, twinned: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(calm, "PATIENCE", 0.0)
    with session_with() as (session, told):
        out_before: list[list[int]] = []

        def compared(*given: Any) -> Any:
            out_before.append([p["version"] for p in told.named(PUBLISH) if p["uri"] == twinned])
            return compared_twins(*given)

        async def judged(n: int) -> list[tuple[int, list[str]]]:
            found = await published(told, twinned, n)
            await settled(session)
            return [(p["version"], codes(p)) for p in found]

        monkeypatch.setattr("kindsl.judgement.analysis.twins.compared_twins", compared)
        session.workspace.add_folders([folder_of(tmp_path)])
        session.workspace.set_editor_settings({"diagnostics": {"delay": 0}})
        opened(session, twinned, GOOD, 1)
        assert await judged(2) == [(1, []), (1, ["KD901"])]
        change(session, twinned, 2, arm(reach="0.6"))
        assert (await judged(4))[2:] == [(2, ["KD901"]), (2, ["KD901", "KD901"])]
        change(session, twinned, 3, arm(mass="2.6", reach="0.6"))
        assert (await judged(6))[4:] == [(3, ["KD901"]), (3, ["KD901", "KD901"])]
        assert out_before == [[1], [1, 1, 2], [1, 1, 2, 2, 3]]


async def test_a_comment_that_silences_twins_is_not_in_vain_before_they_are_compared(
    tmp_path: Path, twinned: str
) -> None:
    with session_with() as (session, told):
        session.workspace.add_folders([folder_of(tmp_path)])
        silenced = GOOD.replace("link upper {", "link upper { // kindsl: ignore[KD901]")
        opened(session, twinned, silenced)
        await published(told, twinned)
        await settled(session)
        assert [codes(p) for p in told.named(PUBLISH)] == [[]]


async def test_who_pulls_has_the_findings_of_the_text_and_is_asked_to_pull_again(
    tmp_path: Path, twinned: str
) -> None:
    with session_with(pulling(is_told=True)) as (session, told):
        session.workspace.add_folders([folder_of(tmp_path)])
        opened(session, twinned, GOOD)
        asked = types.DocumentDiagnosticParams(types.TextDocumentIdentifier(twinned))
        first = await pull(session, asked)
        await settled(session)
        assert codes({"diagnostics": first["items"]}) == []
        assert len(told.named("workspace_diagnostic_refresh")) == 1
        then = await pull(session, asked)
        assert codes({"diagnostics": then["items"]}) == ["KD901"]
