"""Tools as an assistant's client calls them, over stdio and within one process."""

import asyncio
import json
import re
import sys
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from mcp.client.stdio import stdio_client
from mcp.types import CallToolResult, ImageContent, TextContent
from tests.cad.test_reports import REPORTS
from tests.cli.samples import GOOD, INTEGER, UNBOUND
from tests.comparison.trials import ARM, described_text
from tests.comparison.variants import links_of, urdf_of

from kindsl.frontends.mcp.examples import examples
from kindsl.frontends.mcp.folder import Folder, ToolError
from kindsl.frontends.mcp.server import server_for
from kindsl.frontends.mcp.tool import all_tools, answer
from mcp import Client, StdioServerParameters


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    root = tmp_path / "robots"
    root.mkdir()
    (root / "arm.kindsl").write_text(GOOD)
    (root / "integer.kindsl").write_text(INTEGER)
    (tmp_path / "secret.kindsl").write_text(GOOD)
    (root / "link.kindsl").symlink_to(tmp_path / "secret.kindsl")
    return root


async def call(folder: Path, tool: str, arguments: dict[str, Any]) -> CallToolResult:
    async with Client(server_for(folder)) as client:
        return await client.call_tool(tool, arguments)


async def said(folder: Path, tool: str, **arguments: Any) -> str:
    result = await call(folder, tool, arguments)
    assert not result.is_error, result.content
    return words(result)


async def refused(folder: Path, tool: str, **arguments: Any) -> str:
    result = await call(folder, tool, arguments)
    assert result.is_error
    sentence = words(result)
    assert "\n" not in sentence and "Traceback" not in sentence
    return sentence


def words(result: CallToolResult) -> str:
    return "\n".join(part.text for part in result.content if isinstance(part, TextContent))


async def test_over_stdio_with_a_hundred_calls_at_once(folder: Path) -> None:
    command = StdioServerParameters(
        command=sys.executable, args=["-m", "kindsl", "mcp"], cwd=str(folder)
    )
    async with Client(stdio_client(command)) as client:
        tools = (await client.list_tools()).tools
        assert {tool.name for tool in tools} >= {"check", "fix", "view", "compute", "explain"}
        assert all(tool.description for tool in tools)
        calls = [client.call_tool("check", {"path": "arm.kindsl"}) for _ in range(100)]
        for result in await asyncio.gather(*calls):
            assert json.loads(words(result))["summary"] == "nothing found"


async def test_findings_have_places_and_fixes(folder: Path) -> None:
    found = json.loads(await said(folder, "check", path="integer.kindsl"))
    assert found["summary"] == "1 error"
    (finding,) = found["findings"]
    assert (finding["code"], finding["start"]["line"], finding["start"]["column"]) == (
        "KD005",
        21,
        32,
    )
    assert finding["fix"]["safe"]


async def test_a_fix_is_shown_and_written_only_when_asked(folder: Path) -> None:
    file = folder / "integer.kindsl"
    told = await said(folder, "fix", path=file.name)
    assert "not written" in told
    assert "+    ref_frame { translation = (1.0," in told
    assert file.read_text() == INTEGER
    assert "written" in await said(folder, "fix", path=file.name, apply=True)
    assert "(1.0, 0.0, 0.0)" in file.read_text()
    assert await said(folder, "fix", path=file.name) == "No fix to make."
    assert "give 'path'" in await refused(folder, "fix", text=INTEGER, apply=True)


async def test_numbers(folder: Path) -> None:
    zero = json.loads(await said(folder, "compute", path="arm.kindsl"))
    assert zero["configurations"][0]["mass"] == 3.0
    bound = json.loads(await said(folder, "compute", text=UNBOUND, parameters={"length": 0.5}))
    moved = json.loads(await said(folder, "compute", path="arm.kindsl", q={"elbow": 0.25}))
    poses = [answer["configurations"][0]["link_poses"]["lower"] for answer in (bound, moved)]
    assert poses[0] == zero["configurations"][0]["link_poses"]["lower"]
    assert poses[1][2][3] == pytest.approx(poses[0][2][3] + 0.25)
    assert "give 'parameters'" in await refused(folder, "compute", text=UNBOUND)
    assert "2 joints: shoulder, elbow" in await refused(folder, "compute", text=GOOD, q=[1.0])


async def test_a_urdf_is_judged_where_it_stands_and_computed(folder: Path) -> None:
    urdf = """<robot name="arm"><link name="base"/><link name="upper"><inertial>
<mass value="2"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.02" iyz="0" izz="0.06"/>
</inertial></link><joint name="j" type="continuous"><parent link="base"/><child link="upper"/>
</joint></robot>"""
    (folder / "arm.urdf").write_text(urdf)
    for robot in ({"path": "arm.urdf"}, {"text": urdf}):
        found = json.loads(await said(folder, "check", **robot))["findings"]
        assert [(f["code"], f["start"]["line"]) for f in found] == [("KD302", 1)]
        numbers = json.loads(await said(folder, "compute", **robot))
        assert numbers["configurations"][0]["joint_space_inertia"] == [[pytest.approx(0.01)]]
    (folder / "arm.urdf").write_text(urdf.replace('value="2"', 'value="2,"'))
    sentence = await refused(folder, "compute", path="arm.urdf")
    assert sentence.startswith("line 2 cannot be read (KD005): <mass> has '2,' in 'value'")


async def test_a_difference_binds_parameters_and_notes_what_a_file_leaves_open(
    folder: Path,
) -> None:
    (folder / "a.urdf").write_text(urdf_of(links_of(described_text(ARM)[0].skeleton)))
    (folder / "a.kindsl").write_text(ARM.replace("mass = 1.3", "mass = m"))
    assert "give 'parameters'" in await refused(folder, "diff", a="a.kindsl", b="a.urdf")
    both = {"a": "a.kindsl", "b": "a.urdf"}
    found = await said(folder, "diff", **both, parameters={"m": 1.3})
    assert found.startswith("the mechanics are equal")
    assert "note: a.urdf leaves open whether its base floats" in found
    assert "is 1.4 kg in" in await said(folder, "diff", **both, parameters={"m": 1.4})


async def test_a_difference_tells_limits_that_a_configuration_has(folder: Path) -> None:
    urdf = urdf_of(links_of(described_text(ARM)[0].skeleton))
    joint = described_text(ARM)[0].skeleton.joint_names[0]
    told = f'<joint name="{joint}" type="revolute"><limit upper="2"/>'
    (folder / "a.kindsl").write_text(ARM)
    (folder / "a.urdf").write_text(re.sub(f'<joint name="{joint}"[^>]*>', told, urdf))
    (folder / "kindsl.toml").write_text(f"[joints]\n{joint} = {{ max = 1.5 }}\n")
    found = await said(folder, "diff", a="a.kindsl", b="a.urdf")
    assert f"maximum of joint '{joint}' is 1.5 rad here and 2 rad in a.urdf" in found


async def test_a_base_that_one_of_two_files_leaves_open_is_as_the_other_tells(folder: Path) -> None:
    urdf = urdf_of(links_of(described_text(ARM)[0].skeleton))
    (folder / "open.urdf").write_text(urdf)
    moving = '<robot name="r"><link name="world"/><joint name="free" type="floating">'
    moving += '<parent link="world"/><child link="{}"/></joint>'
    root = described_text(ARM)[0].skeleton.base_name
    (folder / "told.urdf").write_text(re.sub(r"<robot[^>]*>", moving.format(root), urdf))
    found = await said(folder, "diff", a="open.urdf", b="told.urdf")
    assert "note: open.urdf leaves open whether its base floats: compared as floating" in found


async def test_a_picture(folder: Path) -> None:
    result = await call(folder, "view", {"path": "arm.kindsl", "q": [0.5, 0.1]})
    (picture,) = result.content
    assert isinstance(picture, ImageContent)
    assert picture.mime_type == "image/png"
    straight = await said(folder, "view", path="arm.kindsl", format="svg")
    bent = await said(folder, "view", path="arm.kindsl", format="svg", q=[0.5, 0.1])
    assert straight.startswith("<svg") and straight != bent
    looks = {
        preset: await said(folder, "view", path="arm.kindsl", format="svg", preset=preset)
        for preset in ("bodies", "kinematics", "inertia", "frames")
    }
    assert len(set(looks.values())) == 4 and looks["bodies"] == straight
    assert "nothing" in await refused(folder, "view", text="")


async def test_squares_of_a_report_in_latin_1_are_read(folder: Path) -> None:
    text = REPORTS["Onshape_finger"].replace("m³", "m^3")
    (folder / "report.txt").write_bytes(text.encode("latin-1"))
    found = await said(folder, "inertia", path="report.txt")
    assert found == await said(folder, "inertia", text=text)


async def test_explanations(folder: Path) -> None:
    assert "# placeholder-inertia (KD310)" in await said(folder, "explain", code="kd310")
    assert "'check' names the codes" in await refused(folder, "explain", code="KD999")


@pytest.mark.parametrize("target", ["robcogen", "robcogen2"])
async def test_the_language_of_a_generator(folder: Path, target: str) -> None:
    told = await said(folder, "language", target=target)
    assert ("product_by_juxtaposition" in told) == (target == "robcogen")
    for example in examples():
        assert example in told
        found = json.loads(await said(folder, "check", text=example))
        assert found["findings"] == []


async def test_wrong_arguments_are_told_what_is_right(folder: Path) -> None:
    assert await refused(folder, "check") == "give either 'path' or 'text'"
    assert "not both" in await refused(folder, "check", path="arm.kindsl", text="")
    assert "did you mean 'text'?" in await refused(folder, "check", txt="")
    assert await refused(folder, "explain") == (
        "explain needs 'code': the code of a finding, or the rule's name"
    )
    assert "a list by id" in await refused(folder, "view", path="arm.kindsl", q="bent")
    assert "did you mean 'check'?" in await refused(folder, "chek")


@pytest.mark.parametrize(
    "path",
    ["../secret.kindsl", "link.kindsl", "/etc/passwd", "a/../../secret.kindsl", "~/x", "\0", "."],
)
async def test_nothing_outside_is_read_or_written(folder: Path, path: str) -> None:
    for tool in ("check", "compute", "view", "fix"):
        await refused(folder, tool, path=path)
    await refused(folder, "fix", path=path, apply=True)
    assert (folder.parent / "secret.kindsl").read_text() == GOOD


async def test_a_configuration_above_the_folder_is_not_read(folder: Path) -> None:
    (folder.parent / "kindsl.toml").write_text("nonsense = 1\n")
    assert "nothing found" in await said(folder, "check", path="arm.kindsl")
    (folder / "kindsl.toml").write_text("nonsense = 1\n")
    assert "nonsense" in await refused(folder, "check", path="arm.kindsl")


JSON = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(), inner, max_size=3),
    max_leaves=6,
)
NAMES = st.sampled_from(
    ["path", "text", "apply", "unsafe", "code", "target", "q", "qd", "parameters"]
)


@settings(
    max_examples=200, derandomize=True, deadline=None,
    suppress_health_check=[HealthCheck.function_scoped_fixture],
)  # fmt: skip
@given(st.sampled_from(sorted(all_tools())), st.dictionaries(NAMES | st.text(max_size=5), JSON))
def test_any_arguments_are_answered(tmp_path: Path, tool: str, arguments: dict[str, Any]) -> None:
    try:
        assert answer(all_tools()[tool], arguments, Folder(tmp_path))
    except ToolError as error:
        assert str(error)
