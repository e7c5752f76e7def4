"""What is told while someone types in a line, and when the rest comes."""

import asyncio
from pathlib import Path
from typing import Any

import pytest
from lsprotocol import types
from tests.cli.samples import GOOD
from tests.lsp.sessions import Told, opened, session_with
from tests.lsp.test_publishing import PUBLISH, URI, codes, published, pulling, settled
from tests.typist.squiggles import passing_squiggles
from tests.typist.typist import lines_to_type

from kindsl.frontends.lsp.handlers.diagnostics import pull
from kindsl.frontends.lsp.session import calm
from kindsl.frontends.lsp.session.session import Session

EXAMPLES = Path(__file__).parents[2] / "examples"
AT_ONCE = {"diagnostics": {"delay": 0}}
ENDLESS = 3600.0
ERROR = "KD001"


def type_in(session: Session, version: int, place: str, old: str, new: str) -> None:
    """Replace a text that stands behind a place in the document."""
    document = session.documents.get(URI)
    assert document is not None
    start = document.text.index(place) + len(place)
    assert document.text.startswith(old, start)
    span = types.Range(document.position(start), document.position(start + len(old)))
    change = types.TextDocumentContentChangePartial(span, new)
    identifier = types.VersionedTextDocumentIdentifier(version, URI)
    session.documents.change(types.DidChangeTextDocumentParams(identifier, [change]))


async def told_for(told: Told, version: int, n: int = 1) -> list[Any]:
    """Wait until something was published so often for a version; return its codes."""
    async with asyncio.timeout(60):
        while len(found := [p for p in told.named(PUBLISH) if p.get("version") == version]) < n:
            await asyncio.sleep(0.002)
    return [codes(each) for each in found]


def test_no_squiggle_passes_while_a_robot_is_typed() -> None:
    """Every version is checked, as for a hand that rests between any two keys, but not long."""
    lines = lines_to_type((EXAMPLES / "fancy.kindsl").read_text())[:60]
    assert passing_squiggles(lines) == []
    assert len(passing_squiggles(lines[:8], is_calm=False)) > 20


def test_the_page_says_how_long_it_lasts() -> None:
    page = (Path(__file__).parents[2] / "docs" / "editors.md").read_text("utf-8")
    assert f"or {calm.PATIENCE:g} s after the last" in " ".join(page.split())


async def test_an_error_in_the_line_of_the_edit_comes_when_the_hand_rests(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(calm, "PATIENCE", 0.05)
    with session_with() as (session, told):
        session.workspace.set_editor_settings(AT_ONCE)
        opened(session, URI, GOOD)
        assert await told_for(told, 1) == [[]]
        type_in(session, 2, "id = ", "1", "")
        assert await told_for(told, 2, 2) == [[], [ERROR]]
        type_in(session, 3, "id = ", "", "1")
        assert await told_for(told, 3) == [[]]
        await settled(session)
        assert len(told.named(PUBLISH)) == 4


async def test_an_error_comes_when_the_edit_leaves_the_line(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(calm, "PATIENCE", ENDLESS)
    with session_with() as (session, told):
        session.workspace.set_editor_settings(AT_ONCE)
        opened(session, URI, GOOD)
        await published(told, URI)
        type_in(session, 2, "id = ", "1", "")
        assert await told_for(told, 2) == [[]]
        type_in(session, 3, "CoM = (", "", " ")
        assert await told_for(told, 3) == [[ERROR]]
        type_in(session, 4, "id = ", "", "1")
        assert await told_for(told, 4) == [[]]
        type_in(session, 5, "id = ", "1", "\n")
        assert (await told_for(told, 5))[0]
        session.documents.close(URI)
        opened(session, URI, GOOD.replace("mass = 1", "id = "), 6)
        assert (await told_for(told, 6))[0]


async def test_a_client_that_pulls_is_asked_to_pull_again_when_the_hand_rests(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(calm, "PATIENCE", 0.05)
    with session_with(pulling(is_told=True)) as (session, told):
        session.workspace.set_editor_settings(AT_ONCE)
        opened(session, URI, GOOD)

        async def pulled() -> list[str]:
            params = types.DocumentDiagnosticParams(types.TextDocumentIdentifier(URI))
            report = await pull(session, params)
            return [each["code"] for each in report["items"]]

        assert await pulled() == []
        type_in(session, 2, "id = ", "1", "")
        assert await pulled() == []
        async with asyncio.timeout(60):
            while not told.named("workspace_diagnostic_refresh"):
                await asyncio.sleep(0.002)
        assert await pulled() == [ERROR]


async def test_a_client_that_cannot_be_asked_again_is_answered_in_full() -> None:
    with session_with(pulling(is_told=False)) as (session, _):
        opened(session, URI, GOOD)
        type_in(session, 2, "id = ", "1", "")
        params = types.DocumentDiagnosticParams(types.TextDocumentIdentifier(URI))
        assert [each["code"] for each in (await pull(session, params))["items"]] == [ERROR]
