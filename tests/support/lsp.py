"""A language client that sees the bytes: raw JSON-RPC over the server's real stdio."""

import json
import os
import queue
import subprocess
import sys
import threading
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from tests.delays import injected
from tests.support.lsp_messages import faults
from tests.support.prepared import PreparedServer

_LATE = str(Path(injected.__file__).with_name("server.py"))
SERVER = (
    sys.executable,
    *((_LATE,) if injected.WHO else ("-m", "kindsl.frontends.cli.language_server")),
)
TIMEOUT = 60.0


class RawClient:
    """Sends what it is told, well-formed or not, and keeps everything that comes back."""

    def __init__(self, server: Sequence[str] | PreparedServer = SERVER) -> None:
        """Talk to a server, or to the one that a command starts."""
        pipe = subprocess.PIPE
        self.process = (
            server
            if isinstance(server, PreparedServer)
            else subprocess.Popen(server, stdin=pipe, stdout=pipe, stderr=pipe)
        )
        self.messages: list[dict[str, Any]] = []
        self.asked: dict[Any, str] = {}
        self.configuration: dict[str | None, Any] = {}
        self._arrived: queue.Queue[dict[str, Any] | None] = queue.Queue()
        self._held: bytearray | None = None
        self._ids = 0
        self._errors: list[bytes] = []
        self._threads = [
            threading.Thread(target=work, daemon=True) for work in (self._read, self._read_errors)
        ]
        for thread in self._threads:
            thread.start()

    def send_bytes(self, data: bytes) -> None:
        if self._held is not None:
            self._held += data
            return
        assert self.process.stdin is not None
        self.process.stdin.write(data)
        self.process.stdin.flush()

    @contextmanager
    def in_one_piece(self) -> Iterator[None]:
        """Send all that is sent meanwhile together, without a pause that a busy machine makes."""
        held = self._held = bytearray()
        yield
        self._held = None
        self.send_bytes(bytes(held))

    def send_body(self, body: bytes) -> None:
        self.send_bytes(b"Content-Length: %d\r\n\r\n%b" % (len(body), body))

    def send(self, **message: Any) -> None:
        if isinstance(message.get("id"), str | int) and "method" in message:
            self.asked[message["id"]] = message["method"]
        self.send_body(json.dumps({"jsonrpc": "2.0", **message}).encode())

    def notify(self, method: str, params: Any = None) -> None:
        self.send(method=method, params=params if params is not None else {})

    def start(self, method: str, params: Any = None) -> int:
        """Send a request; return its id."""
        self._ids += 1
        self.send(id=self._ids, method=method, params=params if params is not None else {})
        return self._ids

    def request(self, method: str, params: Any = None) -> Any:
        """Send a request and return its result; a refusal is an error."""
        answer = self.answer(self.start(method, params))
        assert "error" not in answer, answer["error"]
        return answer["result"]

    def refusal(self, method: str, params: Any = None) -> dict[str, Any]:
        """Send a request that must be refused; return the error."""
        error: dict[str, Any] = self.answer(self.start(method, params))["error"]
        return error

    def answer(self, msg_id: Any) -> dict[str, Any]:
        return self.wait(lambda m: "method" not in m and m.get("id") == msg_id)

    def notification(self, method: str) -> Any:
        """Wait for a notification or request not seen yet; return its parameters."""
        return self.wait(lambda m: m.get("method") == method)["params"]

    def diagnostics(self, uri: str) -> list[dict[str, Any]]:
        """Wait for the next diagnostics that are published for a document."""
        message = self.wait(
            lambda m: (
                m.get("method") == "textDocument/publishDiagnostics" and m["params"]["uri"] == uri
            )
        )
        found: list[dict[str, Any]] = message["params"]["diagnostics"]
        return found

    def wait(self, is_wanted: Any, timeout: float = TIMEOUT) -> dict[str, Any]:
        """Return and take out the first message that is wanted."""
        while True:
            for index, message in enumerate(self.messages):
                if is_wanted(message):
                    return self.messages.pop(index)
            message = self._arrived.get(timeout=timeout)
            assert message is not None, f"the server ended: {self.stderr}"
            self.keep(message)

    def codes(self, uri: str) -> list[str]:
        """Wait for the next diagnostics that are published for a document; return their codes."""
        return [found.get("code", "") for found in self.diagnostics(uri)]

    def drain(self) -> list[dict[str, Any]]:
        """Return and take out everything that has come before a round trip's answer."""
        self.answer(self.start("kindsl/unknown"))
        messages, self.messages = self.messages, []
        return messages

    def open(self, uri: str, text: str, version: int = 1) -> None:
        item = {"uri": uri, "languageId": "kinematics-dsl", "version": version, "text": text}
        self.notify("textDocument/didOpen", {"textDocument": item})

    def change(self, uri: str, version: int, *changes: dict[str, Any]) -> None:
        identifier = {"uri": uri, "version": version}
        self.notify(
            "textDocument/didChange", {"textDocument": identifier, "contentChanges": changes}
        )

    def close(self, uri: str) -> None:
        self.notify("textDocument/didClose", {"textDocument": {"uri": uri}})

    def initialize(self, capabilities: dict[str, Any] | None = None, **more: Any) -> dict[str, Any]:
        params = {"processId": os.getpid(), "rootUri": None, "capabilities": capabilities or {}}
        result: dict[str, Any] = self.request("initialize", params | more)
        self.notify("initialized")
        return result

    def wait_for_end(self) -> int:
        code = self.process.wait(TIMEOUT)
        for thread in self._threads:
            thread.join(TIMEOUT)
        return code

    def kill(self) -> None:
        self.process.kill()
        self.wait_for_end()
        for stream in (self.process.stdin, self.process.stdout, self.process.stderr):
            assert stream is not None
            try:
                stream.close()
            except BrokenPipeError:
                continue

    @property
    def stderr(self) -> str:
        return b"".join(self._errors).decode()

    def keep(self, message: dict[str, Any]) -> None:
        if "method" in message and "id" in message:
            self._reply(message)
        self.messages.append(message)

    def _reply(self, message: dict[str, Any]) -> None:
        """Answer what the server asks: the configuration by scope; everything else is fine."""
        result: Any = None
        if message["method"] == "workspace/configuration":
            scopes = [item.get("scopeUri") for item in message["params"]["items"]]
            result = [self.configuration.get(scope) for scope in scopes]
        elif message["method"] == "workspace/applyEdit":
            result = {"applied": True}
        elif message["method"] == "window/showDocument":
            result = {"success": True}
        self.send(id=message["id"], result=result)

    def _read(self) -> None:
        stream = self.process.stdout
        assert stream is not None
        while header := stream.readline():
            assert header.lower().startswith(b"content-length:"), header
            while stream.readline() != b"\r\n":
                continue
            self._arrived.put(json.loads(stream.read(int(header.split(b":")[1]))))
        self._arrived.put(None)

    def _read_errors(self) -> None:
        assert self.process.stderr is not None
        self._errors.extend(iter(self.process.stderr.readline, b""))


class StrictClient(RawClient):
    """Also holds what comes against the specification."""

    def keep(self, message: dict[str, Any]) -> None:
        found = list(faults(message, self.asked))
        assert found == [], found
        super().keep(message)


@contextmanager
def raw_client(*options: str) -> Iterator[RawClient]:
    """A server with nothing said to it yet."""
    client = StrictClient((*SERVER, *options) if injected.WHO else PreparedServer(*options))
    try:
        yield client
    finally:
        client.kill()


@contextmanager
def running_server() -> Iterator[RawClient]:
    """A server with nothing said to it yet, whose many answers others hold against the rules."""
    client = RawClient(SERVER if injected.WHO else PreparedServer())
    try:
        yield client
    finally:
        client.kill()


@contextmanager
def ready_client(capabilities: dict[str, Any] | None = None, **more: Any) -> Iterator[RawClient]:
    """A server that has been initialized."""
    with raw_client() as client:
        client.initialize(capabilities, **more)
        yield client
