"""The preview's address reaches users whose editor has no panel of its own for it."""

from typing import Any

from tests.features.samples import ARM
from tests.support.lsp import RawClient, ready_client

URI = "untitled:arm"
SHOWS = {"window": {"showDocument": {"support": True}}}


def preview(client: RawClient, *arguments: Any) -> str:
    params = {"command": "kindsl.preview", "arguments": [*arguments]}
    url: str = client.request("workspace/executeCommand", params)["url"]
    return url


def test_an_editor_that_can_opens_it() -> None:
    with ready_client(SHOWS) as client:
        client.open(URI, ARM)
        url = preview(client, URI)
        assert client.notification("window/showDocument") == {"uri": url, "external": True}


def test_another_is_told_it() -> None:
    with ready_client() as client:
        client.open(URI, ARM)
        url = preview(client, URI)
        assert client.notification("window/showMessage") == {
            "type": 3,
            "message": f"The preview is at {url}",
        }


def test_an_editor_with_a_panel_of_its_own_is_not_told() -> None:
    with ready_client(SHOWS, initializationOptions={"kindsl/status": True}) as client:
        client.open(URI, ARM)
        preview(client, URI)
        methods = {message.get("method") for message in client.drain()}
        assert not {"window/showDocument", "window/showMessage"} & methods


def test_without_an_argument_it_is_the_only_open_document() -> None:
    with ready_client() as client:
        client.open(URI, ARM)
        assert preview(client) == preview(client, URI)
        client.open("untitled:other", ARM)
        params = {"command": "kindsl.preview", "arguments": []}
        assert client.refusal("workspace/executeCommand", params)["code"] == -32602
