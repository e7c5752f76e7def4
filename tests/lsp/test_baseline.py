"""A baseline in the editor: what it knows is silent there too."""

from pathlib import Path

from tests.lsp.test_configuration_files import Files, files, told
from tests.lsp.test_workspace import UNBOUND, client, folder, roots
from tests.support.lsp import ready_client

from kindsl.frontends.cli import lint

__all__ = ["client", "files", "folder"]

NAMED = 'baseline = "known.json"\n'


def test_known_findings_are_silent_until_their_block_changes(files: Files) -> None:
    known = files.folder / "known.json"
    lint.main([str(files.folder), "--write-baseline", str(known), "--quiet"])
    files.put(files.file, NAMED)
    assert UNBOUND not in files.client.codes(files.robot)
    files.put(known, '{"documents": {}}')
    assert UNBOUND in files.client.codes(files.robot)


def test_a_missing_baseline_is_shown_where_it_is_named(folder: Path) -> None:
    with ready_client(workspaceFolders=roots(folder)) as client:
        files = Files(client, folder)
        client.open(files.robot, (folder / "robot.kindsl").read_text())
        client.codes(files.robot)
        files.put(files.file, f"target = []\n{NAMED}")
        (found,) = client.diagnostics(files.uri)
        assert found["message"] == "baseline 'known.json' cannot be read: No such file or directory"
        assert found["range"]["start"]["line"] == 1
        assert UNBOUND in client.codes(files.robot)
        client.open(files.uri, NAMED)
        assert [each["range"]["start"]["line"] for each in client.diagnostics(files.uri)] == [0]
        client.change(files.uri, 2, {"text": "[parameters]\nunused = 1.0\n"})
        assert [told(each) for each in client.diagnostics(files.uri)] == [(1, "KD404")]
