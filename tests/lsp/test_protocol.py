"""The rules of the message loop, seen from the other end of a pipe."""

import json
import re
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from tests.support.lsp import RawClient, StrictClient, raw_client, ready_client

FAULTY = (sys.executable, str(Path(__file__).with_name("faulty_server.py")))
HOVER = {"textDocument": {"uri": "untitled:a"}, "position": {"line": 0, "character": 0}}


class SlowToAnswer(StrictClient):
    """Leaves what the server asks to the test."""

    def _reply(self, message: dict[str, Any]) -> None:
        pass


@pytest.fixture(scope="module")
def client() -> Iterator[RawClient]:
    with ready_client() as client:
        yield client


@pytest.fixture(scope="module")
def faulty() -> Iterator[RawClient]:
    client = StrictClient(FAULTY)
    client.initialize({"window": {"showMessage": {}}})
    yield client
    client.kill()


class TestLifeCycle:
    def test_a_request_before_initialize_is_refused(self) -> None:
        with raw_client() as client:
            assert client.refusal("textDocument/hover", HOVER)["code"] == -32002
            assert client.refusal("shutdown")["code"] == -32002
            client.notify("textDocument/didOpen", {})
            assert client.initialize()["capabilities"]

    def test_a_second_initialize_is_refused(self, client: RawClient) -> None:
        refusal = client.refusal(
            "initialize", {"processId": None, "rootUri": None, "capabilities": {}}
        )
        assert refusal["code"] == -32600

    def test_requests_after_shutdown_are_refused_and_exit_is_clean(self) -> None:
        with ready_client() as client:
            assert client.request("shutdown") is None
            assert client.refusal("textDocument/hover", HOVER)["code"] == -32600
            assert client.refusal("shutdown")["code"] == -32600
            client.open("untitled:a", "Robot")
            client.notify("exit")
            assert client.wait_for_end() == 0
            assert client.messages == []

    @pytest.mark.parametrize("is_initialized", [False, True])
    def test_exit_without_shutdown_is_a_failure(self, is_initialized: bool) -> None:
        with raw_client() as client:
            if is_initialized:
                client.initialize()
            client.notify("exit")
            assert client.wait_for_end() == 1

    def test_a_client_that_goes_away_ends_the_server(self) -> None:
        with ready_client() as client:
            assert client.process.stdin is not None
            client.process.stdin.close()
            assert client.wait_for_end() == 1

    def test_termination_is_orderly(self) -> None:
        with ready_client() as client:
            client.process.send_signal(signal.SIGTERM)
            assert client.wait_for_end() == 1
            assert "Traceback" not in client.stderr

    def test_the_server_ends_with_the_process_that_started_it(self) -> None:
        waiting = [sys.executable, "-c", "input()"]
        with subprocess.Popen(waiting, stdin=subprocess.PIPE) as editor, raw_client() as client:
            client.initialize(processId=editor.pid)
            assert client.refusal("kindsl/unknown")["code"] == -32601
            editor.kill()
            editor.wait()
            assert client.wait_for_end() == 1

    def test_the_server_ends_when_the_process_that_started_it_is_gone_already(self) -> None:
        gone = subprocess.Popen([sys.executable, "-c", ""])
        gone.wait()
        with raw_client() as client:
            # It may be gone before it could be told anything else.
            client.request("initialize", {"processId": gone.pid, "capabilities": {}})
            assert client.wait_for_end() == 1


class TestMalformedMessages:
    @pytest.mark.parametrize(
        "params", [{}, {"textDocument": 3}, [], "text", None, {**HOVER, "position": {"line": -1}}]
    )
    def test_invalid_parameters_are_refused(self, client: RawClient, params: object) -> None:
        client.send(id="x", method="textDocument/definition", params=params)
        assert client.answer("x")["error"]["code"] == -32602

    def test_the_refusal_names_what_is_wrong(self, client: RawClient) -> None:
        message = client.refusal("textDocument/hover", {"textDocument": {"uri": "untitled:a"}})[
            "message"
        ]
        assert "position" in message
        assert "Traceback" not in message

    def test_an_unknown_method_is_refused(self, client: RawClient) -> None:
        assert client.refusal("robot/dance")["code"] == -32601
        client.send(id="bare", method="robot/dance")
        assert client.answer("bare")["error"]["code"] == -32601

    def test_an_unknown_command_is_refused(self, client: RawClient) -> None:
        refusal = client.refusal("workspace/executeCommand", {"command": "robot.dance"})
        assert refusal["code"] == -32602

    def test_unknown_notifications_are_ignored(self, client: RawClient) -> None:
        client.notify("$/robot")
        client.notify("robot/dance")
        client.notify("textDocument/didOpen", {"wrong": True})
        client.notify("$/cancelRequest", {"id": 12345})
        assert client.drain() == []

    def test_text_that_is_no_json_is_refused(self, client: RawClient) -> None:
        client.send_body(b"{")
        assert client.answer(None)["error"]["code"] == -32700

    @pytest.mark.parametrize("body", [b"[]", b"3", b'{"method": "x"}', b'{"jsonrpc": "2.0"}'])
    def test_json_that_is_no_message_is_refused(self, client: RawClient, body: bytes) -> None:
        client.send_body(body)
        assert client.answer(None)["error"]["code"] == -32600

    def test_json_nested_too_deeply_is_refused(self, client: RawClient) -> None:
        client.send_body(b"[" * 100_000)
        assert client.answer(None)["error"]["code"] == -32700

    def test_a_nested_object_that_looks_like_a_message_is_only_data(
        self, client: RawClient
    ) -> None:
        inner = {"jsonrpc": "2.0", "id": 1, "method": "shutdown"}
        assert client.refusal("kindsl/unknown", inner)["code"] == -32601
        assert client.refusal("kindsl/unknown", inner)["code"] == -32601

    @pytest.mark.parametrize("msg_id", ["null", "true", "[]", "{}", "[1]", "NaN", "-Infinity"])
    def test_an_id_that_is_no_number_or_string_is_refused(
        self, client: RawClient, msg_id: str
    ) -> None:
        client.send_body(
            b'{"jsonrpc": "2.0", "id": %b, "method": "kindsl/unknown"}' % msg_id.encode()
        )
        refusal = client.answer(None)["error"]
        assert refusal == {"code": -32600, "message": "the request's id is not a number or string"}
        assert client.refusal("kindsl/unknown")["code"] == -32601


class TestFrames:
    def test_other_headers_and_cases_are_understood(self, client: RawClient) -> None:
        body = json.dumps({"jsonrpc": "2.0", "id": "h", "method": "kindsl/unknown"}).encode()
        head = "Content-Type: application/vscode-jsonrpc; charset=utf-8\r\ncontent-length: "
        client.send_bytes(f"{head}{len(body)}\r\n\r\n".encode() + body)
        assert client.answer("h")["error"]["code"] == -32601

    def test_messages_may_arrive_in_drops(self, client: RawClient) -> None:
        body = json.dumps({"jsonrpc": "2.0", "id": "d", "method": "kindsl/unknown"}).encode()
        for byte in b"Content-Length: %d\r\n\r\n" % len(body) + body:
            client.send_bytes(bytes([byte]))
        assert client.answer("d")["error"]["code"] == -32601

    def test_a_header_without_a_length_is_skipped(self, client: RawClient) -> None:
        client.send_bytes(b"X: 1\r\n\r\n")
        assert client.refusal("kindsl/unknown")["code"] == -32601

    def test_a_wrong_length_costs_messages_but_not_the_server(self, client: RawClient) -> None:
        body = json.dumps({"jsonrpc": "2.0", "id": "wrong", "method": "kindsl/unknown"}).encode()
        for length in (0, 20, len(body) - 1, len(body) + 1, 2 * len(body)):
            client.send_bytes(b"Content-Length: %d\r\n\r\n%b" % (length, body))
            for number in range(4):
                client.send(id=f"{length} {number}", method="kindsl/unknown")
            assert client.answer(f"{length} 3")["error"]["code"] == -32601
        assert client.answer(None)["error"]["code"] == -32700
        client.drain()

    def test_text_in_other_scripts_survives(self, client: RawClient) -> None:
        assert "'robôt/🤖'" in client.refusal("robôt/🤖")["message"]

    def test_a_client_that_does_not_read_does_not_block_the_server(self) -> None:
        with ready_client() as client:
            for _ in range(3000):
                client.start("kindsl/" + "x" * 2000)
            assert client.refusal("kindsl/unknown")["code"] == -32601


class TestFaults:
    @pytest.mark.parametrize(
        ("method", "sentence"),
        [
            ("test/fail", "internal error: first line"),
            ("test/failLater", "internal error: 'later'"),
            ("test/notJson", "internal error: Out of range float values are not JSON compliant"),
        ],
    )
    def test_a_fault_is_one_clean_error(
        self, faulty: RawClient, method: str, sentence: str
    ) -> None:
        refusal = faulty.refusal(method)
        assert refusal["code"] == -32603
        # From 3.13 on Python says which value it was.
        assert refusal["message"].removesuffix(": nan") == sentence

    def test_a_fault_in_a_command_is_one_clean_error(self, faulty: RawClient) -> None:
        refusal = faulty.refusal("workspace/executeCommand", {"command": "test.fail"})
        assert refusal == {"code": -32603, "message": "internal error: command"}

    @pytest.mark.parametrize("method", ["test/fail", "test/failLater", "textDocument/didChange"])
    def test_a_fault_in_a_notification_shows_no_box(self, faulty: RawClient, method: str) -> None:
        faulty.change("untitled:never-opened", 1) if "did" in method else faulty.notify(method)
        assert faulty.drain() == []

    def test_what_is_printed_goes_to_stderr(self, faulty: RawClient) -> None:
        assert faulty.request("test/print") == "printed"
        assert faulty.refusal("kindsl/unknown")["code"] == -32601


class TestCancellation:
    def test_a_running_request_is_cancelled(self, faulty: RawClient) -> None:
        waiting = faulty.start("test/wait")
        assert faulty.refusal("kindsl/unknown")["code"] == -32601
        faulty.notify("$/cancelRequest", {"id": waiting})
        assert faulty.answer(waiting)["error"]["code"] == -32800

    def test_a_queued_request_that_is_cancelled_never_runs(self, faulty: RawClient) -> None:
        messages = [
            {"id": "q", "method": "test/mark", "params": 7},
            {"method": "$/cancelRequest", "params": {"id": "q"}},
            {"id": "r", "method": "test/mark", "params": 8},
        ]
        bodies = [json.dumps({"jsonrpc": "2.0", **message}).encode() for message in messages]
        faulty.asked |= {"q": "test/mark", "r": "test/mark"}
        faulty.send_bytes(b"".join(b"Content-Length: %d\r\n\r\n%b" % (len(b), b) for b in bodies))
        assert faulty.answer("q")["error"]["code"] == -32800
        assert faulty.answer("r")["result"] is None
        marks = faulty.request("test/marks")
        assert 8 in marks
        assert 7 not in marks

    def test_work_that_waits_for_the_worker_is_left_out_when_cancelled(
        self, faulty: RawClient
    ) -> None:
        busy = faulty.start("test/busy")
        queued = faulty.start("test/markInWorker", 9)
        assert faulty.refusal("kindsl/unknown")["code"] == -32601
        faulty.notify("$/cancelRequest", {"id": queued})
        assert faulty.answer(queued)["error"]["code"] == -32800
        faulty.request("test/goOn", 1)
        assert faulty.answer(busy)["result"] is None
        assert faulty.request("test/markInWorker", 10) is None
        assert [m for m in faulty.request("test/marks") if m in (9, 10)] == [10]

    def test_busy_handlers_do_not_keep_messages_from_being_read(self, faulty: RawClient) -> None:
        busy = [faulty.start("test/busy") for _ in range(6)]
        assert faulty.refusal("kindsl/unknown")["code"] == -32601
        assert not any(message.get("id") in busy for message in faulty.messages)
        faulty.request("test/goOn", 6)
        assert [faulty.answer(each)["result"] for each in busy] == [None] * 6

    def test_shutdown_cancels_what_runs(self) -> None:
        client = StrictClient(FAULTY)
        client.initialize()
        waiting = client.start("test/wait")
        assert client.request("shutdown") is None
        assert client.answer(waiting)["error"]["code"] == -32800
        client.notify("exit")
        assert client.wait_for_end() == 0
        client.kill()

    def test_what_runs_is_answered_when_the_client_leaves_at_once(self) -> None:
        client = StrictClient(FAULTY)
        client.initialize()
        with client.in_one_piece():
            asked = [client.start("test/wait"), client.start("test/mark", 1)]
            client.start("shutdown")
            client.notify("exit")
        assert [client.answer(each)["error"]["code"] for each in asked] == [-32800] * 2
        assert client.wait_for_end() == 0
        assert client.stderr == ""
        client.kill()

    def test_an_answer_to_what_was_given_up_is_ignored(self) -> None:
        client = SlowToAnswer(FAULTY)
        client.initialize({"window": {"workDoneProgress": True}})
        client.start("test/scan", 1.2)
        create = client.wait(lambda m: m.get("method") == "window/workDoneProgress/create")
        client.request("shutdown")
        client.send(id=create["id"], result=None)
        client.notify("exit")
        assert client.wait_for_end() == 0
        assert client.stderr == ""
        client.kill()


class TestProgress:
    def test_work_that_takes_long_is_shown_where_the_client_can(self) -> None:
        client = StrictClient(FAULTY)
        client.initialize({"window": {"workDoneProgress": True}})
        client.request("test/scan", 0.1)
        assert client.messages == []
        client.request("test/scan", 1.2)
        token = client.notification("window/workDoneProgress/create")["token"]
        shown = [m["params"] for m in client.messages if m["method"] == "$/progress"]
        assert {each["token"] for each in shown} == {token}
        kinds = [each["value"]["kind"] for each in shown]
        assert (kinds[0], kinds[-1]) == ("begin", "end")
        client.kill()

    def test_a_client_that_cannot_show_it_is_left_alone(self, faulty: RawClient) -> None:
        faulty.request("test/scan", 0.8)
        assert faulty.drain() == []


class TestPositionEncoding:
    @pytest.mark.parametrize(
        ("offered", "chosen"),
        [
            (None, "utf-16"),
            (["utf-8", "utf-16"], "utf-8"),
            (["utf-16", "utf-8"], "utf-16"),
            (["utf-7", "utf-32"], "utf-32"),
            (["utf-7"], "utf-16"),
        ],
    )
    def test_the_first_that_both_know_is_taken(
        self, offered: list[str] | None, chosen: str
    ) -> None:
        general = {"positionEncodings": offered} if offered else {}
        with raw_client() as client:
            result = client.initialize({"general": general})
            assert result["capabilities"]["positionEncoding"] == chosen


def test_logs_go_to_the_file_that_was_asked_for(tmp_path: Path) -> None:
    log = tmp_path / "server.log"
    with raw_client("--log-file", str(log), "--log-level", "info") as client:
        client.initialize()
        client.notify("textDocument/didOpen", {"wrong": True})
        client.notify("exit")
        client.wait_for_end()
        assert "textDocument/didOpen" in log.read_text()
        assert client.stderr == ""


def test_wrong_usage_is_told_in_one_sentence() -> None:
    with raw_client("--tcp", "nowhere") as client:
        assert client.wait_for_end() == 2
        assert "'nowhere' is not HOST:PORT" in client.stderr


def test_an_input_that_is_a_file_is_read_too(tmp_path: Path) -> None:
    body = b'{"jsonrpc": "2.0", "method": "exit"}'
    file = tmp_path / "messages"
    file.write_bytes(b"Content-Length: %d\r\n\r\n%b" % (len(body), body))
    with file.open("rb") as stream:
        command = [sys.executable, "-m", "kindsl.frontends.cli.language_server"]
        ended = subprocess.run(command, stdin=stream, capture_output=True, timeout=60, check=False)
    assert (ended.returncode, ended.stdout) == (1, b"")


def test_a_socket_serves_as_well() -> None:
    import socket

    with raw_client("--tcp", "127.0.0.1:0") as server:
        while (told := re.search(r"language server on .*:(\d+)\n", server.stderr)) is None:
            time.sleep(0.01)
        port = int(told[1])
        body = json.dumps({"jsonrpc": "2.0", "id": 1, "method": "shutdown"}).encode()
        with socket.create_connection(("127.0.0.1", port)) as connection:
            connection.sendall(b"Content-Length: %d\r\n\r\n%b" % (len(body), body))
            assert b"-32002" in connection.recv(4096)
        assert server.wait_for_end() == 1
