"""Transforms documents in the editor: checked against the robot beside them as it is typed."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from tests.cli.samples import arm
from tests.support.lsp import RawClient, ready_client

from kindsl.frontends.lsp.text import uris

TEXT = "Robot arm\nFrames { fr_base, fr_upper }\nTransforms { base=fr_base, target=fr_upper }\n"


@pytest.fixture
def client() -> Iterator[RawClient]:
    with ready_client() as client:
        yield client


@pytest.fixture
def robot(tmp_path: Path) -> Path:
    (tmp_path / "arm.kindsl").write_text(arm())
    return tmp_path / "arm.kindsl"


def test_it_follows_the_robot(client: RawClient, robot: Path) -> None:
    pairs, model = uris.uri(robot.with_suffix(".dtdsl")), uris.uri(robot)
    client.open(pairs, TEXT)
    assert client.codes(pairs) == []
    client.open(model, arm())
    assert client.codes(pairs) == []
    client.change(model, 2, {"text": arm().replace("upper", "thigh")})
    assert set(client.codes(pairs)) == {"KD801"}
    client.change(pairs, 2, {"text": TEXT.replace("upper", "thigh")})
    assert client.codes(pairs) == []


def test_without_a_robot_it_is_checked_by_itself(client: RawClient, tmp_path: Path) -> None:
    uri = uris.uri(tmp_path / "lonely.dtdsl")
    client.open(uri, TEXT.replace("Frames { fr_base,", "Frames {"))
    assert client.codes(uri) == ["KD802"]
    assert client.request("textDocument/hover", at(uri, 0)) is None


def test_frames_are_offered_and_listed(client: RawClient, robot: Path) -> None:
    uri = uris.uri(robot.with_suffix(".dtdsl"))
    client.open(uri, "Robot arm\nFrames { fr_\n")
    offered = client.request("textDocument/completion", at(uri, 1, 12))["items"]
    assert [item["label"] for item in offered] == ["fr_base", "fr_upper", "fr_lower"]
    client.change(uri, 2, {"text": ""})
    place = at(uri, 0)["position"]
    asked = {
        "textDocument": {"uri": uri},
        "range": {"start": place, "end": place},
        "context": {"diagnostics": []},
    }
    (action,) = client.request("textDocument/codeAction", asked)
    assert action["title"] == "Write the transforms of 'arm'"


def at(uri: str, line: int, character: int = 0) -> dict[str, object]:
    position = {"line": line, "character": character}
    return {"textDocument": {"uri": uri}, "position": position}
