"""Folders, settings, files and what is published when, over real stdio."""

import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from tests.support import robots
from tests.support.lsp import RawClient, raw_client, ready_client

from kindsl.frontends.cli.documents.walking import documents
from kindsl.frontends.lsp.text import uris

ROBOT = robots.ONE_LINK
UNBOUND = "KD401"
WATCHES = {"workspace": {"didChangeWatchedFiles": {"dynamicRegistration": True}}}
CONFIGURES = {"workspace": {"configuration": True}}


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "robot.kindsl").write_text(ROBOT)
    return tmp_path


@pytest.fixture(scope="module")
def client(tmp_path_factory: pytest.TempPathFactory) -> Iterator[RawClient]:
    folder = tmp_path_factory.mktemp("shared")
    (folder / "robot.kindsl").write_text(ROBOT)
    with ready_client(workspaceFolders=roots(folder)) as client:
        yield client


def roots(*folders: Path) -> list[dict[str, str]]:
    return [{"uri": uris.uri(folder), "name": folder.name} for folder in folders]


def parts(client: RawClient, question: int) -> list[dict[str, Any]]:
    """Return the items that came in parts before the answer, which has none."""
    assert client.answer(question)["result"] == {"items": []}
    told = [m for m in client.drain() if m.get("method") == "$/progress"]
    return [
        item for m in told if m["params"]["token"] == "p" for item in m["params"]["value"]["items"]
    ]


def whole(text: str) -> dict[str, str]:
    return {"text": text}


class TestPublishing:
    def test_fifty_quick_edits_are_published_once(self) -> None:
        uri = "untitled:quick"
        with ready_client(initializationOptions={"diagnostics": {"delay": 2000}}) as client:
            client.open(uri, ROBOT)
            client.diagnostics(uri)
            client.drain()
            with client.in_one_piece():
                for version in range(2, 52):
                    client.change(uri, version, whole(ROBOT + " " * version))
            last = client.wait(lambda m: m.get("params", {}).get("version") == 51)
            assert last["method"] == "textDocument/publishDiagnostics"
            assert client.drain() == []

    def test_a_delay_can_be_set_to_nothing(self) -> None:
        options = {"diagnostics": {"delay": 0}}
        with ready_client(initializationOptions=options) as client:
            client.open("untitled:r", ROBOT)
            for version in range(2, 6):
                client.change("untitled:r", version, whole(ROBOT + " " * version))
                client.wait(lambda m, v=version: m.get("params", {}).get("version") == v)

    def test_nothing_is_left_of_a_closed_document(self, client: RawClient) -> None:
        client.open("untitled:closed", ROBOT)
        assert UNBOUND in client.codes("untitled:closed")
        client.close("untitled:closed")
        assert client.diagnostics("untitled:closed") == []

    def test_nothing_is_left_of_a_deleted_file(self, client: RawClient, folder: Path) -> None:
        uri = uris.uri(folder / "robot.kindsl")
        deletion = {"changes": [{"uri": uri, "type": 3}]}
        client.notify("workspace/didChangeWatchedFiles", deletion)
        assert client.diagnostics(uri) == []

    def test_a_client_that_pulls_is_not_told_twice(self) -> None:
        with ready_client({"textDocument": {"diagnostic": {}}}) as client:
            uri = "untitled:r"
            client.open(uri, ROBOT)
            document = {"textDocument": {"uri": uri}}
            assert client.request("textDocument/diagnostic", document)["items"]
            client.change(uri, 2, whole(ROBOT + "\n"))
            assert client.request("textDocument/diagnostic", document)["items"]
            time.sleep(0.3)
            published = [m for m in client.drain() if m["method"].endswith("publishDiagnostics")]
            assert [m["params"]["diagnostics"] for m in published] in ([], [[]])

    def test_a_client_that_only_asks_now_and_then_is_still_told(self, client: RawClient) -> None:
        uri = "untitled:asks"
        client.open(uri, ROBOT)
        client.request("textDocument/diagnostic", {"textDocument": {"uri": uri}})
        assert UNBOUND in client.codes(uri)

    def test_parts_that_a_client_cannot_show_are_left_out(self) -> None:
        plain = {"textDocument": {"publishDiagnostics": {}}}
        with ready_client(plain) as client:
            client.open("untitled:r", ROBOT)
            found = client.diagnostics("untitled:r")[0]
            assert found["source"] == "kindsl"
            assert not {"codeDescription", "relatedInformation", "tags"} & found.keys()

    def test_all_parts_are_there_for_others(self, client: RawClient) -> None:
        client.open("untitled:parts", ROBOT)
        found = client.diagnostics("untitled:parts")[0]
        assert found["codeDescription"]["href"].endswith(f"/rules/{found['code'].lower()}.md")


class TestTextOfOtherScripts:
    @pytest.mark.parametrize("separator", ["\u2028", "\x0c", "\x85", "\x0b"])
    def test_a_character_that_ends_no_line_moves_nothing(
        self, client: RawClient, separator: str
    ) -> None:
        uri = "untitled:" + separator.encode("unicode-escape").decode().strip("\\")
        client.open(uri, f"// a{separator}b\n{ROBOT}")
        client.diagnostics(uri)
        place = {"line": 1, "character": 6}
        edit = {"range": {"start": place, "end": {"line": 1, "character": 7}}, "text": "Q"}
        client.change(uri, 2, edit)
        client.diagnostics(uri)
        symbols = client.request("textDocument/documentSymbol", {"textDocument": {"uri": uri}})
        assert symbols
        link = client.request(
            "textDocument/hover", {"textDocument": {"uri": uri}, "position": place}
        )
        assert link["range"]["start"] == place

    def test_columns_count_utf_16_units(self, client: RawClient) -> None:
        uri = "untitled:astral"
        client.open(uri, ROBOT.replace("mass = m", "/* 😀 */ mass = m"))
        start = next(d["range"] for d in client.diagnostics(uri) if d["code"] == UNBOUND)["start"]
        assert start == {"line": 2, "character": 51}

    def test_an_edit_past_the_end_of_an_unterminated_line_appends(self, client: RawClient) -> None:
        uri = "untitled:end"
        client.open(uri, ROBOT.rstrip())
        assert "KD001" not in client.codes(uri)
        end = {"line": 99, "character": 99}
        client.change(uri, 2, {"range": {"start": end, "end": end}, "text": "!"})
        client.diagnostics(uri)  # the hand may type on
        found = client.diagnostics(uri)
        assert {"line": 5, "character": 1} in [d["range"]["start"] for d in found]


class TestPullingTheWorkspace:
    def test_a_client_that_takes_parts_is_told_of_each_robot_and_of_news(
        self, folder: Path
    ) -> None:
        (folder / "other.kindsl").write_text(ROBOT)
        with ready_client(workspaceFolders=roots(folder)) as client:
            params: dict[str, Any] = {"previousResultIds": [], "partialResultToken": "p"}
            found = parts(client, client.start("workspace/diagnostic", params))
            assert [item["kind"] for item in found] == ["full", "full"]
            known = [{"uri": item["uri"], "value": item["resultId"]} for item in found]
            waiting = client.start("workspace/diagnostic", {**params, "previousResultIds": known})
            time.sleep(0.3)
            assert not any(message.get("id") == waiting for message in client.drain())
            (folder / "robot.kindsl").write_text(ROBOT.replace("mass = m", "mass = 1.0"))
            tell(client, folder / "robot.kindsl", 2)
            (news,) = parts(client, waiting)
            assert news["uri"].endswith("/robot.kindsl")
            assert UNBOUND not in [found["code"] for found in news["items"]]

    def test_nothing_is_left_of_a_file_that_is_gone(self, folder: Path) -> None:
        with ready_client(workspaceFolders=roots(folder)) as client:
            found = client.request("workspace/diagnostic", {"previousResultIds": []})["items"]
            (folder / "robot.kindsl").unlink()
            for kind in ("full", "unchanged"):
                known = [{"uri": item["uri"], "value": item["resultId"]} for item in found]
                params = {"previousResultIds": known}
                found = client.request("workspace/diagnostic", params)["items"]
                assert [(item["kind"], item.get("items", [])) for item in found] == [(kind, [])]

    def test_a_question_that_waits_for_news_can_be_cancelled(self, tmp_path: Path) -> None:
        with ready_client(workspaceFolders=roots(tmp_path)) as client:
            params = {"previousResultIds": [], "partialResultToken": "p"}
            waiting = client.start("workspace/diagnostic", params)
            client.drain()
            client.notify("$/cancelRequest", {"id": waiting})
            assert client.answer(waiting)["error"]["code"] == -32800


class TestUris:
    def test_all_spellings_of_a_uri_are_one_document(self, client: RawClient) -> None:
        client.open("file:///tmp/a%20b/r.kindsl", ROBOT)
        client.diagnostics("file:///tmp/a%20b/r.kindsl")
        document = {"textDocument": {"uri": "file:///tmp/a b/r.kindsl"}}
        assert client.request("textDocument/documentSymbol", document)

    def test_this_machine_may_be_named(self, folder: Path) -> None:
        """Some clients name the host: it is the same document, and the same file."""
        named = uris.uri(folder / "robot.kindsl").replace("file:///", "file://localhost/")
        assert uris.key(named) == uris.key(uris.uri(folder / "robot.kindsl"))
        assert uris.path(named) == folder / "robot.kindsl"
        assert uris.path("file://elsewhere/share/r.kindsl") == Path("//elsewhere/share/r.kindsl")

    def test_the_folder_is_checked_as_the_linter_does(
        self, folder: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        names = ".hidden/a.kindsl", ".venv/b.kindsl", "node_modules/x/c.kindsl", "UPPER.KINDSL"
        for name in (*names, "out/d.kindsl", "out/kept.kindsl"):
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            (folder / name).write_text(ROBOT)
        (folder / ".git").mkdir()
        (folder / ".gitignore").write_text("/out/*\n!kept.kindsl\n")
        monkeypatch.chdir(folder)
        root = uris.uri(folder).replace("file:///", "file://localhost/")
        with ready_client(workspaceFolders=[{"uri": root, "name": "r"}]) as client:
            found = client.request("workspace/diagnostic", {"previousResultIds": []})["items"]
        linted = [uris.uri(folder / str(path)) for path in documents(["."])]
        assert [item["uri"] for item in found] == linted
        assert len(linted) == 4

    def test_drive_letters_have_no_case(self) -> None:
        assert uris.key("file:///C%3A/r.kindsl") == uris.key("file:///c:/r.kindsl")

    def test_a_document_that_is_nowhere_has_no_answers(self, client: RawClient) -> None:
        document = {"textDocument": {"uri": "git:/nowhere.kindsl"}}
        assert client.request("textDocument/documentSymbol", document) is None

    def test_a_file_that_is_not_open_is_read(self, client: RawClient, folder: Path) -> None:
        document = {"textDocument": {"uri": uris.uri(folder / "robot.kindsl")}}
        assert client.request("textDocument/documentSymbol", document)
        (folder / "robot.kindsl").write_text("")
        assert client.request("textDocument/documentSymbol", document) == []


class TestSettings:
    def test_options_bind_parameters(self) -> None:
        with ready_client(initializationOptions={"settings": {"parameters": {"m": 2}}}) as client:
            client.open("untitled:r", ROBOT)
            assert UNBOUND not in client.codes("untitled:r")

    def test_a_change_of_settings_is_seen_at_once(self) -> None:
        with ready_client() as client:
            client.open("untitled:r", ROBOT)
            assert UNBOUND in client.codes("untitled:r")
            settings = {"settings": {"kindsl": {"ignore": ["KD4"]}}}
            client.notify("workspace/didChangeConfiguration", settings)
            assert UNBOUND not in client.codes("untitled:r")

    def test_settings_are_asked_for_by_folder(self, tmp_path: Path) -> None:
        one, two = tmp_path / "one", tmp_path / "two"
        with raw_client() as client:
            client.configuration = {uris.uri(one): {"severity": {UNBOUND: "error"}}}
            client.initialize(CONFIGURES, workspaceFolders=roots(one, two))
            client.notification("workspace/configuration")
            for folder, severity in ((one, 1), (two, 2)):
                uri = uris.uri(folder / "r.kindsl")
                client.open(uri, ROBOT)
                found = [d for d in client.diagnostics(uri) if d["code"] == UNBOUND]
                assert [d["severity"] for d in found] == [severity]

    def test_a_setting_that_makes_no_sense_is_told_in_the_log(self) -> None:
        options = {"target": ["matlab"], "diagnostics.delay": "soon", "parameters": {"m": 1.5}}
        with ready_client(initializationOptions=options) as client:
            messages = [client.notification("window/logMessage")["message"] for _ in range(2)]
            assert "unknown target 'matlab' (known: robcogen, robcogen2)" in messages[0]
            delay = "setting 'kindsl.diagnostics.delay' must be a number, not a string"
            assert messages[1] == delay
            client.open("untitled:r", ROBOT)
            assert UNBOUND not in client.codes("untitled:r")

    def test_inlay_hints_can_be_turned_off(self) -> None:
        turned = ROBOT.replace("rotation = (0.0", "rotation = (PI")
        everything = {"start": {"line": 0, "character": 0}, "end": {"line": 99, "character": 0}}
        asked = {"textDocument": {"uri": "untitled:r"}, "range": everything}
        for switches, labels in (
            ({}, ["180°"]),
            ({"angles": False}, ["= 3.142"]),
            ({"enabled": False}, []),
        ):
            with ready_client(initializationOptions={"inlayHints": switches}) as client:
                client.open("untitled:r", turned)
                hints = client.request("textDocument/inlayHint", asked)
                assert [hint["label"] for hint in hints] == labels


class TestBesides:
    def test_the_status_is_told_to_whom_it_interests(self) -> None:
        with ready_client({"experimental": {"kindsl/status": True}}) as client:
            client.open("untitled:r", ROBOT.replace("mass = m", "mass = 1.0"))
            status = client.notification("kindsl/status")
            assert (status["uri"], status["dof"], status["state"]) == ("untitled:r", 1, "ready")
            assert status["findings"] == len(client.diagnostics("untitled:r"))
            client.change("untitled:r", 2, whole(ROBOT))
            assert client.notification("kindsl/status")["state"] == "unbound parameters"
            client.change("untitled:r", 3, whole("Robot R {"))
            assert client.notification("kindsl/status")["dof"] is None

    def test_progress_of_a_scan_is_shown_under_the_clients_token(self, client: RawClient) -> None:
        client.request("workspace/diagnostic", {"previousResultIds": [], "workDoneToken": "t"})
        values = [m["params"]["value"] for m in client.drain() if m["method"] == "$/progress"]
        assert [value["kind"] for value in values][:: len(values) - 1] == ["begin", "end"]

    def test_fixes_are_made_through_the_client(self, client: RawClient) -> None:
        client.open("untitled:fixes", ROBOT.replace("translation = (0.0", "translation = (0"))
        arguments = {"command": "kindsl.applyFixAll", "arguments": ["untitled:fixes"]}
        assert client.request("workspace/executeCommand", arguments) is True
        edits = client.notification("workspace/applyEdit")["edit"]["changes"]["untitled:fixes"]
        assert [edit["newText"] for edit in edits] == [".0"]

    def test_a_long_document_is_answered_as_well(self, client: RawClient) -> None:
        frames = "".join(
            f"f{n} {{ translation = (0.0, 0.0, 0.0) rotation = (0.0, PI, 0.0) }}\n"
            for n in range(4000)
        )
        uri = "untitled:long"
        client.open(uri, ROBOT.replace("children {} }", f"children {{}} frames {{ {frames} }} }}"))
        document = {"textDocument": {"uri": uri}}
        tokens = client.request("textDocument/semanticTokens/full", document)
        assert len(tokens["data"]) > 4000 * 5
        where = {**document, "position": {"line": 2, "character": 6}}
        assert client.request("textDocument/hover", where)["range"]["start"]["line"] == 2

    @pytest.mark.parametrize("command", ["kindsl.preview", "kindsl.compute", "kindsl.exportUrdf"])
    def test_a_command_on_nothing_is_refused(self, client: RawClient, command: str) -> None:
        for number in range(2):  # Of one alone it would be clear which is meant.
            client.open(f"untitled:{command}{number}", ROBOT)
        for arguments, code in (([], -32602), (["untitled:nothing"], -32803)):
            params = {"command": command, "arguments": arguments}
            assert client.refusal("workspace/executeCommand", params)["code"] == code


def tell(client: RawClient, file: Path, kind: int) -> None:
    """Tell of a file that was created (1), changed (2) or deleted (3)."""
    change = {"uri": uris.uri(file), "type": kind}
    client.notify("workspace/didChangeWatchedFiles", {"changes": [change]})
