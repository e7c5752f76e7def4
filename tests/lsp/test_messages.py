"""What is checked of each message that the server sends in these tests."""

from typing import Any

import pytest
from tests.support.lsp_messages import faults

PLACE = {"start": {"line": 0, "character": 0}, "end": {"line": 0, "character": 1}}
DIAGNOSTIC = {"range": PLACE, "message": "m"}


def published(**diagnostic: Any) -> dict[str, Any]:
    params = {"uri": "untitled:a", "diagnostics": [DIAGNOSTIC | diagnostic]}
    return {"jsonrpc": "2.0", "method": "textDocument/publishDiagnostics", "params": params}


def answered(result: Any) -> dict[str, Any]:
    return {"jsonrpc": "2.0", "id": 1, "result": result}


@pytest.mark.parametrize(
    ("message", "method"),
    [
        (published(), ""),
        (published(severity=1, code="KD101", tags=[1], data={"any": [None]}), ""),
        (answered(None), "textDocument/hover"),
        (answered({"contents": {"kind": "markdown", "value": "*"}}), "textDocument/hover"),
        (answered({"contents": "text", "range": PLACE}), "textDocument/hover"),
        (answered([{"label": "a"}]), "textDocument/completion"),
        (answered({"isIncomplete": False, "items": [{"label": "a"}]}), "textDocument/completion"),
        (answered({"kind": "full", "items": []}), "textDocument/diagnostic"),
        (answered({"anything": 1}), "workspace/executeCommand"),
        (answered("ours"), "kindsl/anything"),
        ({"jsonrpc": "2.0", "id": None, "error": {"code": -1, "message": "m"}}, ""),
    ],
)
def test_what_is_specified_passes(message: dict[str, Any], method: str) -> None:
    assert list(faults(message, {1: method})) == []


@pytest.mark.parametrize(
    ("message", "method", "fault"),
    [
        (published(severity=5), "", "severity is 5"),
        (published(severity=True), "", "severity is True"),
        (published(range={}), "", "range.start is missing"),
        (published(source=None), "", "source is null"),
        (published(colour=1), "", "colour is not specified"),
        (published(range=PLACE | {"end": {"line": -1, "character": 0}}), "", "range"),
        (published(range=PLACE | {"end": {"line": 1.5, "character": 0}}), "", "line is 1.5"),
        (published(relatedInformation=[{}]), "", "relatedInformation[0].location is missing"),
        (answered({"contents": {"kind": "rich", "value": "*"}}), "textDocument/hover", "contents"),
        (answered({"items": []}), "textDocument/completion", "isIncomplete is missing"),
        (answered({"kind": "half", "items": []}), "textDocument/diagnostic", "kind is 'half'"),
        (answered({"items": []}), "textDocument/diagnostic", "kind is missing"),
        ({"jsonrpc": "2.0", "id": 1}, "textDocument/hover", "result is missing"),
        ({"id": 1, "result": None}, "textDocument/hover", "jsonrpc is missing"),
        (answered(None), "textDocument/dance", "textDocument/dance is not specified"),
        ({"jsonrpc": "2.0", "id": 2, "result": None}, "", "answers no request"),
        ({"jsonrpc": "2.0", "id": 1, "error": {"code": "x", "message": "m"}}, "", "code is 'x'"),
        (
            {"jsonrpc": "2.0", "method": "textDocument/didSave", "params": {}},
            "",
            "textDocument/didSave is for clients to send",
        ),
    ],
)
def test_what_is_not_specified_is_told(message: dict[str, Any], method: str, fault: str) -> None:
    found = list(faults(message, {1: method} if method else {}))
    assert any(fault in each for each in found), found
