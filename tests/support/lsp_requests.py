"""Every request that the language server answers, at one place of one document."""

from collections.abc import Iterator
from typing import Any

Request = tuple[str, dict[str, Any]]

_AT_A_PLACE: tuple[tuple[str, dict[str, Any]], ...] = (
    ("hover", {}),
    ("completion", {}),
    ("signatureHelp", {}),
    ("definition", {}),
    ("declaration", {}),
    ("references", {"context": {"includeDeclaration": True}}),
    ("documentHighlight", {}),
    ("prepareRename", {}),
    ("prepareCallHierarchy", {}),
    ("linkedEditingRange", {}),
    ("onTypeFormatting", {"ch": "\n", "options": {"tabSize": 4, "insertSpaces": True}}),
)
_OF_THE_WHOLE: tuple[tuple[str, dict[str, Any]], ...] = (
    ("documentSymbol", {}),
    ("foldingRange", {}),
    ("documentLink", {}),
    ("codeLens", {}),
    ("semanticTokens/full", {}),
    ("diagnostic", {}),
    ("formatting", {"options": {"tabSize": 4, "insertSpaces": True}}),
)
_OF_A_RANGE: tuple[tuple[str, dict[str, Any]], ...] = (
    ("semanticTokens/range", {}),
    ("inlayHint", {}),
    ("codeAction", {"context": {"diagnostics": []}}),
    ("rangeFormatting", {"options": {"tabSize": 4, "insertSpaces": True}}),
)


def every_request(uri: str, place: dict[str, int]) -> Iterator[Request]:
    """Yield a request of each kind; renaming is left out, since it may rightly be refused."""
    document = {"textDocument": {"uri": uri}}
    around = {"start": {"line": max(place["line"] - 3, 0), "character": 0}, "end": place}
    for name, more in _AT_A_PLACE:
        yield f"textDocument/{name}", {**document, "position": place, **more}
    for name, more in _OF_THE_WHOLE:
        yield f"textDocument/{name}", {**document, **more}
    for name, more in _OF_A_RANGE:
        yield f"textDocument/{name}", {**document, "range": around, **more}
    yield "textDocument/selectionRange", {**document, "positions": [place]}
    yield "workspace/symbol", {"query": "a"}
    item = {"uri": uri, "name": "a", "kind": 5, "range": around, "selectionRange": around}
    yield "callHierarchy/incomingCalls", {"item": item}
    yield "callHierarchy/outgoingCalls", {"item": item}
    yield "completionItem/resolve", {"label": "link", "data": {"uri": uri, "kind": "keyword"}}


def place_of(text: str, offset: int) -> dict[str, int]:
    """Return the client's position (UTF-32) of an offset in a text with LF line ends."""
    line = text.count("\n", 0, offset)
    return {"line": line, "character": offset - text.rfind("\n", 0, offset) - 1}
