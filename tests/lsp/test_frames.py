"""Bytes that do not keep to the protocol: what is understood, what is skipped, what is logged."""

import asyncio
import json
import logging
from typing import Any

import pytest

from kindsl.frontends.lsp.server import KindslLanguageServer
from kindsl.frontends.lsp.wire.transport import read_messages

BODIES = [b'{"a": 1}', b'{"b": "\xc3\xa9"}', b"[]"]


async def read(data: bytes, limit: int = 1 << 10) -> list[bytes]:
    """Return the bodies that are made out in some input."""
    reader = asyncio.StreamReader(limit=limit)
    reader.feed_data(data)
    reader.feed_eof()
    found: list[bytes] = []

    def receive(body: bytes) -> bool:
        found.append(body)
        return True

    await asyncio.wait_for(read_messages(reader, receive), 20)
    return found


def framed(body: bytes, length: int | None = None) -> bytes:
    return b"Content-Length: %d\r\n\r\n%b" % (len(body) if length is None else length, body)


class TestHeaders:
    async def test_bodies_are_read_one_after_the_other(self) -> None:
        assert await read(b"".join(map(framed, BODIES))) == BODIES

    @pytest.mark.parametrize("ends", [("\n", "\n"), ("\r\n", "\n"), ("\n", "\r\n")], ids=repr)
    async def test_line_ends_without_cr_are_understood(
        self, ends: tuple[str, str], caplog: pytest.LogCaptureFixture
    ) -> None:
        frames = [
            f"X: 1{ends[0]}Content-Length: {len(body)}{ends[0]}{ends[1]}".encode() + body
            for body in BODIES
        ]
        assert await read(b"".join(frames)) == BODIES
        assert caplog.records == []

    async def test_a_header_in_order_is_not_logged(self, caplog: pytest.LogCaptureFixture) -> None:
        await read(b"X: 1\r\ncontent-LENGTH:2 \r\nY: 2\r\n\r\n[]" + framed(b"[]"))
        assert caplog.records == []

    @pytest.mark.parametrize("length", ["-5", "five", "", "1 2", "9" * 12, "9" * 5000])
    async def test_a_length_that_makes_no_sense_is_skipped(self, length: str) -> None:
        head = f"Content-Length: {length}\r\n\r\n".encode()
        assert await read(head + framed(b"[]"), 1 << 14) == [b"[]"]

    async def test_a_line_longer_than_any_header_is_skipped(self) -> None:
        assert await read(b"x" * 5000 + b"\r\n\r\n" + framed(b"[]")) == [b"[]"]

    async def test_blank_lines_between_messages_are_passed_over(self) -> None:
        assert await read(b"\r\n" + framed(b"[]") + b"\n\n" + framed(b"{}")) == [b"[]", b"{}"]


class TestWrongLengths:
    @pytest.mark.parametrize("length", range(8))
    async def test_a_body_longer_than_told_costs_that_message_only(
        self, length: int, caplog: pytest.LogCaptureFixture
    ) -> None:
        found = await read(framed(b'{"a": 1}', length) + framed(b"[]") + framed(b"{}"))
        assert found == [b'{"a": 1}'[:length], b"[]", b"{}"]
        assert len(caplog.records) == 1

    @pytest.mark.parametrize("length", range(9, 60))
    async def test_a_body_shorter_than_told_costs_what_it_swallows(self, length: int) -> None:
        first, *rest = await read(framed(b'{"a": 1}', length) + 5 * framed(b'{"b": 2}'))
        assert len(first) == length
        assert rest[-1] == b'{"b": 2}'

    @pytest.mark.parametrize(
        "end", [b"", b"Content-Len", b"Content-Length: 10\r\n\r\n[1,", b"\r\n"]
    )
    async def test_an_input_that_ends_in_a_message_ends_the_reading(self, end: bytes) -> None:
        assert await read(framed(b"[]") + end) == [b"[]"]


class TestOneLogLine:
    """What a client gets no answer to is told once, without a traceback."""

    @pytest.mark.parametrize(
        "message",
        [
            {"id": [], "result": 1},
            {"id": {}, "error": {"code": 1, "message": "no"}},
            {"id": 77, "result": None},
            {"id": None, "error": {"code": -32700, "message": "no"}},
            {"method": "$/cancelRequest", "params": {"id": []}},
            {"method": "$/cancelRequest", "params": {"id": None}},
        ],
        ids=repr,
    )
    async def test_of_an_answer_or_a_cancellation_of_nothing(
        self, message: dict[str, Any], caplog: pytest.LogCaptureFixture
    ) -> None:
        with caplog.at_level(logging.WARNING):
            body = json.dumps({"jsonrpc": "2.0", **message})
            assert await answers(body.encode()) == []
        assert [record.exc_info for record in caplog.records] in ([None], [])
        assert len(caplog.text.splitlines()) == len(caplog.records)

    async def test_of_a_change_of_a_document_that_is_not_open(
        self, caplog: pytest.LogCaptureFixture
    ) -> None:
        identifier = {"uri": "untitled:never-opened", "version": 1}
        params = {"textDocument": identifier, "contentChanges": [{"text": "Robot"}]}
        body = {"jsonrpc": "2.0", "method": "textDocument/didChange", "params": params}
        assert await answers(json.dumps(body).encode()) == []
        assert len(caplog.text.splitlines()) == 1
        assert "'untitled:never-opened' is not open" in caplog.text


@pytest.mark.parametrize(
    ("text", "is_id"),
    [
        ("1", True),
        ("-1.5", True),
        ('""', True),
        ("9" * 400, True),
        ("true", False),
        ("1e999", False),
        ("null", False),
    ],
)
async def test_a_string_or_a_number_names_a_request(text: str, is_id: bool) -> None:
    body = f'{{"jsonrpc": "2.0", "id": {text}, "method": "kindsl/unknown"}}'
    [answer] = await answers(body.encode())
    assert answer["error"]["code"] == (-32601 if is_id else -32600)
    assert answer["id"] == (json.loads(text) if is_id else None)


async def answers(body: bytes) -> list[dict[str, Any]]:
    """Return what a server that has been initialized answers."""
    protocol = KindslLanguageServer().protocol
    protocol.is_initialized = True
    sent: list[bytes] = []

    class Writer:
        def write(self, data: bytes) -> None:
            sent.append(data)

        def close(self) -> None: ...

    protocol.set_writer(Writer())
    assert protocol.receive(body)
    await asyncio.sleep(0)
    return [json.loads(message.partition(b"\r\n\r\n")[2]) for message in sent]
