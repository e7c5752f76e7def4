"""The server as it runs in a browser's worker: one event loop, texts in and out."""

import asyncio
import json
import subprocess
import sys
from pathlib import Path

import pytest

from kindsl.frontends.lsp.browser import PREVIEW_MESSAGES, PREVIEW_REQUEST, start
from kindsl.judgement.analysis.analysis import analyse

EXAMPLES = Path(__file__).parents[2] / "examples"
URI = "file:///arm.kindsl"
TEXT = (EXAMPLES / "broken_arm.kindsl").read_text()


def parts_of(message):
    return [part for change in message["params"]["messages"] for part in change["parts"]]


class Client:
    """The page's side of the messages."""

    def __init__(self):
        self.messages = []
        self.news = asyncio.Event()
        self.receive = start(self._take)
        self.count = 0

    def _take(self, text):
        self.messages.append(json.loads(text))
        self.news.set()

    def notify(self, method, params):
        self.receive(json.dumps({"jsonrpc": "2.0", "method": method, "params": params}))

    async def ask(self, method, params):
        return (await self.answer(method, params))["result"]

    async def answer(self, method, params):
        self.count += 1
        self.receive(
            json.dumps({"jsonrpc": "2.0", "id": self.count, "method": method, "params": params})
        )
        number = self.count
        return await self.seen(lambda m: m.get("id") == number and "method" not in m)

    async def seen(self, is_wanted):
        async with asyncio.timeout(60):
            while True:
                found = [message for message in self.messages if is_wanted(message)]
                if found:
                    return found[-1]
                self.news.clear()
                await self.news.wait()

    async def open(self, text):
        await self.ask("initialize", {"processId": None, "rootUri": None, "capabilities": {}})
        self.notify("initialized", {})
        document = {"uri": URI, "languageId": "kinematics-dsl", "version": 1, "text": text}
        self.notify("textDocument/didOpen", {"textDocument": document})

    async def told(self, kind):
        def is_told(message):
            return message.get("method") == PREVIEW_MESSAGES and any(
                part["type"] == kind for part in parts_of(message)
            )

        told = parts_of(await self.seen(is_told))
        return next(part for part in told if part["type"] == kind)


@pytest.fixture
async def client():
    return Client()


async def test_nothing_goes_on_when_all_is_answered(client):
    """Else the memory image could not be made: whoever makes it would wait for ever."""
    await client.open(TEXT)
    await client.ask("textDocument/diagnostic", {"textDocument": {"uri": URI}})
    async with asyncio.timeout(60):
        while len(asyncio.all_tasks()) > 1:
            await asyncio.sleep(0.01)


async def test_it_finds_what_the_linter_finds(client):
    await client.open(TEXT)
    method = "textDocument/publishDiagnostics"
    published = await client.seen(lambda message: message.get("method") == method)
    codes = [diagnostic["code"] for diagnostic in published["params"]["diagnostics"]]
    assert sorted(codes) == sorted(finding.code for finding in analyse(TEXT).findings)


async def test_it_answers_questions(client):
    await client.open(TEXT)
    place = {"textDocument": {"uri": URI}, "position": {"line": 0, "character": 2}}
    assert await client.ask("textDocument/documentSymbol", place)


async def test_a_page_is_sent_the_robot_and_what_it_asks_for_is_done(client):
    text = (EXAMPLES / "quadruped.kindsl").read_text()
    await client.open(text)
    page = (await client.ask("workspace/executeCommand", command("kindsl.preview", URI)))["url"]
    hello = {"type": "hello", "joints": {}, "parameters": {}}
    client.notify(PREVIEW_REQUEST, {"document": page, "request": hello})
    assert (await client.told("model"))["name"] == "Quadruped"
    assert isinstance((await client.told("set_object"))["object"], dict)
    client.messages.clear()
    changed = {"range": whole_range(text), "text": text.replace("Robot Quadruped", "Robot other")}
    document = {"uri": URI, "version": 2}
    client.notify("textDocument/didChange", {"textDocument": document, "contentChanges": [changed]})
    assert (await client.told("model"))["name"] == "other"


async def test_each_page_of_a_document_follows_the_others_until_it_leaves(client):
    await client.open((EXAMPLES / "quadruped.kindsl").read_text())
    document = (await client.ask("workspace/executeCommand", command("kindsl.preview", URI)))["url"]
    pages = [f"{document}/{name}" for name in ("panel", "tab")]

    def say(page, request):
        client.notify(PREVIEW_REQUEST, {"document": page, "request": request})

    for page in pages:
        say(page, {"type": "hello", "joints": {}, "parameters": {}})
        await client.seen(lambda m, page=page: m.get("params", {}).get("document") == page)
    client.messages.clear()
    say(pages[0], {"type": "set-joints", "values": {"LF_HFE": 0.5}})
    await client.seen(lambda m: m.get("params", {}).get("document") == pages[1])
    say(pages[1], None)
    client.messages.clear()
    document = {"uri": URI, "version": 2}
    other = [{"text": "Robot other { RobotBase b { } }"}]
    client.notify("textDocument/didChange", {"textDocument": document, "contentChanges": other})
    await client.seen(lambda m: m.get("params", {}).get("document") == pages[0])
    assert not any(m.get("params", {}).get("document") == pages[1] for m in client.messages)


async def test_what_is_no_request_of_a_page_is_passed_over(client):
    await client.open(TEXT)
    for params in (None, [], {}, {"document": "x", "request": {"type": "hello"}}):
        client.notify(PREVIEW_REQUEST, params)
    assert await client.ask("textDocument/documentSymbol", {"textDocument": {"uri": URI}})


async def test_what_needs_numpy_is_not_offered(client):
    offered = await client.ask("initialize", {"capabilities": {}})
    commands = offered["capabilities"]["executeCommandProvider"]["commands"]
    assert "kindsl.preview" in commands
    assert "kindsl.compute" not in commands


async def test_two_texts_are_compared_as_robots(client):
    text = (EXAMPLES / "quadruped.kindsl").read_text()
    await client.open(text)
    document = {"uri": "file:///new.kindsl", "languageId": "kinematics-dsl", "version": 1}
    heavier = text.replace("mass = 3.3", "mass = 3.5", 1)
    client.notify("textDocument/didOpen", {"textDocument": {**document, "text": heavier}})
    request = command("kindsl.difference", URI, document["uri"])
    found = await client.ask("workspace/executeCommand", request)
    assert sorted({row["kind"] for row in found["rows"]}) == ["inertia", "total"]
    request = command("kindsl.difference", document["uri"], document["uri"], text)
    assert await client.ask("workspace/executeCommand", request) == found
    request = command("kindsl.difference", URI, document["uri"], "Robot r {}")
    error = (await client.answer("workspace/executeCommand", request))["error"]
    assert error["message"] == "the old document does not describe a tree of links"


URDF = (Path(__file__).parents[2] / "docs" / "guide" / "pan_tilt.urdf").read_text()


async def test_a_urdf_becomes_a_document_with_remarks(client):
    await client.open(TEXT)
    found = await client.ask(
        "workspace/executeCommand", command("kindsl.importRobot", "pan_tilt.urdf", URDF)
    )
    assert "link tilt_link {" in found["text"]
    assert not [f for f in analyse(found["text"]).findings if f.severity == "error"]
    assert "the link 'camera', fixed to 'tilt_link', became a frame of it" in found["remarks"]


@pytest.mark.parametrize(
    ("name", "text", "message"),
    [
        ("a.urdf", URDF.replace('"0 0 1"', '"0 1"', 1), "has 2 numbers in 'xyz', not 3"),
        ("a.URDF", "<robot>\n<link", "not a readable URDF: not well-formed XML at line 2"),
        ("a.sdf", URDF, "not an SDF: its root element is <robot>, not <sdf>"),
        (
            "a.urdf",
            URDF.replace('parent link="base_link"', 'parent link="a&#10;b"'),
            "link 'a\ufffdb'",
        ),
        ("a.xml", "<mujoco/>", "MJCF cannot be read from one text, as .sdf or .urdf can"),
        ("step", "", "a name without a suffix does not determine the format: use .sdf or .urdf"),
        ("a.step", "", "the suffix '.step' does not determine the format: use .sdf or .urdf"),
    ],
)
async def test_what_cannot_be_imported_is_one_sentence(client, name, text, message):
    await client.open(TEXT)
    request = command("kindsl.importRobot", name, text)
    error = (await client.answer("workspace/executeCommand", request))["error"]
    assert message in error["message"] and "\n" not in error["message"]


async def test_a_urdf_for_download_has_the_limits_of_the_configuration(client, tmp_path):
    (tmp_path / "kindsl.toml").write_text("[joints.LF_HAA]\nmin = -0.5\nmax = 0.25\n")
    text = (EXAMPLES / "quadruped.kindsl").read_text()
    uri = (tmp_path / "quadruped.kindsl").as_uri()
    await client.open(TEXT)
    document = {"uri": uri, "languageId": "kinematics-dsl", "version": 1, "text": text}
    client.notify("textDocument/didOpen", {"textDocument": document})
    urdf = await client.ask("workspace/executeCommand", command("kindsl.exportUrdf", uri))
    assert 'lower="-0.5" upper="0.25"' in urdf
    told = await client.seen(lambda message: message.get("method") == "window/showMessage")
    assert "11 revolute joints got limits of a full turn each way" in told["params"]["message"]


def test_it_needs_nothing_that_a_browser_lacks():
    missing = ("numpy", "lxml", "tornado", "umsgpack", "ssl")
    code = f"import sys; sys.modules.update(dict.fromkeys({missing}));"
    code += "import kindsl.frontends.lsp.browser, kindsl.frontends.preview.posted;"
    code += "import kindsl.robots.scene.robot;"
    code += (
        "import kindsl.robots.interchange.urdf.urdf_reading, kindsl.robots.interchange.urdf.writing"
    )
    subprocess.run([sys.executable, "-c", code], check=True)


def command(name, *arguments):
    return {"command": name, "arguments": list(arguments)}


def whole_range(text):
    end = {"line": text.count("\n") + 1, "character": 0}
    return {"start": {"line": 0, "character": 0}, "end": end}
