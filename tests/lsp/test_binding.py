"""Values for parameters, written into the project's configuration."""

import tomllib
from pathlib import Path
from typing import Any

import pytest
from tests.lsp.test_workspace import ROBOT, roots
from tests.support.lsp import RawClient, ready_client

from kindsl.lsp.session.binding import _insertion
from kindsl.lsp.text import uris
from kindsl.text.edits import apply_edits

MAKES = {
    "workspace": {"workspaceEdit": {"documentChanges": True, "resourceOperations": ["create"]}}
}


@pytest.mark.parametrize(
    "text",
    [
        "",
        'target = ["robcogen"]',
        "[parameters]",
        "[parameters]\nb = 2.0\n",
        "[ parameters ] # values\nb = 2.0\n[severity]\n",
        "parameters = {}\n",
        "parameters = { b = 2.0 }\n[severity]\n",
        "[parameters.b]\nvalue = 1.0\n",
        '[severity]\nKD401 = "error"\n\n[[document]]\npath = "a.kindsl"\n',
    ],
)
def test_a_value_is_added_to_what_is_there(text: str) -> None:
    before = tomllib.loads(text)
    after = tomllib.loads(apply_edits(text, [_insertion(text, "", ["m = 1.0"])]))
    assert after.pop("parameters") == {**before.pop("parameters", {}), "m": 1.0}
    assert after == before


def test_a_parameter_is_bound_in_the_file_that_is_there(tmp_path: Path) -> None:
    (tmp_path / "kindsl.toml").write_text("[parameters]\nother = 1.0\n")
    with ready_client(workspaceFolders=roots(tmp_path)) as client:
        edit = offered(client, tmp_path)
        made = edit["changes"][uris.uri(tmp_path / "kindsl.toml")]
        assert [each["newText"] for each in made] == ["m = 1.0\n"]
        assert made[0]["range"]["start"] == {"line": 1, "character": 0}


def test_a_file_is_made_by_a_client_that_can(tmp_path: Path) -> None:
    with ready_client(MAKES, workspaceFolders=roots(tmp_path)) as client:
        creation, change = offered(client, tmp_path)["documentChanges"]
        assert (creation["kind"], creation["uri"]) == ("create", uris.uri(tmp_path / "kindsl.toml"))
        assert change["edits"][0]["newText"] == "[parameters]\nm = 1.0\n"


def test_nothing_is_offered_to_a_client_that_makes_no_files(tmp_path: Path) -> None:
    with ready_client(workspaceFolders=roots(tmp_path)) as client:
        assert offered(client, tmp_path) is None


def offered(client: RawClient, folder: Path) -> Any:
    """The edit of the action that binds the parameter of the robot."""
    uri = uris.uri(folder / "robot.kindsl")
    client.open(uri, ROBOT)
    place = {"line": 2, "character": ROBOT.splitlines()[2].index("mass = m") + 7}
    params = {
        "textDocument": {"uri": uri},
        "range": {"start": place, "end": place},
        "context": {"diagnostics": []},
    }
    actions = client.request("textDocument/codeAction", params)
    return next((a["edit"] for a in actions if a["title"].startswith("Bind 'm'")), None)
