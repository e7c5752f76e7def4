"""The built-in Python by itself: the answers of any Python, a linter that writes where it may."""

import random
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from tests.support.amount import usually
from tests.support.lsp import RawClient
from tests.support.lsp_requests import every_request, place_of
from tests.support.mutants import lumps
from tests.vscode.code_server import EXTENSION, ROOT

EXAMPLES = sorted((ROOT / "examples").glob("*.kindsl"))
HOST = EXTENSION / "server" / "host.js"
CAPABILITIES = {
    "general": {"positionEncodings": ["utf-32"]},
    "textDocument": {
        "publishDiagnostics": {"relatedInformation": True, "codeDescriptionSupport": False},
        "documentSymbol": {"hierarchicalDocumentSymbolSupport": True},
        "codeAction": {"codeActionLiteralSupport": {"codeActionKind": {"valueSet": ["quickfix"]}}},
        "completion": {"completionItem": {"snippetSupport": True}},
        "hover": {"contentFormat": ["markdown"]},
        "diagnostic": {},
    },
}


def built_in(*arguments: str) -> list[str]:
    node = shutil.which("node")
    assert node is not None
    return [node, "--disallow-code-generation-from-strings", str(HOST), *arguments]


class Both:
    """The server in the built-in Python and the one in ours, told and asked the same."""

    def __init__(self, folder: Path) -> None:
        self.clients = [RawClient(built_in()), RawClient()]
        self.ask("initialize", {"rootUri": folder.as_uri(), "capabilities": CAPABILITIES})
        self.tell("initialized", {})

    def tell(self, method: str, params: Any) -> None:
        for client in self.clients:
            client.notify(method, params)

    def ask(self, method: str, params: Any) -> list[Any]:
        """Return both answers, results or errors."""
        started = [(client, client.start(method, params)) for client in self.clients]
        answers = [client.answer(number) for client, number in started]
        return [answer.get("result", answer.get("error")) for answer in answers]

    def agree(self, method: str, params: Any) -> None:
        ours, others = (without_serials(answer) for answer in self.ask(method, params))
        assert ours == others, (method, params)

    def close(self) -> None:
        self.ask("shutdown", None)
        self.tell("exit", None)
        for client in self.clients:
            client.process.wait(60)
            client.kill()


@pytest.fixture(scope="module")
def both(vsix: Path) -> Iterator[Both]:
    servers = Both(ROOT / "examples")
    yield servers
    servers.close()


def without_serials(answer: Any) -> Any:
    """Return an answer without what counts the answers."""
    if isinstance(answer, dict):
        return {k: without_serials(v) for k, v in answer.items() if k != "resultId"}
    return [without_serials(each) for each in answer] if isinstance(answer, list) else answer


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda path: path.stem)
def test_both_servers_answer_alike(both: Both, example: Path) -> None:
    text = example.read_text()
    uri = open_in(both, example, text)
    random_places = random.Random(example.stem)
    for _ in range(usually(2, 20)):
        place = place_of(text, random_places.randrange(len(text)))
        for method, params in every_request(uri, place):
            # Answers are numbered as they are asked for, those of the image's rehearsal included.
            if not method.endswith("/delta"):
                both.agree(method, params)
    both.tell("textDocument/didClose", {"textDocument": {"uri": uri}})


def test_both_servers_answer_alike_after_random_edits(both: Both) -> None:
    example = ROOT / "examples" / "quadruped.kindsl"
    text = example.read_text()
    uri = open_in(both, example, text)
    spoilt = lumps(text, random.Random(29))
    for version in range(2, usually(12, 200) + 2):
        edited = next(spoilt).text
        changes = {"textDocument": {"uri": uri, "version": version}}
        both.tell("textDocument/didChange", {**changes, "contentChanges": [{"text": edited}]})
        for method in ("diagnostic", "documentSymbol", "semanticTokens/full"):
            both.agree(f"textDocument/{method}", {"textDocument": {"uri": uri}})
    both.tell("textDocument/didClose", {"textDocument": {"uri": uri}})


def test_both_servers_find_the_same_in_closed_documents(both: Both) -> None:
    ours, others = (
        sorted(
            (report["uri"], repr(without_serials(report["items"]))) for report in answer["items"]
        )
        for answer in both.ask("workspace/diagnostic", {"previousResultIds": []})
    )
    assert len(ours) == len(EXAMPLES)
    assert ours == others


def test_the_linter_says_what_any_other_says(vsix: Path) -> None:
    found, wanted = (
        subprocess.run(command, cwd=ROOT, capture_output=True, text=True, timeout=300, check=False)
        for command in (
            built_in("lint", "examples"),
            [sys.executable, "-m", "kindsl", "lint", "examples"],
        )
    )
    assert (found.stdout, found.returncode) == (wanted.stdout, wanted.returncode)


def test_the_linter_writes_what_it_is_pointed_at_only(vsix: Path, tmp_path: Path) -> None:
    named, other = tmp_path / "named.kindsl", tmp_path / "other.kindsl"
    broken = (ROOT / "examples" / "broken_arm.kindsl").read_text()
    for file in (named, other):
        file.write_text(broken)
    named.chmod(0o640)
    (tmp_path / "link.kindsl").symlink_to(other)
    lint(tmp_path, "--fix", "named.kindsl")
    assert "CoM = (0.0, 0.0, 1.0)" in named.read_text() != broken
    assert named.stat().st_mode & 0o777 == 0o640
    assert other.read_text() == broken
    found = lint(tmp_path, "--write-baseline", "known.json", "other.kindsl")
    assert "known findings written to known.json" in found.stderr
    assert sorted(file.name for file in tmp_path.iterdir()) == sorted(
        ["known.json", "link.kindsl", "named.kindsl", "other.kindsl"]
    )


def test_the_linter_ends_without_a_trace(vsix: Path, tmp_path: Path) -> None:
    version = lint(tmp_path, "--version")
    assert (version.stdout.split()[0], version.stderr, version.returncode) == ("kdsl-lint", "", 0)
    wrong = lint(tmp_path, "--nonsense")
    assert (wrong.stdout, wrong.returncode) == ("", 2)
    assert "Traceback" not in wrong.stderr


@pytest.mark.parametrize(
    "name",
    ["server.snap.gz", "pyodide.asm.wasm", "pyodide.asm.js", "site.zip", "python_stdlib.zip"],
)
@pytest.mark.parametrize("is_cut", [False, True], ids=["gone", "cut"])
def test_an_image_that_does_not_start_says_why_and_ends(
    vsix: Path, tmp_path: Path, name: str, is_cut: bool
) -> None:
    folder = tmp_path / "server"
    shutil.copytree(HOST.parent, folder)
    content = (folder / name).read_bytes()
    (folder / name).unlink()
    if is_cut:
        (folder / name).write_bytes(content[: len(content) // 2])
    node, flag, _ = built_in()
    client = RawClient([node, flag, str(folder / "host.js")])
    assert client.process.wait(60) == 2
    client.kill()
    assert "The built-in Python failed" in client.stderr


def lint(folder: Path, *arguments: str) -> "subprocess.CompletedProcess[str]":
    return subprocess.run(
        built_in("lint", *arguments),
        cwd=folder, capture_output=True, text=True, timeout=120, check=False,
    )  # fmt: skip


def open_in(both: Both, file: Path, text: str) -> str:
    uri = file.as_uri()
    document = {"uri": uri, "languageId": "kinematics-dsl", "version": 1, "text": text}
    both.tell("textDocument/didOpen", {"textDocument": document})
    return uri
