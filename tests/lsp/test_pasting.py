"""The command that says what a pasted text becomes, over stdio."""

from pathlib import Path

import pytest
from tests.analysis.test_pasted_urdf import ARM
from tests.cad.test_reports import REPORTS
from tests.support.lsp import ready_client

from kindsl.frontends.lsp.text import uris

LINK = "link hand {\n    id = 2\n    \n    children {}\n}\n"


def test_a_report_comes_back_as_edits(tmp_path: Path) -> None:
    uri = uris.uri(tmp_path / "arm.kindsl")
    head, joint, tail = ARM.partition("r_joint")
    line = (head + LINK).count("\n") - 3
    at = {"line": line, "character": 4}
    with ready_client() as client:
        client.open(uri, head + LINK + joint + tail)
        arguments = [uri, {"start": at, "end": at}, REPORTS["SolidWorks_forearm"]]
        (way,) = client.request(
            "workspace/executeCommand", {"command": "kindsl.paste", "arguments": arguments}
        )
        assert way["isCertain"] and way["title"] == "Take over the mass properties"
        (edit,) = way["edits"]
        assert edit["range"]["start"] == {"line": line, "character": 0}
        assert edit["newText"].startswith("    inertia_params {\n        mass = ")


@pytest.mark.parametrize("arguments", [[], ["file:///x.kindsl", 1, "x"], [None, {}, "x"]])
def test_other_arguments_are_refused(arguments: list[object]) -> None:
    with ready_client() as client:
        refusal = client.refusal(
            "workspace/executeCommand", {"command": "kindsl.paste", "arguments": arguments}
        )
        assert "must be an address, a range and a text" in refusal["message"]
