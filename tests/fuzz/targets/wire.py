"""Bytes from an editor: each request gets one answer, nothing stops the server.

Input: what arrives on stdin; the start of a session is there already.
"""

import asyncio
import json
import logging
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from kindsl.frontends.lsp.wire.protocol import Editor, KindslProtocol
from kindsl.frontends.lsp.wire.transport import read_messages


class _Output:
    """What was sent; fails for anything that is no frame."""

    def __init__(self) -> None:
        self.messages: list[dict[str, Any]] = []

    def write(self, data: bytes) -> None:
        head, _, body = data.partition(b"\r\n\r\n")
        assert head == b"Content-Length: %d" % len(body)
        message = json.loads(body)
        assert message["jsonrpc"] == "2.0"
        self.messages.append(message)

    def close(self) -> None:
        """Nothing to close."""

    async def flush(self) -> None:
        """All is sent."""


class _Faults(logging.Handler):
    """Keeps what was logged as a fault of our own."""

    def __init__(self) -> None:
        super().__init__()
        self.records: list[logging.LogRecord] = []

    def emit(self, record: logging.LogRecord) -> None:
        if record.exc_info:
            self.records.append(record)


def one_input(data: bytes) -> None:
    """Serve what arrives until it ends; look at all documents that are open then."""
    output = _Output()
    with _faults() as faults:
        asyncio.run(_serve(framed(_INITIALIZE) + framed(_OPEN) + data, output))
    for record in faults.records:
        assert record.exc_info and record.exc_info[1]
        raise record.exc_info[1]
    answered = [message["id"] for message in output.messages if "method" not in message]
    assert answered[:1] == ["first"]


def framed(body: str) -> bytes:
    """Return a message as it comes over the wire."""
    return b"Content-Length: %d\r\n\r\n%b" % (len(body.encode()), body.encode())


_INITIALIZE = (
    '{"jsonrpc":"2.0","id":"first","method":"initialize",'
    '"params":{"processId":null,"rootUri":null,"capabilities":{}}}'
)
_OPEN = (
    '{"jsonrpc":"2.0","method":"textDocument/didOpen","params":{"textDocument":'
    '{"uri":"untitled:a","languageId":"k","version":1,"text":"Robot R {\\n\U0001f600\\r}"}}}'
)


# What knows nothing of a session: the converter learns each type but once, which takes longest.
_EDITOR = Editor()
_CONVERTER = _EDITOR.protocol._converter


async def _serve(data: bytes, output: _Output) -> None:
    protocol = _EDITOR.protocol = KindslProtocol(_EDITOR, _CONVERTER)
    protocol.set_writer(output)
    reader = asyncio.StreamReader(limit=1 << 24)
    reader.feed_data(data)
    reader.feed_eof()
    await read_messages(reader, protocol.receive)
    for _ in range(3):
        await asyncio.sleep(0)
    for document in protocol.documents:
        assert document.tree.text == document.text


@contextmanager
def _faults() -> Iterator[_Faults]:
    logger, faults = logging.getLogger("kindsl.frontends.lsp.wire"), _Faults()
    logger.addHandler(faults)
    logger.propagate = False
    try:
        yield faults
    finally:
        logger.removeHandler(faults)
        logger.propagate = True
