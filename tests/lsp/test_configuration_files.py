"""`kindsl.toml` in the editor and on disk: what it decides, and what is wrong with it."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from tests.lsp.test_workspace import ROBOT, UNBOUND, WATCHES, client, folder, roots, tell, whole
from tests.support.lsp import RawClient, ready_client

from kindsl.frontends.lsp.text import uris

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
        client.open(uri, '[[document]]\npath = "robot.kindsl"\n')
        links = client.request("textDocument/documentLink", {"textDocument": {"uri": uri}})
        assert [link["target"] for link in links] == [uris.uri(folder / "robot.kindsl")]

    def test_a_file_without_a_path_names_no_documents(self, client: RawClient) -> None:
        uri = "untitled:new/kindsl.toml"
        client.open(uri, '[[document]]\npath = "robot.kindsl"\n')
        assert client.request("textDocument/documentLink", {"textDocument": {"uri": uri}}) == []

    def test_another_tools_file_has_nothing_to_tell(self, client: RawClient, folder: Path) -> None:
        uri = uris.uri(folder / "pyproject.toml")
        client.open(uri, '[tool.other]\npath = "robot.kindsl"\n')
        assert client.diagnostics(uri) == []
        where = {"textDocument": {"uri": uri}}
        assert client.request("textDocument/documentLink", where) == []


class Files:
    """A folder with a robot that is open and a `kindsl.toml` that is not."""

    def __init__(self, client: RawClient, folder: Path) -> None:
        self.client, self.folder = client, folder
        self.file = folder / "kindsl.toml"
        self.uri = uris.uri(self.file)
        self.robot = uris.uri(folder / "robot.kindsl")
        self._last: list[str] = []

    def put(self, file: Path, content: str | bytes) -> None:
        """Write a file in one step, so that nobody reads half of it."""
        content = content if isinstance(content, bytes) else content.encode()
        (self.folder / "new").write_bytes(content)
        (self.folder / "new").rename(file)

    def write(self, content: str | bytes, kind: int = 2) -> None:
        self.put(self.file, content)
        tell(self.client, self.file, kind)

    def messages(self) -> list[str]:
        """Wait for news about the file; the same is told twice if the server looks meanwhile."""
        last = self._last
        while self._last == last:
            self._last = [found["message"] for found in self.client.diagnostics(self.uri)]
        return self._last


@pytest.fixture
def files(client: RawClient, folder: Path) -> Iterator[Files]:
    files = Files(client, folder)
    client.open(files.robot, ROBOT)
    client.diagnostics(files.robot)
    yield files
    client.close(files.robot)


BROKEN, WORSE = "target = 3\n", "[parameters]\nm = 'heavy'\n"


class TestFilesThatAreNotOpen:
    def test_what_is_said_is_of_the_file_as_it_is_now(self, files: Files) -> None:
        files.write(BROKEN, 1)
        assert ["target" in message for message in files.messages()] == [True]
        files.write(WORSE)
        assert ["'m'" in message or "parameters.m" in message for message in files.messages()]
        files.write("ignore = 3\n" + BROKEN)
        assert len(files.messages()) == 2
        files.write("ignore = []\n")
        assert files.messages() == []

    def test_a_file_that_is_renamed_takes_its_faults_along(self, files: Files) -> None:
        files.write(BROKEN, 1)
        assert files.messages()
        files.file.rename(files.folder / "kindsl.toml.old")
        tell(files.client, files.file, 3)
        assert files.messages() == []
        (files.folder / "kindsl.toml.old").rename(files.file)
        tell(files.client, files.file, 1)
        assert files.messages()

    def test_a_file_that_is_checked_out_is_read_without_a_robot(
        self, client: RawClient, folder: Path
    ) -> None:
        files = Files(client, folder)
        files.write(BROKEN, 1)
        assert files.messages()
        files.write(WORSE)
        assert files.messages()
        files.write("")
        assert files.messages() == []

    def test_another_tools_file_is_not_ours(self, files: Files) -> None:
        project = files.folder / "pyproject.toml"
        files.put(project, "[tool.other]\nparameters = 3\n[")
        tell(files.client, project, 1)
        files.write(BROKEN, 1)
        assert files.messages()
        told = [m["params"] for m in files.client.drain() if "publishDiagnostics" in str(m)]
        assert [each for each in told if each["uri"] == uris.uri(project)] == []
        files.file.unlink()
        files.put(project, "[tool.kindsl]\ntarget = 3\n")
        tell(files.client, project, 2)
        assert files.client.diagnostics(uris.uri(project))
        files.put(project, "[tool.other]\n")
        tell(files.client, project, 2)
        assert files.client.diagnostics(uris.uri(project)) == []

    def test_what_was_not_saved_is_gone_with_the_editor(self, files: Files) -> None:
        files.write(BROKEN, 1)
        assert len(files.messages()) == 1
        files.client.open(files.uri, "ignore = 3\n" + BROKEN)
        assert len(files.messages()) == 2
        files.write(WORSE)
        files.client.close(files.uri)
        assert files.client.wait(lambda m: "heavy" in str(m) or "'m'" in str(m))
        files.client.open(files.uri, "")
        assert files.messages() == []
        files.client.close(files.uri)
        assert files.client.wait(lambda m: "'m'" in str(m))
        files.write("")
        files.client.wait(lambda m: m.get("params") == {"uri": files.uri, "diagnostics": []})

    @pytest.mark.parametrize(
        ("content", "message"),
        [(b"target = 3 # \xff\n", "is not valid UTF-8"), (b"\xef\xbb\xbftarget = 3\n", "target")],
    )
    def test_bytes_are_read_as_the_linter_reads_them(
        self, files: Files, content: bytes, message: str
    ) -> None:
        files.write(content, 1)
        (found,) = files.client.diagnostics(files.uri)
        assert message in found["message"]
        assert found["range"]["start"] == {"line": 0, "character": 0}


class TestFilesThatNobodyTellsOf:
    def test_the_disk_is_looked_at(self, files: Files) -> None:
        files.put(files.file, "[parameters]\nm = 2.0\n")
        assert UNBOUND not in files.client.codes(files.robot)
        files.put(files.file, BROKEN)
        assert files.messages()
        assert UNBOUND in files.client.codes(files.robot)
        files.file.unlink()
        assert files.messages() == []

    def test_also_while_no_robot_is_open(self, files: Files) -> None:
        files.write(BROKEN, 1)
        assert files.messages()
        files.client.close(files.robot)
        files.put(files.file, "")
        assert files.messages() == []


PULLS: dict[str, Any] = {"textDocument": {"diagnostic": {}}}
REFRESHES: dict[str, Any] = {"workspace": {"diagnostics": {"refreshSupport": True}}}


class TestPulling:
    def test_a_client_that_pulls_uninvited_is_told_what_others_change(self, folder: Path) -> None:
        robot = uris.uri(folder / "robot.kindsl")
        with ready_client(PULLS, workspaceFolders=roots(folder)) as client:
            client.open(robot, ROBOT)
            client.request("textDocument/diagnostic", {"textDocument": {"uri": robot}})
            client.drain()
            client.messages.clear()
            (folder / "kindsl.toml").write_text("[parameters]\nm = 2.0\nfree = 1.0\n")
            tell(client, folder / "kindsl.toml", 1)
            assert UNBOUND not in client.codes(robot)
