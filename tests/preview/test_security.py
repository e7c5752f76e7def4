"""Who does not know the token, or comes from elsewhere, gets nothing."""

import asyncio
import json
import socket
from contextlib import suppress
from urllib.parse import urlsplit

import pytest
import umsgpack
from tests.preview.robots import ARM
from tests.preview.websocket import connected
from tornado.httpclient import AsyncHTTPClient, HTTPClientError, HTTPRequest
from tornado.websocket import WebSocketClosedError, websocket_connect

from kindsl.frontends.preview.access import Access, new_token
from kindsl.frontends.preview.assets import SCRIPTS, STYLES
from kindsl.frontends.preview.handlers import Budget
from kindsl.frontends.preview.server import PreviewServer
from kindsl.judgement.analysis.analysis import analyse

FOREIGN_HOSTS = [
    "evil.example",
    "evil.example:{port}",
    "127.0.0.1",
    "127.0.0.1:1",
    "0.0.0.0:{port}",
    "",
    "127.0.0.1:{port}.evil.example",
]
FOREIGN_ORIGINS = [
    "null",
    "http://evil.example",
    "http://evil.example:{port}",
    "https://127.0.0.1:{port}",
    "http://127.0.0.1:1",
    "http://127.0.0.1",
    "file://",
    "",
    "http://127.0.0.1:{port}.evil.example",
]


@pytest.fixture
async def server():
    running = PreviewServer()
    await running.start()
    await running.show("arm.kindsl", analyse(ARM), ())
    yield running
    await running.stop()


async def status(server, path="/", token=True, **headers):
    query = f"?token={server.token}" if token is True else f"?token={token}" if token else ""
    url = f"http://127.0.0.1:{server.port}{path}{query}"
    try:
        response = await AsyncHTTPClient().fetch(HTTPRequest(url, headers=headers))
    except HTTPClientError as error:
        return error.code
    return response.code


async def websocket_status(server, token=True, **headers):
    query = f"?token={server.token}" if token is True else f"?token={token}" if token else ""
    try:
        async with connected(f"ws://127.0.0.1:{server.port}/live{query}", **headers):
            return 101
    except HTTPClientError as error:
        return error.code


def at(server, text):
    return text.replace("{port}", str(server.port))


async def test_the_page_and_its_parts_are_served(server):
    for path in ("/", *(f"/{name}" for name in SCRIPTS), *(f"/{name}" for name in STYLES)):
        assert await status(server, path) == 200
    assert await websocket_status(server, Origin=f"http://127.0.0.1:{server.port}") == 101


@pytest.mark.parametrize("token", [None, "", "wrong", "%00", "%C3%BC"])
async def test_without_the_token_everything_is_refused(server, token):
    for path in ("/", "/viewer.js", "/page.css", "/nowhere", "/live"):
        assert await status(server, path, token) == 403
    assert await websocket_status(server, token) == 403


@pytest.mark.parametrize("host", FOREIGN_HOSTS)
async def test_a_foreign_host_is_refused(server, host):
    for path in ("/", "/viewer.js", "/live"):
        assert await status(server, path, Host=at(server, host)) in (400, 403)
    assert await websocket_status(server, Host=at(server, host)) in (400, 403)


@pytest.mark.parametrize("origin", FOREIGN_ORIGINS)
async def test_a_foreign_origin_is_refused(server, origin):
    for path in ("/", "/viewer.js", "/live"):
        assert await status(server, path, Origin=at(server, origin)) == 403
    assert await websocket_status(server, Origin=at(server, origin)) == 403


@pytest.mark.parametrize("name", ["localhost", "127.0.0.1"])
async def test_both_names_of_the_loopback_are_good(server, name):
    own = f"{name}:{server.port}"
    assert await status(server, Host=own, Origin=f"http://{own}") == 200
    assert await websocket_status(server, Host=own, Origin=f"http://{own}") == 101


async def test_it_listens_on_the_loopback_alone(server):
    listening = [s.getsockname() for s in server._http._sockets.values()]
    assert listening == [("127.0.0.1", server.port)]
    for family, address in ((socket.AF_INET, "127.0.0.2"), (socket.AF_INET6, "::1")):
        with socket.socket(family) as other:
            assert other.connect_ex((address, server.port)) != 0


@pytest.mark.parametrize(
    "path",
    [
        "/../server.py",
        "/..%2fserver.py",
        "/page/page.html",
        "/etc/passwd",
        "//etc/passwd",
        "/%2e%2e/%2e%2e/x",
        "/start.js/..",
        "/start.js%00",
        "/viewer.js/",
    ],
)
async def test_nothing_but_the_page_is_served(server, path):
    assert await status(server, path) in (400, 404)


async def test_nothing_can_be_written(server):
    for method in ("POST", "PUT", "DELETE", "PATCH", "OPTIONS"):
        request = HTTPRequest(
            f"http://127.0.0.1:{server.port}/?token={server.token}", method=method,
            allow_nonstandard_methods=True,
        )  # fmt: skip
        response = await AsyncHTTPClient().fetch(request, raise_error=False)
        assert response.code == 405


async def test_a_request_without_host_is_refused(server):
    reader, writer = await asyncio.open_connection("127.0.0.1", server.port)
    writer.write(f"GET /?token={server.token} HTTP/1.1\r\nConnection: close\r\n\r\n".encode())
    await writer.drain()
    answer = await reader.read()
    writer.close()
    await writer.wait_closed()
    assert answer.split()[1] in (b"400", b"403")


async def test_the_answers_keep_the_token_to_themselves(server):
    response = await AsyncHTTPClient().fetch(
        f"http://127.0.0.1:{server.port}/?token={server.token}"
    )
    assert response.headers["Referrer-Policy"] == "no-referrer"
    assert response.headers["Cache-Control"] == "no-store"
    assert "Server" not in response.headers
    policy = dict(
        part.strip().split(" ", 1)
        for part in response.headers["Content-Security-Policy"].split(";")
    )
    assert policy["default-src"] == "'none'"
    assert policy["script-src"] == "'self'"
    assert "unsafe-eval" not in response.headers["Content-Security-Policy"]


async def test_what_is_no_request_is_refused_and_does_no_harm(server):
    lift = {"type": "set-joints", "values": {"lift": 0.2}}
    address = f"ws://127.0.0.1:{server.port}/live?token={server.token}"
    async with connected(address) as connection, asyncio.timeout(60.0):
        for message in ("", "{", "[]", json.dumps({"type": "eval", "code": "1"}), "[" * 9999):
            await connection.write_message(message)
        await connection.write_message(b"\x00\xff", binary=True)
        await connection.write_message(json.dumps(lift))
        while not server.at("arm.kindsl")._joints:
            await asyncio.sleep(0.01)
        refused = ""
        while not refused:
            change = umsgpack.unpackb(await connection.read_message())
            refused = next((m["reason"] for m in change["parts"] if m["type"] == "refused"), "")
    assert refused in ("a message is not JSON", "a message has no known type")


async def test_an_oversized_message_closes_the_line(server):
    connection = await websocket_connect(f"ws://127.0.0.1:{server.port}/live?token={server.token}")
    await connection.write_message("x" * 200_000)
    while await connection.read_message() is not None:
        continue
    connection.close()
    assert connection.close_code == 1009 or connection.close_code is None


async def test_refused_and_failed_requests_write_no_token(server, capfd, caplog, monkeypatch):
    assert await status(server, Origin="http://evil.example") == 403
    assert await websocket_status(server, Origin="http://evil.example") == 403
    assert await status(server, "/nowhere") == 404
    assert await status(server, token="wrong") == 403
    assert (*capfd.readouterr(), caplog.text) == ("", "", "")
    monkeypatch.setattr("kindsl.frontends.preview.handlers.live_page", lambda token: 1 / 0)
    assert await status(server) == 500
    out, error = capfd.readouterr()
    assert error == "internal error in the preview: ZeroDivisionError('division by zero')\n"
    assert server.token not in out + error + caplog.text


async def test_a_page_that_floods_the_server_loses_its_line(server):
    connection = await websocket_connect(f"ws://127.0.0.1:{server.port}/live?token={server.token}")
    hello = json.dumps({"type": "hello", "joints": {f"joint{n:05}": 1.5 for n in range(2600)}})
    with suppress(WebSocketClosedError):
        for _ in range(58):
            await connection.write_message(hello)
    while await connection.read_message() is not None:
        continue
    connection.close()
    assert connection.close_code == 1008
    assert len(server.at("arm.kindsl")._joints) <= 2600
    assert await status(server) == 200


async def test_a_page_that_floods_the_server_with_drags_writes_nothing(server):
    writings = []

    async def write(_key, writing):
        writings.append(writing)
        return ""

    editing = PreviewServer(on_edit=write)
    await editing.start()
    await editing.show("arm.kindsl", analyse(ARM), ())
    url = f"ws://127.0.0.1:{editing.port}/live?token={editing.token}"
    thing = {"type": "drag", "kind": "joint", "name": "lift", "component": "x", "phase": "move"}
    move = json.dumps({**thing, "value": 0.5, "step": None, "revision": 1})
    connection = await websocket_connect(url)
    with suppress(WebSocketClosedError):
        for _ in range(2000):
            await connection.write_message(move)
    async with asyncio.timeout(60.0):
        while await connection.read_message() is not None:
            continue
    connection.close()
    assert connection.close_code == 1008
    document = editing.at("arm.kindsl")
    assert not writings and document.analysis.text == ARM
    await editing.stop()


def test_a_budget_comes_back_with_time():
    now = [0.0]
    budget = Budget(lambda: now[0])
    assert all(budget.spend("") for _ in range(600))
    assert not budget.spend("")
    now[0] = 10.0
    assert budget.spend("x" * 1000)


def test_a_hand_never_meets_the_budget():
    now = [0.0]
    budget = Budget(lambda: now[0])
    for _ in range(6000):
        now[0] += 1 / 120
        assert budget.spend('{"type": "set-joints", "values": {"LF_HFE": 0.123456789}}')


async def test_an_unknown_document_is_told_so(server):
    address = f"ws://127.0.0.1:{server.port}/live?token={server.token}&document=0123456789ab"
    connection = await websocket_connect(address)
    assert await connection.read_message() is None
    assert connection.close_code == 4404
    connection.close()


async def test_addresses_name_no_paths(server):
    await server.show("/home/someone/secret arm.kindsl", analyse(ARM), ())
    url = server.url("/home/someone/secret arm.kindsl")
    assert "secret" not in url
    assert urlsplit(url).hostname == "127.0.0.1"


async def test_two_servers_have_two_tokens(server):
    assert PreviewServer().token != server.token
    assert len(new_token()) >= 32


async def test_a_taken_port_is_told(server):
    from kindsl.frontends.preview.assets import PreviewUnavailableError

    with pytest.raises(PreviewUnavailableError, match=r"cannot listen on 127\.0\.0\.1"):
        await PreviewServer(port=server.port).start()


def test_the_token_is_compared_whole():
    access = Access("abc", 80)
    assert access.refusal("127.0.0.1:80", None, "ab") is not None
    assert access.refusal("127.0.0.1:80", None, "abc") is None


def test_an_origin_that_the_editor_names_is_let_in_with_the_token():
    access = Access("abc", 80).admitting("https://code.example:8443")
    assert access.refusal("code.example:8443", "https://code.example:8443", "abc") is None
    assert access.refusal("127.0.0.1:80", "http://localhost:80", "abc") is None
    assert access.refusal("code.example:8443", "https://code.example:8443", None) is not None
    assert access.refusal("evil.example", "https://code.example:8443", "abc") is not None
    assert access.refusal("code.example:8443", "http://code.example:8443", "abc") is not None
    assert "wss://code.example:8443" in access.sockets()


@pytest.mark.parametrize(
    "origin", ["null", "", "ftp://a", "https://a/b", "https://a b", "*", "http://"]
)
def test_what_is_no_origin_is_not_let_in(origin):
    with pytest.raises(ValueError, match="origin"):
        Access("abc", 80).admitting(origin)
