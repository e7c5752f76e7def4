"""What the preview asks of the editor: to show a place, to write numbers, to keep values."""

import asyncio
from collections.abc import Mapping
from pathlib import Path
from typing import Any, NamedTuple

import pytest
from lsprotocol import types
from tests.cli.samples import GOOD, UNBOUND
from tests.lsp.sessions import REFUSAL, Told, folder_of, of_versions, opened, session_with

from kindsl.frontends.lsp.session.session import Session
from kindsl.frontends.lsp.wire.protocol import RequestFailed
from kindsl.frontends.preview.requests import KeepPose, WriteParameters
from kindsl.frontends.preview.steps import Writing
from kindsl.judgement.config.parameter_lines import parameter_table, pose_table
from kindsl.language.text.edits import TextEdit
from kindsl.language.text.span import Span

URI = "untitled:arm"
WANTED = WriteParameters({"length": 2.0})
WRITING = Writing("Move the elbow", GOOD, (TextEdit(6, 9, "leg"),))


class Preview:
    """Notes what it is told."""

    def __init__(self, *_: object) -> None:
        self.calls: list[tuple[Any, ...]] = []
        self.origins = {"https://editor.example"}
        self.on_write: Any = None
        self.fault: Exception | None = None

    async def start(self) -> None:
        if self.fault is not None:
            raise self.fault
        self.calls.append(("start",))

    async def stop(self) -> None:
        self.calls.append(("stop",))

    def at(self, key: str) -> "Shown | None":
        is_shown = any(call[:2] == ("show", key) for call in self.calls)
        return Shown(key, self.calls) if is_shown else None

    def url(self, key: str) -> str:
        return f"address of {key}"

    def admit(self, origin: str) -> None:
        if origin not in self.origins:
            raise ValueError(f"'{origin}' is no origin")
        self.calls.append(("admit", origin))

    async def show(self, key: str, analysis: Any, findings: Any, label: str) -> None:
        n = None if findings is None else len(findings)
        self.calls.append(("show", key, analysis.text, n, label))


class Shown(NamedTuple):
    """Notes what its document is asked to show."""

    key: str
    calls: list[tuple[Any, ...]]

    def keep_as_ghost(self) -> None:
        self.calls.append(("saved", self.key))

    def set_parameters(self, values: Mapping[str, float]) -> None:
        self.calls.append(("set", self.key, *values.items()))

    def highlight(self, kind: str, name: str) -> None:
        self.calls.append(("highlight", self.key, kind, name))


def with_preview(session: Session, fault: Exception | None = None) -> Preview:
    preview = Preview()
    preview.fault = fault
    made: Any = session.surroundings._replace(new_previews=lambda *_: preview)
    session.surroundings = made
    return preview


async def until_told(told: Told, name: str) -> list[Any]:
    async with asyncio.timeout(60):
        while not (found := told.named(name)):
            await asyncio.sleep(0.001)
    return found


def showing() -> types.ClientCapabilities:
    window = types.WindowClientCapabilities(
        show_document=types.ShowDocumentClientCapabilities(support=True)
    )
    return types.ClientCapabilities(window=window)


async def test_a_document_is_shown_then_judged_and_everything_reaches_its_page() -> None:
    with session_with() as (session, _):
        session.workspace.set_editor_settings({"diagnostics": {"delay": 60_000}})
        preview = with_preview(session)
        opened(session, URI, GOOD)
        previews = session.previews
        previews.saved(URI)
        previews.set_parameter(URI, "length", 1.0)
        for listener in session.on_cursor:
            listener(URI, "link", "upper")
        await previews.stop()
        assert preview.calls == []
        assert await previews.open(URI) == f"address of {URI}"
        assert preview.calls[:2] == [("start",), ("show", URI, GOOD, None, "arm")]
        async with asyncio.timeout(60):
            while ("show", URI, GOOD, 0, "arm") not in preview.calls:
                await asyncio.sleep(0.001)
        assert await previews.open(URI, "https://editor.example") == f"address of {URI}"
        assert preview.calls.count(("start",)) == 1
        assert ("admit", "https://editor.example") in preview.calls
        n_before = len(preview.calls)
        previews.saved(URI)
        previews.set_parameter(URI, "length", 1.0)
        for listener in session.on_cursor:
            listener(URI, "link", "upper")
        await asyncio.sleep(0)
        told = [call for call in preview.calls[n_before:] if call[0] != "show"]
        assert told == [("saved", URI), ("set", URI, ("length", 1.0)),
                        ("highlight", URI, "link", "upper")]  # fmt: skip
        await session.close()
        assert preview.calls[-1] == ("stop",)


async def test_what_cannot_be_shown_is_refused_in_a_sentence() -> None:
    with session_with() as (session, _):
        preview = with_preview(session)
        opened(session, "untitled:kindsl.toml", "")
        opened(session, URI, GOOD)
        for uri in ("untitled:absent", "untitled:kindsl.toml"):
            with pytest.raises(RequestFailed, match="is not a document that can be shown"):
                await session.previews.open(uri)
        with pytest.raises(RequestFailed, match="'ftp:' is no origin"):
            await session.previews.open(URI, "ftp:")
        assert ("show", URI, GOOD, None, "arm") not in preview.calls
    for fault in (ImportError("x"), OSError("no port"), RuntimeError("no meshcat")):
        with session_with() as (session, _):
            with_preview(session, fault)
            opened(session, URI, GOOD)
            with pytest.raises(RequestFailed, match=f"the preview cannot start: {fault}"):
                await session.previews.open(URI)
    with session_with() as (session, _):

        def missing(*_: object) -> Any:
            raise ImportError("no", name="tornado")

        session.surroundings = session.surroundings._replace(new_previews=missing)
        opened(session, URI, GOOD)
        with pytest.raises(RequestFailed, match=r"needs tornado; install with: pip install"):
            await session.previews.open(URI)


async def test_a_click_shows_the_place_in_the_editor_without_leaving_it() -> None:
    for capabilities in (showing(), None):
        with session_with(capabilities) as (session, told):
            opened(session, URI, GOOD)
            session.previews.reveal("untitled:absent", Span(0, 5), None)
            session.previews.reveal(URI, Span(0, 5), None)
            if capabilities is None:
                await asyncio.sleep(0.01)
                assert told.named("window_show_document") == []
            else:
                (shown,) = await until_told(told, "window_show_document")
                span = types.Range(types.Position(0, 0), types.Position(0, 5))
                assert shown == types.ShowDocumentParams(URI, False, True, span)


async def test_what_was_dragged_is_written_into_the_version_that_it_was_made_for() -> None:
    with session_with(of_versions()) as (session, told):
        opened(session, URI, GOOD)
        told.answers["workspace_apply_edit"] = types.ApplyWorkspaceEditResult(applied=True)
        assert await session.previews.write(URI, WRITING) == ""
        (params,) = told.named("workspace_apply_edit")
        assert params.label == "Move the elbow"
        for uri, writing in (
            ("untitled:absent", WRITING),
            (URI, WRITING._replace(text=f"{GOOD}\n")),
        ):
            why = await session.previews.write(uri, writing)
            assert why == "the document has changed in the meantime"
        assert len(told.named("workspace_apply_edit")) == 1


@pytest.mark.parametrize("answer", [types.ApplyWorkspaceEditResult(applied=True), REFUSAL])
async def test_values_are_kept_in_the_file_that_is_there(tmp_path: Path, answer: Any) -> None:
    file, robot = tmp_path / "kindsl.toml", tmp_path / "arm.kindsl"
    file.write_text("[parameters]\n")
    with session_with(of_versions()) as (session, told):
        told.answers["workspace_apply_edit"] = answer
        session.workspace.add_folders([folder_of(tmp_path)])
        opened(session, robot.as_uri(), UNBOUND)
        assert session.previews.keep(robot.as_uri(), WANTED) == ""
        (params,) = await until_told(told, "workspace_apply_edit")
        assert params.label == "Give parameters values"
        (change,) = params.edit.document_changes
        assert change.text_document.uri == file.as_uri()
        assert [edit.new_text.strip() for edit in change.edits] == ["length = 2.0"]


async def test_values_are_kept_in_a_new_file_where_the_client_makes_one(tmp_path: Path) -> None:
    robot = tmp_path / "arm.kindsl"
    by_hand = parameter_table(WANTED.values)
    assert "length = 2.0" in by_hand
    makes = of_versions()
    assert makes.workspace is not None and makes.workspace.workspace_edit is not None
    makes.workspace.workspace_edit.resource_operations = [types.ResourceOperationKind.Create]
    for capabilities, kept in ((makes, ""), (of_versions(), by_hand), (None, by_hand)):
        with session_with(capabilities) as (session, told):
            session.workspace.add_folders([folder_of(tmp_path)])
            opened(session, robot.as_uri(), UNBOUND)
            opened(session, URI, UNBOUND)
            assert session.previews.keep(robot.as_uri(), WANTED) == kept
            assert session.previews.keep(URI, WANTED) == by_hand
            assert session.previews.keep("untitled:absent", WANTED) == by_hand
            if kept:
                await asyncio.sleep(0.01)
                assert told.named("workspace_apply_edit") == []
            else:
                (params,) = await until_told(told, "workspace_apply_edit")
                creation, change = params.edit.document_changes
                assert (
                    creation.uri == change.text_document.uri == f"{tmp_path.as_uri()}/kindsl.toml"
                )
                assert [e.new_text for e in change.edits] == ["[parameters]\nlength = 2.0\n"]


async def test_a_pose_is_kept_in_the_file_that_is_there_or_told(tmp_path: Path) -> None:
    file, robot = tmp_path / "kindsl.toml", tmp_path / "arm.kindsl"
    pose = KeepPose("stand", {"shoulder": 0.5})
    by_hand = pose_table(*pose)
    with session_with(of_versions()) as (session, told):
        session.workspace.add_folders([folder_of(tmp_path)])
        opened(session, robot.as_uri(), UNBOUND)
        opened(session, URI, UNBOUND)
        for uri in (robot.as_uri(), URI, "untitled:absent"):
            assert session.previews.keep(uri, pose) == by_hand
        file.write_text("wrong = 1\n")
        assert session.previews.keep(robot.as_uri(), pose) == by_hand
    file.write_text("[parameters]\n")
    with session_with(of_versions()) as (session, told):
        session.workspace.add_folders([folder_of(tmp_path)])
        opened(session, robot.as_uri(), UNBOUND)
        assert session.previews.keep(robot.as_uri(), pose) == ""
        (params,) = await until_told(told, "workspace_apply_edit")
        assert params.label == "Keep pose 'stand'"
        (change,) = params.edit.document_changes
        assert change.text_document.uri == file.as_uri()
        assert "shoulder = 0.5" in "".join(edit.new_text for edit in change.edits)
