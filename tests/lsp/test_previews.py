"""Which versions are drawn while someone types faster than they can be drawn."""

import asyncio
from typing import Any, ClassVar

import pytest
from lsprotocol import types

pytest.importorskip("tornado", reason="the preview needs tornado")

from kindsl.frontends.lsp.server import KindslLanguageServer
from kindsl.frontends.lsp.session.session import Session
from kindsl.frontends.preview import server as preview_server

URI = "untitled:typed"
ROBOT = "Robot R {{\nRobotBase base {{ children {{ }} }}\n// {}\n}}\n"


class Slow:
    """A preview that takes its time: a version is drawn when it is let go on."""

    made: ClassVar[list["Slow"]] = []

    def __init__(self, *_: object, **__: object) -> None:
        self.made.append(self)
        self.begun: list[str] = []
        self.told: list[str] = []
        self.may_draw = asyncio.Semaphore(0)

    async def start(self) -> None: ...

    async def stop(self) -> None: ...

    def at(self, _: str) -> object:
        return self if self.begun else None

    def url(self, _: str) -> str:
        return "address"

    async def show(self, _key: str, analysis: Any, findings: Any, _label: str) -> None:
        comment = analysis.text.partition("// ")[2].split()[0]
        self.begun.append(comment)
        await self.may_draw.acquire()
        if findings is not None:
            self.told.append(comment)


@pytest.fixture
async def session(monkeypatch: pytest.MonkeyPatch) -> Session:
    Slow.made.clear()
    monkeypatch.setattr(preview_server, "PreviewServer", Slow)
    session = KindslLanguageServer().session
    session.loop = asyncio.get_running_loop()
    session.workspace.set_editor_settings({"diagnostics": {"delay": 60_000}})
    session.documents.open(types.TextDocumentItem(URI, "kindsl", 0, ROBOT.format("first")))
    return session


@pytest.fixture
async def slow(session: Session) -> Slow:
    opening = asyncio.ensure_future(session.previews.open(URI))
    await until(lambda: Slow.made or opening.done())
    (slow,) = Slow.made
    slow.may_draw.release()
    await opening
    # What was found is listed then, which must not come between what a test types.
    slow.may_draw.release()
    await until(lambda: slow.told)
    slow.begun.pop()
    slow.told.clear()
    return slow


async def test_a_page_lists_what_is_wrong_though_it_was_told_before(session: Session) -> None:
    session.on_findings.clear()
    opening = asyncio.ensure_future(session.previews.open(URI))
    await until(lambda: Slow.made or opening.done())
    (slow,) = Slow.made
    for _ in range(2):
        slow.may_draw.release()
    await opening
    await until(lambda: slow.told == ["first"])


def type_comment(session: Session, version: int, comment: str) -> None:
    whole = types.TextDocumentContentChangeWholeDocument(ROBOT.format(comment))
    identifier = types.VersionedTextDocumentIdentifier(version, URI)
    session.documents.change(types.DidChangeTextDocumentParams(identifier, [whole]))


async def until(condition: Any) -> None:
    async with asyncio.timeout(60):
        while not condition():
            await asyncio.sleep(0.001)


async def test_of_what_is_typed_while_a_version_is_drawn_only_the_newest_is_drawn(
    session: Session, slow: Slow
) -> None:
    type_comment(session, 1, "one")
    await until(lambda: "one" in slow.begun)
    for version in range(2, 20):
        type_comment(session, version, f"version-{version}")
    type_comment(session, 20, "last")
    last = session.documents.get(URI)
    assert last is not None
    await session.analyses.of(last)
    await asyncio.sleep(0.05)
    assert slow.begun == ["first", "one"]
    slow.may_draw.release()
    await until(lambda: "last" in slow.begun)
    slow.may_draw.release()
    assert slow.begun == ["first", "one", "last"]


async def test_the_first_keystroke_is_drawn_without_a_delay(session: Session, slow: Slow) -> None:
    type_comment(session, 1, "one")
    await until(lambda: "one" in slow.begun)
    assert slow.told == []


async def test_what_was_found_follows_unless_something_was_typed_since(
    session: Session, slow: Slow
) -> None:
    for _ in range(10):
        slow.may_draw.release()
    type_comment(session, 1, "one")
    one = session.documents.get(URI)
    assert one is not None
    await until(lambda: "one" in slow.begun)
    for listener in session.on_findings:
        listener(one, ())
    await until(lambda: "one" in slow.told)
    for listener in session.on_findings:
        listener(one, ())
    type_comment(session, 2, "two")
    await until(lambda: "two" in slow.begun)
    assert slow.told.count("one") == 1


async def test_new_settings_draw_again(session: Session, slow: Slow) -> None:
    for _ in range(10):
        slow.may_draw.release()
    drawn = len(slow.begun)
    session.previews.refresh()
    await until(lambda: len(slow.begun) > drawn)


async def test_an_answer_goes_before_a_picture(session: Session, slow: Slow) -> None:
    for _ in range(10):
        slow.may_draw.release()
    order: list[str] = []

    def handler(*_: object) -> None:
        order.append("answer")

    session.on_cursor.clear()
    drawn = slow.show

    async def show(*arguments: Any) -> None:
        order.append("picture")
        await drawn(*arguments)

    slow.show = show  # type: ignore[method-assign]
    type_comment(session, 1, "one")
    await session.ask_at_once(handler, URI, None)
    await until(lambda: "one" in slow.begun)
    assert order == ["answer", "picture"]
