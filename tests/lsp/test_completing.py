"""Completion on the wire: what comes by itself, what comes when asked, what can be inserted."""

from typing import Any

import pytest
from tests.features.samples import ARM
from tests.support.lsp import RawClient, raw_client, ready_client
from tests.support.lsp_requests import place_of

URI = "untitled:arm"
INVOKED, TYPED, NARROWED = 1, 2, 3
SNIPPETS = {"textDocument": {"completion": {"completionItem": {"snippetSupport": True}}}}


class Typist:
    """Types at one place of a document and asks for lists there."""

    def __init__(self, client: RawClient, text: str, at: str) -> None:
        self.client, self.version = client, 1
        self.text = text
        self.offset = text.index(at)
        client.open(URI, text)

    def type(self, text: str) -> None:
        for key in text:
            self.version += 1
            place = place_of(self.text, self.offset)
            self.client.change(
                URI, self.version, {"range": {"start": place, "end": place}, "text": key}
            )
            self.text = self.text[: self.offset] + key + self.text[self.offset :]
            self.offset += 1

    def items(self, kind: int) -> list[dict[str, Any]]:
        answer = self.client.request(
            "textDocument/completion",
            {
                "textDocument": {"uri": URI},
                "position": place_of(self.text, self.offset),
                "context": {"triggerKind": kind},
            },
        )
        assert answer["isIncomplete"] is bool(answer["items"])
        found: list[dict[str, Any]] = answer["items"]
        return found

    def labels(self, kind: int) -> list[str]:
        return [item["label"] for item in self.items(kind)]


def test_neither_a_brace_nor_an_equals_sign_opens_a_list() -> None:
    with raw_client() as client:
        provider = client.initialize()["capabilities"]["completionProvider"]
        assert not {"{", "}", "="} & set(provider["triggerCharacters"])


@pytest.mark.parametrize("capabilities", [{}, SNIPPETS], ids=["plain", "snippets"])
def test_a_list_that_comes_by_itself_knows_when_a_word_is_whole(
    capabilities: dict[str, Any],
) -> None:
    with ready_client(capabilities) as client:
        typist = Typist(client, ARM.replace("elbow\n", "\n"), "\n    }\n}\n\nlink lower")
        assert typist.labels(TYPED) == ["elbow"]
        typist.type("el")
        assert typist.labels(INVOKED) == ["elbow"]
        typist.type("bow")
        assert typist.labels(NARROWED) == []
        assert typist.labels(INVOKED) == []


def test_who_asks_sees_all_and_goes_on_seeing_it() -> None:
    with ready_client(SNIPPETS) as client:
        typist = Typist(client, ARM.replace("children {}\n", "children {}\n    \n"), "\n    frames")
        assert typist.labels(INVOKED) == []
        joint = Typist(client, ARM.replace("elbow\n", "\n"), "\n    }\n}\n\nlink lower")
        assert joint.labels(INVOKED) == ["elbow", "shoulder"]
        joint.type("s")
        assert joint.labels(NARROWED) == ["shoulder"]
        joint.type("houlder")
        assert joint.labels(NARROWED) == []


def test_a_word_just_typed_is_asked_for_by_asking_twice() -> None:
    with ready_client(SNIPPETS) as client:
        typist = Typist(client, ARM.replace("    children {}\n", "\n"), "\n    frames")
        typist.type("children")
        assert typist.labels(INVOKED) == []
        assert typist.labels(INVOKED) == ["children", "children {}"]


def test_digits_are_never_the_beginning_of_an_offered_number() -> None:
    with ready_client(SNIPPETS) as client:
        text = ARM.replace("id = 2", "id = ")
        typist = Typist(client, text, "\n    inertia_params {\n        mass = 1.0")
        assert typist.items(TYPED) == []
        (item,) = typist.items(INVOKED)
        assert (item["label"], item["filterText"]) == ("2", " ")


def test_an_editor_without_snippets_inserts_one_line() -> None:
    with ready_client() as client:
        typist = Typist(client, "Robot R {\n", "\n")
        typist.type("\nRo")
        items = typist.items(INVOKED)
        assert items
        for item in items:
            assert not set("\n\r\0$") & set(item["textEdit"]["newText"])
            assert item["insertTextFormat"] == 1


def test_an_item_of_a_document_that_is_closed_stays_as_it_is() -> None:
    item = {"label": "link", "data": {"uri": URI, "kind": "keyword"}}
    with ready_client() as client:
        client.open(URI, ARM)
        assert "documentation" in client.request("completionItem/resolve", item)
        client.close(URI)
        assert client.request("completionItem/resolve", item) == item
