"""Messages of the preview's page: whatever it sends, what is shown can be sent back.

Input: messages, one a line; what they drag is written into the document at once.
"""

import asyncio
import json
from collections.abc import Mapping
from contextlib import suppress

from tests.support import robots

from kindsl.frontends.preview.channel import Tab
from kindsl.frontends.preview.documents import DocumentPreviews
from kindsl.frontends.preview.requests import BadRequestError, Request, parse_request
from kindsl.frontends.preview.steps import Writing
from kindsl.judgement.analysis.analysis import analyse
from kindsl.language.text.edits import apply_edits
from kindsl.robots.scene.encoding import as_json, encode
from kindsl.robots.scene.messages import Change, Part

_KEY = "untitled:arm"
_MOST_MESSAGES = 20
_ANALYSIS = analyse(robots.ARM)
_LOOP = asyncio.Runner()
_MOST_KNOWN = 10_000
_known: set[Part] = set()


class _Previews(DocumentPreviews):
    """Previews whose documents are written as a page wants, without an editor or a socket."""

    def __init__(self) -> None:
        super().__init__(lambda *_: None, self._edit, beside=asyncio.to_thread)
        self.on_write = lambda *_: "line"

    async def start(self) -> str:
        return ""

    async def stop(self) -> None:
        """Nothing runs."""

    def url(self, key: str) -> str:
        return key

    def admit(self, origin: str) -> None:
        """Nobody is outside."""

    async def _edit(self, key: str, writing: Writing) -> str:
        analysis = analyse(apply_edits(writing.text, writing.edits))
        await self.show(key, analysis, analysis.findings)
        return ""


def one_input(data: bytes) -> None:
    """Show a robot with a parameter, receive messages, and send all that is shown."""
    lines = data.decode("utf-8", "surrogateescape").split("\n")[:_MOST_MESSAGES]
    requests: list[Request] = []
    for line in lines:
        with suppress(BadRequestError):
            requests.append(parse_request(line))
    if requests:
        _LOOP.run(_receive(requests))


async def _receive(requests: list[Request]) -> None:
    previews, sent = _Previews(), list[Part]()
    await previews.show(_KEY, _ANALYSIS, _ANALYSIS.findings)
    document = previews.document(None)
    assert document is not None

    async def write(change: Change) -> None:
        sent.extend(change.parts)

    tab = Tab(write)
    document.channel.join(tab)
    writer = asyncio.ensure_future(tab.run())
    for request in requests:
        previews.receive(document, tab, request)
        await _gestures_done(writer)
    await asyncio.sleep(0)
    writer.cancel()
    for message in {id(each): each for each in (*sent, *document.channel.state)}.values():
        if not _is_known(message):
            _check(message)


async def _gestures_done(writer: "asyncio.Task[None]") -> None:
    mine = {asyncio.current_task(), writer}
    await asyncio.gather(*(task for task in asyncio.all_tasks() if task not in mine))


def _is_known(message: Part) -> bool:
    """Return whether an equal message was checked before; most pictures are nearly the same."""
    try:
        is_known = message in _known
    except TypeError:
        return False  # it has a dictionary
    if len(_known) >= _MOST_KNOWN:
        _known.clear()
    _known.add(message)
    return is_known


def _check(message: Part) -> None:
    """Check that a message can be sent."""
    assert encode(message)
    decoded = json.loads(as_json(message), parse_constant=_no_constant)
    assert isinstance(decoded, Mapping) and decoded["type"] == message.type


def _no_constant(word: str) -> float:
    raise AssertionError(f"{word} is not JSON")
