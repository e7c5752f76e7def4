"""What a session tells the editor, and what it makes of the answers."""

import asyncio
import gc
import math
import threading
from pathlib import Path
from typing import Any

import pytest
from lsprotocol import types
from tests.cli.samples import GOOD, UNBOUND, arm
from tests.lsp.sessions import REFUSAL, folder_of, of_versions, opened, session_with

from kindsl.frontends.lsp.session import closed_configurations, memory, previews, progress
from kindsl.frontends.lsp.session import state as session_state
from kindsl.frontends.lsp.session.binding import bound, pose_edit, request_edits
from kindsl.frontends.lsp.session.closed_configurations import ClosedConfigurations
from kindsl.frontends.lsp.session.companions import transforms_view
from kindsl.frontends.lsp.session.configuration_files import (
    configuration_of,
    configuration_problems,
)
from kindsl.frontends.lsp.session.findings import diagnostics
from kindsl.frontends.lsp.session.progress import AT_A_TIME, Progress
from kindsl.frontends.lsp.session.publishing import status_of
from kindsl.frontends.lsp.session.view import without_marks
from kindsl.frontends.lsp.session.worker import AbandonedError, Urgency, Worker, start_task
from kindsl.frontends.lsp.session.workspace import Workspace
from kindsl.frontends.lsp.text import uris
from kindsl.frontends.lsp.text.document import document
from kindsl.frontends.lsp.wire.client import Client
from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.diagnostics import RelatedPlace
from kindsl.judgement.config import configuration_reading
from kindsl.judgement.config.configuration_reading import text_of
from kindsl.judgement.config.editor_settings import editor_settings
from kindsl.language.text.edits import TextEdit

URI = "untitled:arm"
EDIT = TextEdit(6, 9, "leg")
APPLIED = types.ApplyWorkspaceEditResult(applied=True)


async def test_what_is_written_is_one_labelled_edit_of_the_version_that_was_seen() -> None:
    with session_with(of_versions()) as (session, told):
        view = await session.view(opened(session, URI, GOOD, 7))
        told.answers["workspace_apply_edit"] = APPLIED
        assert await request_edits(view, "Rename", [EDIT]) == ""
        (params,) = told.named("workspace_apply_edit")
        assert params.label == "Rename"
        (change,) = params.edit.document_changes
        assert (change.text_document.uri, change.text_document.version) == (URI, 7)
        span = types.Range(types.Position(0, 6), types.Position(0, 9))
        assert change.edits == [types.TextEdit(span, "leg")]


@pytest.mark.parametrize("answer", [types.ApplyWorkspaceEditResult(applied=False), None, REFUSAL])
async def test_an_editor_that_did_not_write_means_that_the_text_changed(answer: Any) -> None:
    with session_with(of_versions()) as (session, told):
        view = await session.view(opened(session, URI, GOOD))
        told.answers["workspace_apply_edit"] = answer
        why = await request_edits(view, "Rename", [EDIT])
        assert why == "the document has changed in the meantime"
        assert len(told.named("workspace_apply_edit")) == 1


async def test_nothing_to_write_asks_nobody() -> None:
    with session_with(of_versions()) as (session, told):
        view = await session.view(opened(session, URI, GOOD))
        assert await request_edits(view, "Nothing", []) == ""
        assert told.named("workspace_apply_edit") == []


async def test_values_go_into_the_configuration_file_beside_the_edits(tmp_path: Path) -> None:
    file, robot = tmp_path / "kindsl.toml", tmp_path / "arm.kindsl"
    file.write_text("[parameters]\nlength = 1.0\n")
    with session_with(of_versions()) as (session, told):
        session.workspace.add_folders([folder_of(tmp_path)])
        view = await session.view(opened(session, robot.as_uri(), UNBOUND, 3))
        told.answers["workspace_apply_edit"] = APPLIED
        assert await request_edits(view, "Set", [EDIT], [("length", 2.5)]) == ""
        (params,) = told.named("workspace_apply_edit")
        first, second = params.edit.document_changes
        assert (first.text_document.uri, first.text_document.version) == (robot.as_uri(), 3)
        assert (second.text_document.uri, second.text_document.version) == (file.as_uri(), None)
        assert [edit.new_text for edit in second.edits] == ["2.5"]
        told.messages.clear()
        assert await request_edits(view, "Set", [], [("length", 2.5)]) == ""
        (params,) = told.named("workspace_apply_edit")
        assert [c.text_document.uri for c in params.edit.document_changes] == [file.as_uri()]


@pytest.mark.parametrize("text", [None, "x = ["])
async def test_without_a_file_to_write_values_into_nothing_is_written(
    text: str | None, tmp_path: Path
) -> None:
    if text is not None:
        (tmp_path / "kindsl.toml").write_text(text)
    with session_with(of_versions()) as (session, told):
        session.workspace.add_folders([folder_of(tmp_path)])
        view = await session.view(opened(session, (tmp_path / "arm.kindsl").as_uri(), UNBOUND))
        why = await request_edits(view, "Set", [EDIT], [("length", 2.5)])
        assert why == "the configuration file cannot be written"
        assert told.named("workspace_apply_edit") == []


@pytest.mark.parametrize(
    ("text", "is_kept"),
    [("", True), ('document = [{path = "other.kindsl"}]\n', False), ("mistaken = 1\n", False)],
)
async def test_a_pose_is_kept_where_the_file_can_be_extended(
    text: str, is_kept: bool, tmp_path: Path
) -> None:
    (tmp_path / "kindsl.toml").write_text(text)
    with session_with() as (session, _):
        robot = opened(session, (tmp_path / "arm.kindsl").as_uri(), UNBOUND)
        assert (pose_edit(session, robot, "home", {"shoulder": 1.0}) is not None) is is_kept


async def test_a_new_file_goes_into_the_innermost_folder_around_the_robot(tmp_path: Path) -> None:
    inner = tmp_path / "robots"
    (inner / "legs").mkdir(parents=True)
    with session_with() as (session, _):
        robot = opened(session, (inner / "legs" / "arm.kindsl").as_uri(), UNBOUND)
        for folders, where in (
            ([], inner / "legs"),
            ([tmp_path, inner], inner),
            ([inner, tmp_path], inner),
            ([tmp_path], tmp_path),
        ):
            session.workspace.remove_folders([folder_of(tmp_path), folder_of(inner)])
            session.workspace.add_folders(map(folder_of, folders))
            found = bound(session, robot, [("length", 2.0)])
            assert found is not None and found.is_new
            assert found.document.uri == uris.uri(where / "kindsl.toml")
            assert found.edit == TextEdit(0, 0, "[parameters]\nlength = 2.0\n")
        assert bound(session, opened(session, URI, UNBOUND), [("length", 2.0)]) is None


def test_status_counts_freedoms_and_findings() -> None:
    loop = GOOD.replace("children {}", "children { upper via shoulder }")
    for text, dof, state in (
        (GOOD, 2, "ready"),
        (arm(floating=True), 8, "ready"),
        (UNBOUND, 2, "unbound parameters"),
        (loop, None, "broken model"),
    ):
        analysis = analyse(text)
        status = {"findings": len(analysis.findings), "dof": dof, "state": state}
        assert status_of(analysis, analysis.findings) == status


async def test_status_is_sent_to_a_client_that_listens() -> None:
    for announced in ({}, {"kindsl/status": True}):
        with session_with() as (session, told):
            session.client = Client(types.ClientCapabilities(experimental=announced), {})
            opened(session, URI, GOOD)
            while not told.named("textDocument/publishDiagnostics"):
                await asyncio.sleep(0.002)
            await session.worker.run(lambda: None, Urgency.BACKGROUND)
            await asyncio.sleep(0.01)
            sent = told.named("kindsl/status")
            status = {"uri": URI, "findings": 0, "dof": 2, "state": "ready"}
            assert sent == ([status] if announced else [])


class TestProgress:
    """Of a whole of 100."""

    async def test_with_a_token_each_per_cent_is_told_once(self) -> None:
        with session_with() as (session, told):
            async with Progress(session, "Checking", "t") as progress:
                for done in (0, 1, 4, 7, 300, 400):
                    await progress.report(done, 400)
        values = [params.value for params in told.named("progress")]
        assert {params.token for params in told.named("progress")} == {"t"}
        assert values[0] == types.WorkDoneProgressBegin("Checking", percentage=0)
        assert [value.percentage for value in values[1:-1]] == [1, 75, 100]
        assert values[-1] == types.WorkDoneProgressEnd()

    async def test_a_slow_item_keeps_no_processor_waiting(self) -> None:
        numbers = range(2 * AT_A_TIME)
        is_over = asyncio.Event()

        async def work(number: int) -> int:
            if number == AT_A_TIME:
                is_over.set()
            if number == 1:
                await is_over.wait()
            return number

        with session_with() as (session, _):
            async with Progress(session, "Checking", None) as progress, asyncio.timeout(20):
                assert [found async for found in progress.over(numbers, work)] == [*numbers]

    async def test_what_is_given_up_is_worked_on_no_more(self) -> None:
        begun = list[asyncio.Task[Any] | None]()

        async def work(number: int) -> int:
            begun.append(asyncio.current_task())
            if number:
                await asyncio.Event().wait()
            return number

        with session_with() as (session, _):
            async with Progress(session, "Checking", None) as progress:
                found = progress.over(range(3), work)
                assert await anext(found) == 0
                await found.aclose()
            await asyncio.sleep(0)
        assert [task.cancelled() for task in begun[1:] if task] == [True, True]

    async def test_without_a_token_nothing_is_told_at_once(self) -> None:
        with session_with(_shows_progress()) as (session, told):
            async with Progress(session, "Checking", None) as progress:
                await progress.report(1, 2)
        assert told.messages == []

    @pytest.mark.parametrize("answer", [None, REFUSAL])
    async def test_long_work_asks_once_for_a_token(
        self, answer: Any, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        monkeypatch.setattr("kindsl.frontends.lsp.session.progress.PATIENCE", 0.0)
        with session_with(_shows_progress()) as (session, told):
            told.answers["window_work_done_progress_create"] = answer
            async with Progress(session, "Checking", None) as progress:
                for done in (1, 2):
                    await progress.report(done, 2)
            (created,) = told.named("window_work_done_progress_create")
            values = [(params.token, params.value) for params in told.named("progress")]
            if answer is REFUSAL:
                assert values == []
            else:
                assert [token for token, _ in values] == [created.token] * 4
                assert values[0][1] == types.WorkDoneProgressBegin("Checking", percentage=0)
                assert [value.percentage for _, value in values[1:3]] == [50, 100]

    async def test_a_client_that_shows_none_is_not_asked(
        self, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        monkeypatch.setattr("kindsl.frontends.lsp.session.progress.PATIENCE", 0.0)
        with session_with() as (session, told):
            async with Progress(session, "Checking", None) as progress:
                await progress.report(1, 2)
        assert told.messages == []


def _shows_progress() -> types.ClientCapabilities:
    window = types.WindowClientCapabilities(work_done_progress=True)
    return types.ClientCapabilities(window=window)


def test_findings_show_what_the_client_can() -> None:
    text = arm(reach="1")
    shown = document(URI, 1, text, "utf-16")
    (found,) = analyse(text).findings
    found = found._replace(related=(RelatedPlace(0, 5, "there"),), tag="unnecessary")
    start, end = {"line": 20, "character": 31}, {"line": 20, "character": 32}
    plain_parts = {
        "range": {"start": start, "end": end},
        "severity": 1,
        "code": "KD005",
        "source": "kindsl",
        "message": found.message,
    }
    links = {"codeDescription": {"href": found.url}}
    assert found.url is not None
    tags = {"tags": [1]}
    there = {"start": {"line": 0, "character": 0}, "end": {"line": 0, "character": 5}}
    related = {
        "relatedInformation": [{"location": {"uri": URI, "range": there}, "message": "there"}]
    }
    every = types.PublishDiagnosticsClientCapabilities(
        related_information=True,
        code_description_support=True,
        tag_support=types.ClientDiagnosticsTagOptions([]),
    )
    for told, parts in (
        (None, links | tags | related),
        (every, links | tags | related),
        (types.PublishDiagnosticsClientCapabilities(), {}),
        (types.PublishDiagnosticsClientCapabilities(code_description_support=True), links),
        (types.PublishDiagnosticsClientCapabilities(related_information=True), related),
    ):
        about = types.TextDocumentClientCapabilities(publish_diagnostics=told)
        client = Client(types.ClientCapabilities(text_document=about), {})
        assert diagnostics(shown, [found], client.shows_in_diagnostics) == [plain_parts | parts]
    bare = found._replace(related=(), tag=None, code="", severity="hint")
    client = Client(types.ClientCapabilities(), {})
    assert diagnostics(shown, [bare], client.shows_in_diagnostics) == [
        plain_parts | {"severity": 4, "code": ""}
    ]


_NUMBER = "a number, or a table with 'value', 'min', 'max'"


class TestSettings:
    """One sentence for each setting that makes no sense, which then counts as not given."""

    @pytest.mark.parametrize(
        ("raw", "problem"),
        [
            ({"target": "ros"}, "target': unknown target 'ros' (known: robcogen, robcogen2)"),
            ({"target": 3}, "target' must be a list of strings, not a number"),
            ({"ignore": {}}, "ignore' must be a list of strings, not a table"),
            ({"ignore": [2]}, "ignore[0]' must be a string, not a number"),
            ({"ignore": ["K"]}, "ignore[0]': no rule has a code that begins with 'K'"),
            ({"severity": []}, "severity' must be a table, not a list"),
            (
                {"severity": {"KD1": "bad"}},
                "severity.KD1': unknown severity 'bad' of 'KD1'"
                " (known: error, warning, info, hint)",
            ),
            ({"parameters": [1]}, "parameters' must be a table, not a list"),
            *(
                ({"parameters": {"a": v}}, f"parameters.a' must be {_NUMBER}, not {kind}")
                for v, kind in ((True, "a boolean"), ("1", "a string"), (None, "null"))
            ),
            *(
                ({"parameters": {"a": v}}, "parameters.a' must be finite")
                for v in (math.nan, math.inf, 10**400)
            ),
            ({"parameters": {"a": {}}}, "parameters.a' has no 'value'"),
            *(
                (
                    {"diagnostics": {"delay": v}},
                    "diagnostics.delay' is not between 0 and 60000 milliseconds",
                )
                for v in (-1, 60_001)
            ),
            ({"diagnostics.delay": "1"}, "diagnostics.delay' must be a number, not a string"),
            ({"inlayHints": {"units": 1}}, "inlayHints.units' must be a boolean, not a number"),
            ({"inlayHints": "all"}, "inlayHints' must be a table, not a string"),
        ],
    )  # fmt: skip
    def test_nonsense(self, raw: object, problem: str) -> None:
        found = editor_settings(raw)
        assert found.problems == (f"setting 'kindsl.{problem}",)
        assert found._replace(problems=()) == editor_settings({})

    def test_the_ends_of_the_delay_and_its_usual_length(self) -> None:
        delays = [
            editor_settings({"diagnostics.delay": ms}).diagnostics_delay for ms in (0, 60_000)
        ]
        assert delays == [0.0, 60.0]
        assert editor_settings(None).diagnostics_delay == 0.1

    def test_one_word_for_all_hints_and_one_name_for_a_target(self) -> None:
        assert editor_settings({"inlayHints": False}).inlay_hints == {"enabled": False}
        assert editor_settings({"target": "robcogen2"}).rules.targets == {"robcogen2"}
        binding = editor_settings({"parameters": {"a": {"value": 2, "min": 1}}}).rules.bindings["a"]
        assert (binding.value, binding.minimum, binding.maximum) == (2.0, 1.0, None)


class TestWorkspace:
    """Whose word counts for a document."""

    def test_the_innermost_folder_with_settings_decides(self) -> None:
        workspace = Workspace()
        assert workspace.set_editor_settings({"diagnostics": {"delay": 1000}})
        assert not workspace.set_editor_settings({"diagnostics": {"delay": 1000}})
        assert workspace.set_editor_settings({"diagnostics": {"delay": 2000}}, "file:///a")
        assert workspace.set_editor_settings({"diagnostics": {"delay": "x"}}, "file:///a/b/")
        delays = {
            uri: workspace.editor_settings(uri).diagnostics_delay
            for uri in ("file:///c.kindsl", "file:///a/c.kindsl", "file:///a/b/c.kindsl",
                        "file:///ab/c.kindsl", "untitled:x")
        }  # fmt: skip
        assert list(delays.values()) == [1.0, 2.0, 0.1, 1.0, 1.0]
        assert len(workspace.problems()) == 1
        workspace.remove_folders([types.WorkspaceFolder("file:///a", "a")])
        assert workspace.editor_settings("file:///a/c.kindsl").diagnostics_delay == 1.0

    def test_files_are_read_when_they_are_asked_for_and_watched_from_then(
        self, tmp_path: Path
    ) -> None:
        file = tmp_path / "kindsl.toml"
        shown = document((tmp_path / "arm.kindsl").as_uri(), 1, UNBOUND, "utf-16")
        workspace = Workspace()
        workspace.add_folders([folder_of(tmp_path)])
        assert workspace.known_settings(shown) is None and not workspace.project.is_outdated()
        settings = workspace.read_settings(shown)
        assert settings.bindings == {} and workspace.known_settings(shown) is settings
        assert workspace.read_settings(shown) is settings and not workspace.project.is_outdated()
        file.write_text("[parameters]\nlength = 2.0\n")
        assert workspace.project.is_outdated()
        workspace.forget()
        assert workspace.read_settings(shown).bindings["length"].value == 2.0
        assert workspace.configuration_file(shown) == file and workspace.project.broken == {}
        file.write_text("x = [")
        workspace.forget()
        assert workspace.read_settings(shown).bindings == {}
        assert workspace.configuration_file(shown) is None and list(workspace.project.broken) == [
            file
        ]

    def test_a_document_without_a_file_has_the_first_folder_s_settings(
        self, tmp_path: Path
    ) -> None:
        (tmp_path / "kindsl.toml").write_text("[parameters]\nlength = 2.0\n")
        shown = document(URI, 1, UNBOUND, "utf-16")
        workspace = Workspace()
        assert workspace.read_settings(shown).bindings == {}
        workspace.add_folders([folder_of(tmp_path)])
        assert workspace.read_settings(shown).bindings["length"].value == 2.0
        (tmp_path / "arm.kindsl").write_text(GOOD)
        assert list(workspace.files()) == [tmp_path / "arm.kindsl"]
        assert list(workspace.paths()) == [tmp_path]


class TestWorker:
    """Jobs one after the other, in a thread."""

    async def test_jobs_of_one_urgency_keep_their_order(self) -> None:
        worker, done = Worker(), []
        jobs = [worker.run(lambda n=n: done.append(n), Urgency.ANSWER) for n in range(20)]
        await asyncio.gather(*jobs)
        assert done == list(range(20))

    async def test_a_job_that_is_waited_for_goes_on_past_its_checkpoints(self) -> None:
        worker = Worker()
        worker.checkpoint()
        assert await worker.run(lambda: worker.checkpoint() or 3) == 3
        worker.checkpoint()
        assert issubclass(AbandonedError, Exception)

    async def test_a_cancelled_future_leaves_its_job_out(self) -> None:
        worker, done = Worker(), []
        gate = asyncio.Event()
        loop = asyncio.get_running_loop()
        blocker = worker.submit(
            lambda: asyncio.run_coroutine_threadsafe(gate.wait(), loop).result()
        )
        left_out = worker.submit(lambda: done.append(1))
        assert left_out.future.cancel()
        gate.set()
        await asyncio.wrap_future(blocker.future)
        assert await worker.run(lambda: done.append(2), Urgency.BACKGROUND) is None
        assert done == [2]

    async def test_a_task_that_fails_is_logged_and_one_that_is_cancelled_is_not(
        self, caplog: pytest.LogCaptureFixture
    ) -> None:
        async def fails() -> None:
            raise KeyError("oh")

        await asyncio.wait([start_task(fails())])
        await asyncio.sleep(0)
        assert [record.getMessage() for record in caplog.records] == ["background work failed"]
        waiting = start_task(asyncio.sleep(60))
        await asyncio.sleep(0)
        waiting.cancel()
        await asyncio.wait([waiting])
        await asyncio.sleep(0)
        assert len(caplog.records) == 1


class TestSight:
    """What handlers ask of a version."""

    def test_plain_text_has_no_marks(self) -> None:
        told = without_marks("**mass** of `arm_1`, 2\\*3, a\\b")
        assert told == "mass of arm_1, 2*3, a\\b"

    @pytest.mark.parametrize(
        ("formats", "kind"),
        [
            (None, "markdown"),
            ([], "markdown"),
            (["plaintext", "markdown"], "markdown"),
            (["plaintext"], "plaintext"),
        ],
    )
    async def test_markup_is_what_the_client_shows(self, formats: Any, kind: str) -> None:
        shown = formats and [types.MarkupKind(name) for name in formats]
        hover = types.HoverClientCapabilities(content_format=shown)
        about = types.TextDocumentClientCapabilities(hover=hover)
        with session_with(types.ClientCapabilities(text_document=about)) as (session, _):
            view = await session.view(opened(session, URI, GOOD))
            found = view.markup("**m**", "text_document.hover.content_format")
            assert (found.kind, found.value) == (kind, "**m**" if kind == "markdown" else "m")

    async def test_a_refusal_is_told_once_until_the_document_is_closed(self) -> None:
        with session_with() as (session, told):
            view = await session.view(opened(session, URI, GOOD))
            for _ in range(2):
                view.refuse("too broken")
            await asyncio.sleep(0)
            (params,) = told.named("window_show_message")
            assert (params.type, params.message) == (types.MessageType.Warning, "too broken")
            other = await session.view(opened(session, "untitled:b", GOOD))
            other.refuse("too broken")
            await asyncio.sleep(0)
            assert len(told.named("window_show_message")) == 2
            session.documents.close(URI)
            assert session.refused == {"untitled:b"}

    async def test_who_listens_hears_what_the_cursor_is_on(self) -> None:
        with session_with() as (session, _):
            view = await session.view(opened(session, URI, GOOD))
            heard: list[tuple[str, str, str]] = []
            session.on_cursor[:] = [lambda *what: heard.append(what)]
            view.follow_cursor(types.Position(5, 6))
            view.follow_cursor(types.Position(0, 0))
            assert heard == [(URI, "link", "upper"), (URI, "", "")]
            assert view.location(0, 5).range == types.Range(
                types.Position(0, 0), types.Position(0, 5)
            )


async def test_a_session_answers_about_robots_only_and_counts_its_questions() -> None:
    with session_with() as (session, _):
        opened(session, URI, GOOD)
        opened(session, "untitled:kindsl.toml", "")

        def handler(view: Any, params: Any) -> Any:
            return view.document.uri, params, session.quiet.is_set()

        for ask in (session.ask_at_once, session.ask, session.ask_judged):
            assert await ask(handler, URI, 3) == (URI, 3, False)
            assert session.quiet.is_set()
            assert await ask(handler, "untitled:kindsl.toml", 3) is None
            assert await ask(handler, "untitled:absent", 3) is None


@pytest.mark.parametrize("length, is_here", [(199_999, True), (200_000, False)])
async def test_long_documents_are_asked_in_the_worker(length: int, is_here: bool) -> None:
    with session_with() as (session, _):
        here, asked = threading.current_thread(), []
        opened(session, URI, " " * length)
        await session.ask(lambda *_: asked.append(threading.current_thread()), URI, None)
        assert [thread is here for thread in asked] == [is_here]


async def test_quiet_comes_with_the_last_answer_or_after_a_moment(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    with session_with() as (session, _):
        await asyncio.wait_for(session.until_quiet(), 5)
        with session.question():
            with session.question():
                assert not session.quiet.is_set()
            assert not session.quiet.is_set()
            monkeypatch.setattr("kindsl.frontends.lsp.session.state.PATIENCE", 0.01)
            await asyncio.wait_for(session.until_quiet(), 5)
            monkeypatch.setattr("kindsl.frontends.lsp.session.state.PATIENCE", 60.0)
            waiting = asyncio.ensure_future(session.until_quiet())
            await asyncio.sleep(0)
            assert not waiting.done()
        await asyncio.wait_for(waiting, 5)


async def test_every_document_that_is_open_or_in_a_folder_is_there_once(tmp_path: Path) -> None:
    for name in ("a", "b"):
        (tmp_path / f"{name}.kindsl").write_text(GOOD)
    with session_with() as (session, _):
        session.workspace.add_folders([folder_of(tmp_path)])
        opened(session, URI, GOOD)
        opened(session, (tmp_path / "a.kindsl").as_uri(), GOOD)
        wanted = [URI, *((tmp_path / f"{name}.kindsl").as_uri() for name in "ab")]
        found = await session.open_and_closed()
        assert sorted(found) == sorted(wanted)


async def test_a_transforms_document_is_seen_with_the_robot_beside_it(tmp_path: Path) -> None:
    (tmp_path / "arm.kindsl").write_text(GOOD)
    (tmp_path / "alone").mkdir()
    with session_with() as (session, _):
        for place, name in ((tmp_path, "arm"), (tmp_path / "alone", None)):
            text = "Model arm\n\nTransforms {\n}\n"
            shown = opened(session, (place / "arm.dtdsl").as_uri(), text)
            view = await transforms_view(session, shown)
            assert (str(view.model.name) if view.model else None) == name
        view = await transforms_view(session, opened(session, "untitled:x.dtdsl", ""))
        assert view.model is None


@pytest.mark.parametrize(("named", "found"), [("arm", "arm"), ("leg", "leg"), ("tail", None)])
async def test_of_several_robots_the_one_that_a_transforms_document_names_is_seen(
    tmp_path: Path, named: str, found: str | None
) -> None:
    for number, name in enumerate(("arm", "leg")):
        (tmp_path / f"{number}.kindsl").write_text(GOOD.replace("Robot arm", f"Robot {name}"))
    (tmp_path / "0-gone.kindsl").symlink_to("nowhere")
    with session_with() as (session, _):
        text = f"Robot {named}\n\nTransforms {{\n}}\n"
        shown = opened(session, (tmp_path / "pairs.dtdsl").as_uri(), text)
        view = await transforms_view(session, shown)
        assert (str(view.model.name) if view.model else None) == found


def test_a_workspace_is_trusted_until_an_editor_says_otherwise(tmp_path: Path) -> None:
    workspace = Workspace()
    workspace.add_folders([folder_of(tmp_path / "in")])
    inside, outside = (str(tmp_path / name / "a.urdf") for name in ("in", "out"))
    assert workspace.may_read(inside) and workspace.may_read(outside)
    workspace.is_trusted = False
    assert workspace.may_read(inside) and not workspace.may_read(outside)


@pytest.mark.parametrize(("name", "is_ours"), [("kindsl.toml", True), ("notes.toml", False)])
def test_a_file_of_another_tool_is_no_configuration(name: str, is_ours: bool) -> None:
    for text in ("mistaken = 1\n", "target = 'robcogen'\n"):
        shown = document(f"untitled:{name}", 1, text, types.PositionEncodingKind.Utf16)
        told = [problem["message"] for problem in configuration_problems(shown)]
        assert bool(told) is (is_ours and "mistaken" in text)
        if not told:
            assert (configuration_of(shown) is not None) is is_ours


def test_nobody_waits_longer_than_a_second() -> None:
    waits = (closed_configurations.INTERVAL, memory.LATER, previews.FRAME, progress.PATIENCE)
    assert all(0.0 < wait <= 1.0 for wait in (*waits, session_state.PATIENCE))


def test_the_collector_looks_seldom_at_what_is_young_and_old() -> None:
    usual = gc.get_threshold()
    try:
        memory.tune()
        assert gc.get_threshold() == (10_000, 10, 3)
    finally:
        gc.set_threshold(*usual)


async def test_only_closed_configuration_files_are_looked_at(tmp_path: Path) -> None:
    told: list[str] = []
    for name in ("kindsl.toml", "notes.toml", "open/kindsl.toml"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text("mistaken = 1\n")
    closed, notes, shown = (
        (tmp_path / name).as_uri() for name in ("kindsl.toml", "notes.toml", "open/kindsl.toml")
    )
    with session_with() as (session, _):
        opened(session, shown, "mistaken = 1\n")
        configurations = ClosedConfigurations(session, lambda uri, _: told.append(uri))
        await configurations.look([notes, shown, "untitled:kindsl.toml", closed])
        assert told == [closed]
        await configurations.look([closed])
        assert told == [closed]
        (tmp_path / "kindsl.toml").unlink()
        await configurations.look()
        assert told == [closed, closed]
        await configurations.look()
        assert told == [closed, closed]


async def test_a_file_that_goes_away_while_it_is_read_has_no_problems(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    told: list[Any] = []
    file = tmp_path / "kindsl.toml"
    file.write_text("mistaken = 1\n")

    def going(path: str) -> str:
        Path(path).unlink()
        return text_of(path)

    with session_with() as (session, _):
        configurations = ClosedConfigurations(session, lambda *news: told.append(news))
        await configurations.look([file.as_uri()])
        monkeypatch.setattr(configuration_reading, "text_of", going)
        await configurations.look()
        assert [problems == [] for _, problems in told] == [False, True]
