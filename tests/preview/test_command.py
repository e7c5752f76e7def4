"""`kindsl preview` as a process: address first, reload on save, clicks printed, clean end."""

import asyncio
import os
import signal
import struct
import sys
from contextlib import asynccontextmanager

import pytest
from tests.preview.robots import ARM, BROKEN_ARM, PARAMETRIC_ARM
from tests.preview.websocket import connected, first_part, whole_state
from tests.support.ports import free_port
from tests.vscode.browser import require

from kindsl.judgement.analysis.analysis import analyse
from kindsl.robots.interchange.format import ORDINARY
from kindsl.robots.interchange.registry import format_named

DRIVER = (
    "import sys; from kindsl.frontends.cli.main import main;"
    "sys.exit(main(['preview', *sys.argv[1:]]))"
)
PATIENCE = 60.0


@pytest.fixture
def file(tmp_path):
    path = tmp_path / "arm.kindsl"
    path.write_text(ARM)
    return path


async def start(tmp_path, *arguments):
    environment = {**os.environ, "XDG_RUNTIME_DIR": str(tmp_path)}
    return await asyncio.create_subprocess_exec(
        sys.executable, "-W", "error", "-c", DRIVER, *map(str, arguments), env=environment,
        stdout=asyncio.subprocess.PIPE, stderr=asyncio.subprocess.PIPE,
    )  # fmt: skip


async def run(tmp_path, *arguments):
    process = await start(tmp_path, *arguments)
    async with asyncio.timeout(2 * PATIENCE):
        out, err = await process.communicate()
    return process.returncode, out.decode(), err.decode()


async def line_of(stream):
    async with asyncio.timeout(PATIENCE):
        return (await stream.readline()).decode().rstrip("\n")


@asynccontextmanager
async def running(tmp_path, *arguments):
    """Yield the process and its address; it must end well on SIGINT."""
    process = await start(tmp_path, *arguments, "--no-open")
    try:
        yield process, await line_of(process.stdout)
        process.send_signal(signal.SIGINT)
        async with asyncio.timeout(PATIENCE):
            _, err = await process.communicate()
        assert (process.returncode, err) == (0, b"")
    finally:
        if process.returncode is None:
            process.kill()
            await process.communicate()


@asynccontextmanager
async def running_with_errors(tmp_path, *arguments):
    """Yield the process and its address; it may complain."""
    process = await start(tmp_path, *arguments, "--no-open")
    try:
        yield process, await line_of(process.stdout)
    finally:
        process.kill()
        await process.communicate()


async def test_the_first_line_is_the_address(tmp_path, file):
    async with running(tmp_path, file) as (_, address):
        assert address.startswith("http://127.0.0.1:")
        assert "/?token=" in address


async def test_saving_reloads_and_a_click_prints_the_place(tmp_path, file):
    async with running(tmp_path, file) as (process, address), connected(address) as connection:
        await whole_state(connection)
        file.write_text("\n\n" + ARM.replace("(0.4, 0.0", "(0.6, 0.0"))
        joint = await first_part(connection, lambda m: m["type"] == "joint")
        assert joint["placement"][12] == 0.6
        await connection.write_message('{"type": "reveal", "kind": "joint", "name": "lift"}')
        line = ("\n\n" + ARM).partition("p_joint lift")[0].count("\n") + 1
        assert await line_of(process.stdout) == f"{file}:{line}:9: joint lift"


async def test_a_document_on_stdin_is_not_followed(tmp_path):
    status, out, err = await run(tmp_path, "-", "--edit")
    told = "a document on stdin cannot be followed; name a file, or use --export"
    assert (status, out, err) == (2, "", f"kindsl preview: error: {told}\n")


async def test_a_broken_save_keeps_the_model(tmp_path, file):
    async with running(tmp_path, file) as (_, address), connected(address) as connection:
        await whole_state(connection)
        file.write_text(BROKEN_ARM)
        # It may be read while it is written, and then again.
        await first_part(connection, lambda m: m["type"] == "status" and m["state"] == "broken")


async def test_a_save_that_replaces_the_file_is_noticed(tmp_path, file):
    async with running(tmp_path, file) as (_, address), connected(address) as connection:
        await whole_state(connection)
        new = tmp_path / "new"
        new.write_text(ARM.replace("tool {", "gripper {"))
        file.unlink()
        await asyncio.sleep(0.25)
        new.rename(file)
        frame = await first_part(connection, lambda m: m["type"] == "frame")
        assert frame["name"] == "gripper"


async def test_a_killed_server_is_found_again_at_the_same_address(tmp_path, file):
    # Nobody else takes it before the next server does.
    process = await start(tmp_path, file, "--no-open", "--port", free_port())
    first = await line_of(process.stdout)
    process.kill()
    await process.communicate()
    async with running(tmp_path, file) as (_, second):
        assert second == first
        async with running(tmp_path, file) as (_, third):
            assert third not in (first, second)
    modes = [path.stat().st_mode & 0o777 for path in (tmp_path / "kindsl").rglob("*")]
    assert modes == [0o600]


async def test_an_old_version_stands_behind(tmp_path, file):
    old = tmp_path / "old.kindsl"
    old.write_text(ARM.replace("(0.4, 0.0", "(0.6, 0.0"))
    async with (
        running(tmp_path, file, "--compare", old) as (_, address),
        connected(address) as connection,
    ):
        await first_part(connection, lambda m: m.get("path") == "/kindsl/ghost/joints/lift")


async def test_a_parameter_is_bound(tmp_path, file):
    file.write_text(PARAMETRIC_ARM)
    async with (
        running(tmp_path, file, "--param", "reach=0.25") as (_, address),
        connected(address) as connection,
    ):
        joint = await first_part(connection, lambda m: m.get("name") == "lift")
        assert joint["placement"][12] == 0.25


async def test_it_begins_with_a_pose_of_the_configuration(tmp_path, file):
    page = tmp_path / "page.html"
    (tmp_path / "kindsl.toml").write_text("[poses.up]\nshoulder = 0.25\n")
    assert await run(tmp_path, file, "--export", page, "--pose", "up") == (0, "", "")
    code, _, err = await run(tmp_path, file, "--export", page, "--pose", "down")
    assert code == 2
    assert "kindsl.toml names no pose 'down'" in err


async def test_meshes_that_a_page_lacks_are_told(tmp_path, file):
    urdf, mesh = tmp_path / "arm.urdf", '<visual><geometry><mesh filename="x.stl"/></geometry>'
    written = format_named("urdf").write("arm", analyse(ARM).skeleton(), ORDINARY).text
    urdf.write_text(written.replace('<link name="upper">', f'<link name="upper">{mesh}</visual>'))
    page = tmp_path / "x.html"
    code, _, err = await run(tmp_path, file, "--export", page, "--meshes", urdf)
    assert code == 0
    assert err == f"{urdf}: 1 mesh left out, not found in '{tmp_path.name}': x.stl\n"


async def test_export_writes_a_page_and_ends(tmp_path, file):
    page = tmp_path / "arm.html"
    assert await run(tmp_path, file, "--export", page) == (0, "", "")
    assert page.read_text().startswith("<!DOCTYPE html>")


async def test_screenshot_writes_a_picture(tmp_path, file):
    require("chromium", "chromium-browser", "google-chrome")
    picture = tmp_path / "arm.png"
    assert await run(tmp_path, file, "--screenshot", picture) == (0, "", "")
    header = picture.read_bytes()[:24]
    assert header[:8] == b"\x89PNG\r\n\x1a\n"
    assert struct.unpack(">II", header[16:]) == (1200, 800)
    assert picture.stat().st_size > 20_000


async def test_without_a_browser_a_screenshot_says_so(tmp_path, file, monkeypatch):
    monkeypatch.setenv("PATH", str(tmp_path))
    code, out, err = await run(tmp_path, file, "--screenshot", tmp_path / "arm.png")
    assert (code, out) == (2, "")
    told = "a screenshot needs Chromium or Chrome, and there is none"
    assert err == f"kindsl preview: error: {told}\n"


@pytest.mark.parametrize(
    ("arguments", "problem"),
    [
        (["nowhere.kindsl"], "nowhere.kindsl: error: no such file or folder"),
        (["{file}", "--compare", "nowhere.kindsl"], "nowhere.kindsl: error: no such file"),
        (["{file}", "--export", "/nowhere/x.html"], "there is no folder '/nowhere'"),
        (["{file}", "--config", "nowhere.toml"], "nowhere.toml"),
        (["{file}", "--port", "70000"], "'70000' is not a port"),
    ],
)
async def test_what_is_wrong_is_said_in_one_line(tmp_path, file, arguments, problem):
    arguments = [argument.replace("{file}", str(file)) for argument in arguments]
    code, out, err = await run(tmp_path, *arguments)
    assert (code, out) == (2, "")
    assert problem in err
    assert "Traceback" not in err


async def test_a_document_without_bodies_cannot_stand_behind(tmp_path, file):
    empty = tmp_path / "empty.kindsl"
    empty.write_text("")
    code, _, err = await run(tmp_path, file, "--compare", empty, "--export", tmp_path / "x.html")
    assert code == 2
    assert err.startswith(f"{empty}: error: the document has no")


async def test_a_lost_file_is_told_in_the_page_and_found_again(tmp_path, file):
    async with running_with_errors(tmp_path, file) as (_, address), connected(address) as page:
        await whole_state(page)
        away = file.rename(tmp_path / "elsewhere.kindsl")
        lost = await first_part(page, lambda m: m["type"] == "status")
        assert (lost["state"], lost["message"]) == (
            "gone", f"{file}: the file was moved or deleted",
        )  # fmt: skip
        away.rename(file)
        assert (await first_part(page, lambda m: m["type"] == "status"))["state"] == "live"


KEEP = '{"type": "keep-pose", "name": "stand", "values": {"shoulder": 0.5, "x": 1}}'
STAND = "[poses.stand]\nshoulder = 0.5\n"


async def test_a_pose_is_kept_in_a_new_configuration_and_offered(tmp_path, file):
    async with running(tmp_path, file, "--edit") as (process, address), connected(address) as page:
        await whole_state(page)
        await page.write_message(KEEP)
        pose = await first_part(page, lambda m: m["type"] == "pose")
        assert (pose["name"], pose["joints"]) == ("stand", {"shoulder": 0.5})
        assert (await line_of(process.stdout)).endswith("kindsl.toml: pose 'stand'")
    written = (file.parent / "kindsl.toml").read_text()
    assert written == f'[[document]]\npath = "{file.name}"\n' + STAND.replace("[", "[document.")


async def test_a_pose_is_told_as_lines_where_nothing_may_be_written(tmp_path, file):
    async with running(tmp_path, file) as (_, address), connected(address) as page:
        await whole_state(page)
        await page.write_message(KEEP)
        lines = await first_part(page, lambda m: m["type"] == "lines")
        assert lines["text"] == STAND
    assert not (file.parent / "kindsl.toml").exists()


async def test_lines_for_the_configuration_are_told_and_a_ghost_shows_what_is_saved(tmp_path, file):
    file.write_text(PARAMETRIC_ARM.replace("(reach,", "(reach[0.4],"))
    async with running(tmp_path, file) as (process, address), connected(address) as page:
        await whole_state(page)
        await page.write_message('{"type": "set-parameters", "values": {"reach": 0.6}}')
        ghost = await first_part(page, lambda m: m.get("path") == "/kindsl/ghost/joints/lift")
        assert ghost["placement"][12] == 0.4
        await page.write_message('{"type": "write-parameters", "values": {"reach": 0.6, "x": 1}}')
        lines = await first_part(page, lambda m: m["type"] == "lines")
        assert lines["text"] == "[parameters]\nreach = 0.6\n"
        assert [await line_of(process.stdout), await line_of(process.stdout)] == [
            "[parameters]", "reach = 0.6",
        ]  # fmt: skip
