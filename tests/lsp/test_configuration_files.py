"""`kindsl.toml` in the editor and on disk: what it decides, and what is wrong with it."""

from pathlib import Path
from typing import Any

from tests.lsp.test_workspace import ROBOT, UNBOUND, WATCHES, client, folder, roots, tell, whole
from tests.support.lsp import RawClient, ready_client

from kindsl.lsp.text import uris

__all__ = ["client", "folder"]

HOVER: dict[str, Any] = {"position": {"line": 0, "character": 0}}


def told(diagnostic: dict[str, Any]) -> tuple[int, str]:
    """Return line and code."""
    return diagnostic["range"]["start"]["line"], diagnostic["code"]


class TestConfigurationFiles:
    def test_a_file_that_changes_is_read_again(self, folder: Path) -> None:
        with ready_client(WATCHES, workspaceFolders=roots(folder)) as client:
            registered = client.notification("client/registerCapability")["registrations"]
            patterns = [w["globPattern"] for w in registered[0]["registerOptions"]["watchers"]]
            assert {"**/*.kindsl", "**/kindsl.toml"} <= set(patterns)
            uri = uris.uri(folder / "robot.kindsl")
            client.open(uri, ROBOT)
            assert UNBOUND in client.codes(uri)
            (folder / "kindsl.toml").write_text("[parameters]\nm = 2.0\n")
            tell(client, folder / "kindsl.toml", 1)
            assert UNBOUND not in client.codes(uri)
            (folder / "kindsl.toml").unlink()
            tell(client, folder / "kindsl.toml", 3)
            assert UNBOUND in client.codes(uri)

    def test_a_saved_file_counts_without_a_watcher(self, client: RawClient, folder: Path) -> None:
        uri = uris.uri(folder / "robot.kindsl")
        client.open(uri, ROBOT)
        assert UNBOUND in client.codes(uri)
        file = folder / "kindsl.toml"
        file.write_text("[parameters]\nm = 2.0\n")
        client.notify("textDocument/didSave", {"textDocument": {"uri": uris.uri(file)}})
        assert UNBOUND not in client.codes(uri)

    def test_the_project_wins_over_the_editor(self, folder: Path) -> None:
        (folder / "kindsl.toml").write_text('[severity]\nKD401 = "error"\n')
        options = {"severity": {"KD401": "hint", "KD4": "hint"}}
        uri = uris.uri(folder / "robot.kindsl")
        with ready_client(workspaceFolders=roots(folder), initializationOptions=options) as client:
            client.open(uri, ROBOT)
            found = [d["severity"] for d in client.diagnostics(uri) if d["code"] == UNBOUND]
            assert found == [1]

    def test_a_broken_file_is_shown_where_it_is_broken(self, folder: Path) -> None:
        file = folder / "kindsl.toml"
        file.write_text("[parameters]\nm = 2.0\n\n[sevrity]\n")
        with ready_client(workspaceFolders=roots(folder)) as client:
            client.open(uris.uri(folder / "robot.kindsl"), ROBOT)
            found = client.diagnostics(uris.uri(file))
            assert [d["range"]["start"]["line"] for d in found] == [3]
            assert "sevrity" in found[0]["message"]
            file.write_text("[parameters]\nm = 2.0\n")
            tell(client, file, 2)
            assert client.diagnostics(uris.uri(file)) == []

    def test_a_file_is_checked_while_it_is_written(self, client: RawClient, folder: Path) -> None:
        uri = uris.uri(folder / "kindsl.toml")
        client.open(uri, "target = 3\n")
        assert client.diagnostics(uri)[0]["range"]["start"] == {"line": 0, "character": 0}
        client.change(uri, 2, whole('target = ["robcogen"]\n'))
        assert client.diagnostics(uri) == []
        assert client.request("textDocument/hover", {**HOVER, "textDocument": {"uri": uri}}) is None

    def test_bindings_that_no_robot_uses_are_shown(self, client: RawClient, folder: Path) -> None:
        (folder / "other.kindsl").write_text(ROBOT.replace("mass = m", "mass = payload"))
        uri, robot = uris.uri(folder / "kindsl.toml"), uris.uri(folder / "robot.kindsl")
        client.open(uri, "[parameters]\nm = 2.0\npayload = 1.0\nplayload = 3.0\n")
        assert [told(each) for each in client.diagnostics(uri)] == [(3, "KD404")]
        client.open(robot, ROBOT.replace("mass = m", "mass = n"))
        assert [told(each) for each in client.diagnostics(uri)] == [(1, "KD404"), (3, "KD404")]
        client.change(robot, 2, whole(ROBOT))
        assert [told(each) for each in client.diagnostics(uri)] == [(3, "KD404")]
        client.change(uri, 2, whole('ignore = ["KD404"]\n[parameters]\nplayload = 3.0\n'))
        (folder / "kindsl.toml").write_text('ignore = ["KD404"]\n')
        client.notify("textDocument/didSave", {"textDocument": {"uri": uri}})
        assert client.diagnostics(uri) == []

    def test_a_client_that_pulls_gets_a_file_once(self, folder: Path) -> None:
        capabilities = {
            "textDocument": {"diagnostic": {}},
            "workspace": {"diagnostics": {"refreshSupport": True}},
        }
        uri, robot = uris.uri(folder / "kindsl.toml"), uris.uri(folder / "robot.kindsl")
        with ready_client(capabilities, workspaceFolders=roots(folder)) as client:
            client.open(uri, "[parameters]\nfree = 2.0\n")
            asked = {"textDocument": {"uri": uri}}
            report = client.request("textDocument/diagnostic", asked)
            assert [told(each) for each in report["items"]] == [(1, "KD404")]
            client.drain()
            client.messages.clear()
            client.open(robot, ROBOT.replace("mass = m", "mass = free"))
            client.wait(lambda m: m.get("method") == "workspace/diagnostic/refresh")
            assert client.request("textDocument/diagnostic", asked)["items"] == []
            pushed = [m["params"] for m in client.messages if "publishDiagnostics" in str(m)]
            assert [p for p in pushed if p["uri"] == uri and p["diagnostics"]] == []

    def test_documents_that_a_file_names_are_links(self, client: RawClient, folder: Path) -> None:
        uri = uris.uri(folder / "kindsl.toml")
        client.open(uri, '# https://example.org.\n[[document]]\npath = "robot.kindsl"\n')
        links = client.request("textDocument/documentLink", {"textDocument": {"uri": uri}})
        targets = ["https://example.org", uris.uri(folder / "robot.kindsl")]
        assert [link["target"] for link in links] == targets
