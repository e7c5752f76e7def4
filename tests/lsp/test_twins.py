"""Twins in the editor: findings, files that change on disk, the fix in the other file, trust."""

from pathlib import Path
from typing import Any

import pytest
from tests.cli.test_diff_mechanics import ARM
from tests.lsp.test_workspace import roots
from tests.support.lsp import RawClient, ready_client

from kindsl.frontends.cli import main
from kindsl.frontends.lsp.text import uris

TABLE = '[[twins]]\ndocument = "arm.kindsl"\nfile = "{}"\n'


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder with a document and a URDF that says 0.85 kg where it says 0.8."""
    (tmp_path / "project").mkdir()
    arm = tmp_path / "project" / "arm.kindsl"
    arm.write_text(ARM)
    assert main.main(["convert", "-q", str(arm), str(tmp_path / "arm.urdf")]) == 0
    text = (tmp_path / "arm.urdf").read_text()
    (tmp_path / "arm.urdf").write_text(text.replace('value="0.8"', 'value="0.85"'))
    (tmp_path / "project" / "kindsl.toml").write_text(TABLE.format("../arm.urdf"))
    return tmp_path / "project"


def differing(client: RawClient, uri: str) -> list[dict[str, Any]]:
    return [found for found in client.diagnostics(uri) if found["code"] == "KD901"]


def compared(client: RawClient, uri: str) -> list[dict[str, Any]]:
    """Return what twins say otherwise, which is published after the findings of the text."""
    differing(client, uri)
    return differing(client, uri)


@pytest.mark.parametrize(("mark", "is_open"), [("", False), ("\ufeff", False), ("\ufeff", True)])
def test_the_number_is_marked_and_written_into_the_other_file(
    folder: Path, mark: str, is_open: bool
) -> None:
    """A byte order mark, which editors do not count, stands before the only line."""
    uri = uris.uri(folder / "arm.kindsl")
    other = folder.parent / "arm.urdf"
    text = other.read_text().replace("\n", " ")
    other.write_text(mark + text, encoding="utf-8")
    with ready_client(workspaceFolders=roots(folder)) as client:
        if is_open:
            client.open(uris.uri(other), text)
        client.open(uri, ARM)
        (found,) = compared(client, uri)
        assert found["message"].startswith("mass of link 'lower' is 0.8 kg here and 0.85 kg in ")
        params = {"textDocument": {"uri": uri}, "range": found["range"],
                  "context": {"diagnostics": [found]}}  # fmt: skip
        offered = {a["title"]: a for a in client.request("textDocument/codeAction", params)}
        assert "Take 0.85 from ../arm.urdf" in offered
        edit = offered["Write 0.8 into ../arm.urdf"]["edit"]
        changes = edit.get("changes") or {
            each["textDocument"]["uri"]: each["edits"] for each in edit["documentChanges"]
        }
        ((changed, (change,)),) = changes.items()
        assert (changed, change["newText"]) == (uris.uri(other), "0.8")
        assert change["range"]["start"]["line"] == 0
        start, end = (change["range"][which]["character"] for which in ("start", "end"))
        assert text[start:end] == "0.85"


def test_a_twin_that_changes_on_disk_is_compared_again(folder: Path) -> None:
    uri = uris.uri(folder / "arm.kindsl")
    other = folder.parent / "arm.urdf"
    with ready_client(workspaceFolders=roots(folder)) as client:
        client.open(uri, ARM)
        assert len(compared(client, uri)) == 1
        other.write_text(other.read_text().replace("0.85", "0.8"))
        assert compared(client, uri) == []


def test_outside_an_untrusted_workspace_nothing_is_read(folder: Path) -> None:
    uri, file = uris.uri(folder / "arm.kindsl"), folder / "kindsl.toml"
    options = {"kindsl/isTrusted": False}
    with ready_client(workspaceFolders=roots(folder), initializationOptions=options) as client:
        client.open(uri, ARM)
        assert differing(client, uri) == []
        client.open(uris.uri(file), file.read_text())
        (found,) = client.diagnostics(uris.uri(file))
        assert (found["code"], found["severity"]) == ("KD902", 3)
        assert "workspace that is not trusted" in found["message"]
