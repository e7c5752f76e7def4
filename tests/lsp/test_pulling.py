"""Who is told that diagnostics may be pulled, and that each finding is shown exactly once.

What a client shows is what it was pushed and what it pulled, in collections of their own; it pulls
if it declares that it can and the server says that it may. So `docs/editors.md` has it.
"""

import json
from itertools import product
from typing import Any

import pytest
from tests.lsp.test_workspace import ROBOT, UNBOUND, whole
from tests.support.lsp import RawClient, raw_client

from kindsl.frontends.lsp.browser import start

URI = "untitled:pulling"
PUSH = "textDocument/publishDiagnostics"
CLIENTS = [
    (pull, push, refresh)
    for pull, push, refresh in product(
        (None, {}, {"dynamicRegistration": False}, {"dynamicRegistration": True}),
        (None, {}, {"relatedInformation": True}),
        (None, False, True),
    )
]
NEOVIM_11 = {"dynamicRegistration": False}, {"relatedInformation": True}, None
VS_CODE = {"dynamicRegistration": True}, {"relatedInformation": True}, True


def capabilities(pull: Any, push: Any, refresh: bool | None) -> dict[str, Any]:
    """Return what a client declares; None is what it leaves out."""
    given = {"diagnostic": pull, "publishDiagnostics": push}
    document = {name: value for name, value in given.items() if value is not None}
    if refresh is None:
        return {"textDocument": document}
    return {"textDocument": document, "workspace": {"diagnostics": {"refreshSupport": refresh}}}


def pulled(client: RawClient) -> set[str]:
    """Return the codes that a client gets when it asks."""
    report = client.request("textDocument/diagnostic", {"textDocument": {"uri": URI}})
    return {each["code"] for each in report["items"]}


def pushed_since(client: RawClient) -> list[list[Any]]:
    """Return what was pushed for the document since this was last asked."""
    pushes = (m["params"] for m in client.drain() if m.get("method") == PUSH)
    return [params["diagnostics"] for params in pushes if params["uri"] == URI]


@pytest.mark.parametrize(("pull", "push", "refresh"), CLIENTS)
async def test_who_shows_nothing_or_can_be_asked_again_is_told(
    pull: Any, push: Any, refresh: bool | None
) -> None:
    answers: list[str] = []
    declared = capabilities(pull, push, refresh)
    params = {"processId": None, "rootUri": None, "capabilities": declared}
    question = {"jsonrpc": "2.0", "id": 1, "method": "initialize", "params": params}
    start(answers.append)(json.dumps(question))
    is_told = "diagnosticProvider" in json.loads(answers[0])["result"]["capabilities"]
    assert is_told is (pull is not None and (refresh is True or push is None))


@pytest.mark.parametrize(
    ("pull", "push", "refresh"),
    [(None, None, None), (None, {}, None), ({}, None, None), ({}, None, True), NEOVIM_11, VS_CODE],
)
def test_every_finding_is_shown_once(pull: Any, push: Any, refresh: bool | None) -> None:
    with raw_client() as client:
        announced = client.initialize(capabilities(pull, push, refresh))["capabilities"]
        is_told = "diagnosticProvider" in announced
        client.open(URI, ROBOT)
        assert UNBOUND in client.codes(URI)
        if is_told:
            assert UNBOUND in pulled(client)
            assert pushed_since(client)[-1:] == [[]]
        client.change(URI, 2, whole(ROBOT + "\n"))
        if is_told:
            assert UNBOUND in pulled(client)
            assert not any(pushed_since(client))
        else:
            assert UNBOUND in client.codes(URI)


@pytest.mark.parametrize(("pull", "push", "refresh"), [(None, None, None), NEOVIM_11])
def test_who_asks_is_always_answered(pull: Any, push: Any, refresh: bool | None) -> None:
    with raw_client() as client:
        client.initialize(capabilities(pull, push, refresh))
        client.open(URI, ROBOT)
        assert UNBOUND in pulled(client)
