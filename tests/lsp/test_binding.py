"""Values for parameters, written into the project's configuration."""

import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from lsprotocol import types
from tests.lsp.test_workspace import ROBOT, roots
from tests.support.lsp import RawClient, ready_client

from kindsl.frontends.lsp.text import uris
from kindsl.frontends.lsp.text.document import Document, document
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.judgement.config.discovery import Configurations
from kindsl.language.syntax.document import parse
from kindsl.language.text.edits import TextEdit, apply_edits

MAKES = {
    "workspace": {"workspaceEdit": {"documentChanges": True, "resourceOperations": ["create"]}}
}


def test_a_parameter_is_bound_in_the_file_that_is_there(tmp_path: Path) -> None:
    (tmp_path / "kindsl.toml").write_text("[parameters]\nother = 1.0\n")
    with ready_client(workspaceFolders=roots(tmp_path)) as client:
        edit = offered(client, tmp_path)
        made = edit["changes"][uris.uri(tmp_path / "kindsl.toml")]
        assert [each["newText"] for each in made] == ["m = 1.0\n"]
        assert made[0]["range"]["start"] == {"line": 2, "character": 0}


def test_a_parameter_is_bound_for_its_robot_alone_where_that_has_a_table(tmp_path: Path) -> None:
    tables = "[[document]]\npath = 'leg.kindsl'\n\n[[document]]\npath = 'robot.kindsl'\n"
    (tmp_path / "kindsl.toml").write_text(tables)
    with ready_client(workspaceFolders=roots(tmp_path)) as client:
        (made,) = offered(client, tmp_path)["changes"][uris.uri(tmp_path / "kindsl.toml")]
        assert made["newText"].splitlines() == ["parameters = {m = 1.0}"]
        assert made["range"]["start"] == {"line": 5, "character": 0}


def test_a_renamed_parameter_keeps_its_value_and_takes_no_others(tmp_path: Path) -> None:
    text = "[[document]]\npath = 'leg.kindsl'\nparameters = {m = 5.0, taken = 1.0}\n"
    text += (
        "[[document]]\npath = 'robot.kindsl'\nparameters.m.value = 2.0 # kg\nparameters.m.min = 1\n"
    )
    file = tmp_path / "kindsl.toml"
    file.write_text(text)
    with ready_client(workspaceFolders=roots(tmp_path)) as client:
        made = renamed(client, tmp_path, "payload")["changes"][uris.uri(file)]
        assert [(each["range"]["start"], each["newText"]) for each in made] == [
            ({"line": 5, "character": 11}, "payload"),
            ({"line": 6, "character": 11}, "payload"),
        ]
        file.write_text(text + "parameters.taken = 1.0\n")
        change = {"uri": uris.uri(file), "type": 2}
        client.notify("workspace/didChangeWatchedFiles", {"changes": [change]})
        with pytest.raises(AssertionError, match=r"'taken' already has a value in .*kindsl\.toml"):
            renamed(client, tmp_path, "taken")


def test_a_file_is_made_by_a_client_that_can(tmp_path: Path) -> None:
    with ready_client(MAKES, workspaceFolders=roots(tmp_path)) as client:
        creation, change = offered(client, tmp_path)["documentChanges"]
        assert (creation["kind"], creation["uri"]) == ("create", uris.uri(tmp_path / "kindsl.toml"))
        assert change["edits"][0]["newText"] == "[parameters]\nm = 1.0\n"


def test_a_client_of_plain_changes_writes_the_file(tmp_path: Path) -> None:
    with ready_client(workspaceFolders=roots(tmp_path)) as client:
        (change,) = offered(client, tmp_path)["changes"][uris.uri(tmp_path / "kindsl.toml")]
        assert change["newText"] == "[parameters]\nm = 1.0\n"


@pytest.fixture(scope="module", params=["plain", "versioned"])
def client(request: pytest.FixtureRequest) -> Iterator[RawClient]:
    with ready_client(MAKES if request.param == "versioned" else None) as client:
        yield client


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("kindsl.toml", "[[document]]\npath = 'a.kindsl'\n[[document]]\npath = 'robot.kindsl'\n"),
        ("kindsl.toml", "[[document]]\npath = '*.kindsl'\nparameters.k = 1\n[severity]\n"),
        ("kindsl.toml", "[[document]]\npath = 'a.kindsl'\nparameters = { m = 7.0 }\n"),
        ("kindsl.toml", "document = [{ path = 'robot.kindsl', parameters = { k = 1.0 } }]"),
        ("kindsl.toml", "parameters.k.value = 1.0\r\nparameters.k.min = 0.5\r\n"),
        ("kindsl.toml", "parameters = { k = 1.0 } # all\nignore = []\n"),
        (
            "pyproject.toml",
            "[tool.other]\nparameters = { m = 7 }\n[tool.kindsl]\n[tool.x.parameters]\nm = 7\n",
        ),
        ("pyproject.toml", "[tool.kindsl.parameters]\nk = 1.0\n\n[parameters]\nm = 7\n"),
        ("pyproject.toml", "[tool]\nkindsl.ignore = []\nother.parameters.m = 7\n"),
        ("pyproject.toml", "[tool]\nkindsl = { ignore = [] }\n"),
    ],
)
def test_a_value_goes_where_it_counts(
    client: RawClient, tmp_path: Path, name: str, text: str
) -> None:
    """Whatever stands in the file, the parameter is bound, and nothing else is touched."""
    (tmp_path / name).write_text(text, newline="")
    edit = offered(client, tmp_path)
    (changes,) = (
        [change["edits"] for change in edit["documentChanges"]]
        if "documentChanges" in edit
        else edit["changes"].values()
    )
    written = document("", None, text, "utf-16")
    bound = apply_edits(text, [text_edit(written, change) for change in changes])
    (tmp_path / name).write_text(bound, newline="")
    assert "KD401" not in [found.code for found in linted(tmp_path / "robot.kindsl")]
    before, after = (tomllib.loads(each) for each in (text, bound))
    assert [found for found in values(before) if found not in values(after)] == []
    assert len(values(after)) == len(values(before)) + 1


def test_nothing_is_offered_where_a_broken_file_decides(client: RawClient, tmp_path: Path) -> None:
    (tmp_path / "kindsl.toml").write_text("target = 3\n")
    assert offered(client, tmp_path) is None


def test_nothing_is_offered_to_a_client_that_makes_no_files(tmp_path: Path) -> None:
    ordered = {"workspace": {"workspaceEdit": {"documentChanges": True}}}
    with ready_client(ordered, workspaceFolders=roots(tmp_path)) as client:
        assert offered(client, tmp_path) is None


def values(table: Any, keys: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    """Every value in a table with the keys that lead to it."""
    if isinstance(table, dict):
        return [v for key, each in table.items() for v in values(each, (*keys, key))]
    if isinstance(table, list):
        return [v for key, each in enumerate(table) for v in values(each, (*keys, key))]
    return [(*keys, table)]


def linted(path: Path) -> Any:
    settings = Configurations().above(str(path)).settings_for(str(path))
    return Analysis(parse(ROBOT), settings).findings


def text_edit(document: Document, change: dict[str, Any]) -> TextEdit:
    ends = (types.Position(**change["range"][end]) for end in ("start", "end"))
    start, end = map(document.offset, ends)
    return TextEdit(start, end, change["newText"])


def renamed(client: RawClient, folder: Path, name: str) -> Any:
    """The edit that renames the parameter of the robot."""
    uri = uris.uri(folder / "robot.kindsl")
    client.open(uri, ROBOT)
    place = {"line": 2, "character": ROBOT.splitlines()[2].index("mass = m") + 7}
    params = {"textDocument": {"uri": uri}, "position": place, "newName": name}
    return client.request("textDocument/rename", params)


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
