"""The preview beside an editor: the real language server over stdio, a page's websocket."""

import asyncio
import json
from contextlib import asynccontextmanager

import pytest
from tests.preview.robots import ARM, BROKEN_ARM, PARAMETRIC_ARM
from tests.preview.websocket import connected, first_part, parts, whole_state
from tests.support.lsp import RawClient

URI = "untitled:arm"
CAPABILITIES = {"window": {"showDocument": {"support": True}}}
SETTINGS = {"kindsl": {"diagnostics": {"delay": 0}}}


@pytest.fixture
def editor():
    client = RawClient()
    client.initialize(CAPABILITIES, initializationOptions=SETTINGS)
    client.open(URI, ARM)
    yield client
    client.kill()


@asynccontextmanager
async def page(editor):
    command = {"command": "kindsl.preview", "arguments": [URI]}
    url = (await asyncio.to_thread(editor.request, "workspace/executeCommand", command))["url"]
    async with connected(url) as connection:
        await whole_state(connection)
        yield connection


async def next_message(connection, kind):
    return await first_part(connection, lambda part: part["type"] == kind)


async def messages_until(connection, *wanted):
    """Wait until each wanted part of a message has come, in whatever order."""
    missing = list(wanted)
    told = parts(connection)
    while missing:
        message = await anext(told)
        missing = [part for part in missing if not part.items() <= message.items()]


def position(text):
    before = ARM.partition(text)[0]
    return {"line": before.count("\n"), "character": len(before) - before.rfind("\n") - 1}


async def test_each_keystroke_is_shown(editor):
    async with page(editor) as connection:
        editor.change(URI, 2, {"text": ARM.replace("(0.4, 0.0", "(0.45, 0.0")})
        assert (await next_message(connection, "joint"))["placement"][12] == 0.45
        editor.change(URI, 3, {"text": BROKEN_ARM})
        broken = {"type": "status", "state": "broken"}
        await messages_until(connection, broken, {"type": "finding", "severity": "error"})
        editor.change(URI, 4, {"text": ARM})
        assert (await next_message(connection, "joint"))["placement"][12] == 0.4


@pytest.mark.parametrize(
    ("text", "kind", "name"),
    [("slider via", "link", "slider"), ("lift {", "joint", "lift"), ("tool {", "frame", "tool")],
)
async def test_the_cursor_is_followed(editor, text, kind, name):
    async with page(editor) as connection:
        params = {"textDocument": {"uri": URI}, "position": position(text)}
        await asyncio.to_thread(editor.request, "textDocument/documentHighlight", params)
        message = await next_message(connection, "highlight")
        assert (message["kind"], message["name"]) == (kind, name)


async def test_a_click_moves_the_editor(editor):
    async with page(editor) as connection:
        await connection.write_message('{"type": "reveal", "kind": "frame", "name": "tool"}')
        is_wanted = lambda m: "selection" in m.get("params", {})  # noqa: E731
        request = await asyncio.to_thread(editor.wait, is_wanted)
        shown = request["params"]
        assert (shown["uri"], shown["selection"]["start"]) == (URI, position("tool {"))
        editor.send(id=request["id"], result={"success": True})


async def test_a_saved_version_stays_as_a_ghost(editor):
    async with page(editor) as connection:
        editor.notify("textDocument/didSave", {"textDocument": {"uri": URI}})
        editor.change(URI, 2, {"text": ARM.replace("(0.4, 0.0", "(0.45, 0.0")})
        is_ghost = lambda part: part["path"].startswith("/kindsl/ghost/joints")  # noqa: E731
        message = await first_part(connection, is_ghost)
        assert message["name"] in ("shoulder", "lift")


@pytest.mark.parametrize(
    ("kept", "label", "written"),
    [
        (
            {"type": "write-parameters", "values": {"reach": 0.25}},
            "Give parameters values",
            "reach = 0.25\n",
        ),
        (
            {"type": "keep-pose", "name": "stand", "values": {"lift": 0.25}},
            "Keep pose 'stand'",
            '\n[[document]]\npath = "arm.kindsl"\n[document.poses.stand]\nlift = 0.25\n',
        ),
    ],
)
async def test_what_is_kept_is_written_by_the_editor(tmp_path, kept, label, written):
    (tmp_path / "kindsl.toml").write_text("[parameters]\nother = 1.0\n")
    file = tmp_path / "arm.kindsl"
    file.write_text(PARAMETRIC_ARM)
    client = RawClient()
    folders = [{"uri": tmp_path.as_uri(), "name": "robots"}]
    capabilities = {"workspace": {"applyEdit": True, "workspaceFolders": True}}
    client.initialize(capabilities, initializationOptions=SETTINGS, workspaceFolders=folders)
    client.open(file.as_uri(), PARAMETRIC_ARM)
    command = {"command": "kindsl.preview", "arguments": [file.as_uri()]}
    url = (await asyncio.to_thread(client.request, "workspace/executeCommand", command))["url"]
    async with connected(url) as connection:
        await whole_state(connection)
        await connection.write_message(json.dumps(kept))
        is_wanted = lambda m: m.get("method") == "workspace/applyEdit"  # noqa: E731
        request = await asyncio.to_thread(client.wait, is_wanted)
        assert request["params"]["label"] == label
        made = request["params"]["edit"]["changes"][(tmp_path / "kindsl.toml").as_uri()]
        assert [each["newText"] for each in made] == [written]
        client.send(id=request["id"], result={"applied": True})
    client.kill()


async def test_a_drag_in_a_document_without_a_file_is_one_labelled_edit_of_it():
    client = RawClient()
    client.initialize({"workspace": {"applyEdit": True}}, initializationOptions=SETTINGS)
    client.open(URI, ARM)
    async with page(client) as connection:
        await connection.write_message('{"type": "grasp", "kind": "joint", "name": "lift"}')
        revision = (await next_message(connection, "handles"))["revision"]
        drop = {"type": "drag", "kind": "joint", "name": "lift", "component": "x", "phase": "drop"}
        numbers = {"value": 0.45, "step": 0.01, "revision": revision}
        await connection.write_message(json.dumps(drop | numbers))
        is_wanted = lambda m: m.get("method") == "workspace/applyEdit"  # noqa: E731
        request = await asyncio.to_thread(client.wait, is_wanted)
        assert request["params"]["label"] == "Set x of joint 'lift'"
        ((address, edits),) = request["params"]["edit"]["changes"].items()
        assert (address, [edit["newText"] for edit in edits]) == (URI, ["0.45"])
        client.send(id=request["id"], result={"applied": True})
    client.kill()


async def test_lines_are_told_where_the_editor_has_no_file_to_write(editor):
    editor.change(URI, 2, {"text": PARAMETRIC_ARM})
    async with page(editor) as connection:
        await connection.write_message('{"type": "write-parameters", "values": {"reach": 0.25}}')
        lines = await next_message(connection, "lines")
        assert lines["text"] == "[parameters]\nreach = 0.25\n"
