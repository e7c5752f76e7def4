"""A URDF in the editor: judged by its name, whatever language the editor takes it for."""

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from tests.analysis.test_mjcf_in_place import quadruped
from tests.analysis.test_urdf_fixes import spoilt
from tests.cli.test_other_formats import URDF
from tests.support.lsp import RawClient, ready_client

from kindsl.frontends.features.xml_things import thing_at, xml_hover
from kindsl.frontends.lsp.text import uris
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.robots.interchange.syntaxes import syntax_of

EXTENSION = Path(__file__).parents[2] / "vscode-extension"
BAD = URDF.replace('iyy="0.02"', 'iyy="0.07"')


@pytest.fixture
def client() -> Iterator[RawClient]:
    with ready_client() as client:
        yield client


def at(uri: str, word: str, text: str = URDF) -> dict[str, Any]:
    before = text[: text.index(word)]
    line = before.count("\n")
    position = {"line": line, "character": len(before.rpartition("\n")[2]) + 1}
    return {"textDocument": {"uri": uri}, "position": position}


def test_the_extension_asks_for_it_by_its_name() -> None:
    package = json.loads((EXTENSION / "package.json").read_text())
    assert "onStartupFinished" in package["activationEvents"]
    languages = [each for each in package["contributes"]["languages"] if each.get("extensions")]
    assert not any({".urdf", ".sdf"} & {*each["extensions"]} for each in languages)
    options = (EXTENSION / "src/clientOptions.ts").read_text()
    assert 'OTHER_ROBOTS = "**/*.{urdf,sdf}"' in options
    for client in ("client.ts", "browser/workerServer.ts"):
        assert "pattern: OTHER_ROBOTS" in (EXTENSION / "src" / client).read_text()


def test_its_findings_follow_what_is_typed(client: RawClient, tmp_path: Path) -> None:
    uri = uris.uri(tmp_path / "arm.urdf")
    client.open(uri, URDF)
    assert client.codes(uri) == []
    client.change(uri, 2, {"text": BAD})
    finding, *_ = client.diagnostics(uri)
    assert (finding["code"], finding["range"]["start"]["line"]) == ("KD302", 4)
    start = {"line": 7, "character": BAD.splitlines()[7].index("0.07")}
    end = {**start, "character": start["character"] + 4}
    client.change(uri, 3, {"range": {"start": start, "end": end}, "text": "0.02"})
    assert client.codes(uri) == []
    client.change(uri, 4, {"text": URDF.replace("</robot>", "")})
    assert client.codes(uri) == ["KD001"]


@pytest.mark.parametrize("name", ["arm.urdf", "ARM.URDF", "arm.sdf"])
def test_nothing_of_the_language_is_said_of_it(
    client: RawClient, tmp_path: Path, name: str
) -> None:
    uri = uris.uri(tmp_path / name)
    text = URDF if name != "arm.sdf" else "<sdf version='1.9'><model name='m'></model></sdf>"
    client.open(uri, text)
    assert client.codes(uri) == []
    document = {"textDocument": {"uri": uri}}
    options = {"options": {"tabSize": 4, "insertSpaces": True}}
    assert client.request("textDocument/formatting", {**document, **options}) is None
    assert client.request("textDocument/completion", at(uri, "name", text)) is None
    assert client.request("textDocument/semanticTokens/full", document) is None


def test_a_fix_and_a_comment_are_offered(client: RawClient, tmp_path: Path) -> None:
    uri = uris.uri(tmp_path / "legs.urdf")
    text = spoilt('value="1.152"', 'value="1152"')
    client.open(uri, text)
    (found,) = client.diagnostics(uri)
    asked = {"range": found["range"], "context": {"diagnostics": []}}
    asked["textDocument"] = {"uri": uri}
    fix, comment = client.request("textDocument/codeAction", asked)
    assert (fix["title"], comment["title"]) == ("Convert the mass to kg", "Ignore KD314 here")
    (edit,) = fix["edit"]["changes"][uri]
    assert edit["newText"] == "1.152"


def test_hovers_have_mechanics_in_the_files_frames(client: RawClient, tmp_path: Path) -> None:
    uri = uris.uri(tmp_path / "arm.urdf")
    client.open(uri, BAD)

    def hover(word: str) -> str:
        found = client.request("textDocument/hover", at(uri, word, BAD))
        return "" if found is None else str(found["contents"]["value"])

    link = hover('link name="upper"')
    assert "- carried by joint `shoulder`, parent `base`" in link
    assert "- mass 2 kg\n- CoM (0.1, 0, 0) m in the link frame" in link
    assert "- fixed to it: `tool`" in link
    assert "✗ inertia of 'upper' violates the triangle inequality" in link
    assert hover("inertial>") == link
    assert "- fixed to `upper`" in hover('link name="tool"')
    joint = hover('joint name="shoulder"')
    assert joint.startswith("**revolute joint `shoulder`**")
    assert "- turns about (0, 1, 0) of its frame\n- limits -57.3 to 57.3°" in joint
    assert hover("?xml") == ""


def test_a_body_of_an_mjcf_and_its_joint_have_their_own_hovers() -> None:
    text = quadruped()
    robot = Analysis(syntax_of("robot.xml", text))

    def hover(word: str) -> str:
        found = xml_hover(robot, text.index(word))
        return "" if found is None else found.markdown

    assert "- carried by joint `LF_KFE`, parent `LF_thigh`" in hover('<body name="LF_shank"')
    joint = hover('<joint name="LF_KFE"')
    assert joint.startswith("**revolute joint `LF_KFE`**")
    assert "- turns about (0, 1, 0) of its frame\n- limits -2 to 2°" in joint
    assert thing_at(robot, text.index('"LF_KFE"')) == ("joint", "LF_KFE")
    assert thing_at(robot, text.index('"LF_shank"')) == ("link", "LF_shank")


def test_the_preview_shows_it_and_keeps_its_last_picture(client: RawClient, tmp_path: Path) -> None:
    uri = uris.uri(tmp_path / "arm.urdf")
    client.open(uri, URDF)
    assert client.codes(uri) == []
    shown = {"command": "kindsl.preview", "arguments": [uri]}
    assert client.request("workspace/executeCommand", shown)["url"].startswith("http://127.0.0.1:")
    client.change(uri, 2, {"text": URDF.replace('value="2"', 'value="2,"')})
    assert client.codes(uri) == ["KD005"]
    assert client.request("workspace/executeCommand", shown)["url"].startswith("http://127.0.0.1:")


def test_a_robot_that_cannot_be_shown_is_told_why(client: RawClient, tmp_path: Path) -> None:
    uri = uris.uri(tmp_path / "arm.urdf")
    client.open(uri, URDF.replace('<child link="upper"', '<child link="base"'))
    refused = client.refusal(
        "workspace/executeCommand", {"command": "kindsl.preview", "arguments": [uri]}
    )
    assert refused["message"] == ("line 12: <joint name='shoulder'> closes a loop: base -> base")
