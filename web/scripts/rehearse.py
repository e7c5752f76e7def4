"""Use the server once, so that all that is made at first use is in the memory image.

Runs in Pyodide at build time, with `texts` set. Its value is what went wrong, else an empty text.
"""

import asyncio
import gc
import json

from kindsl.frontends.lsp.browser import PREVIEW_REQUEST, start

answers = []


class Rehearsal:
    """A client that asks everything once."""

    def __init__(self):
        self.receive = start(answers.append)
        self.count = 0

    def ask(self, method, params):
        """Send a request."""
        self.count += 1
        self.send({"id": self.count, "method": method, "params": params})

    def tell(self, method, params):
        """Send a notification."""
        self.send({"method": method, "params": params})

    def send(self, message):
        """Send a message."""
        self.receive(json.dumps({"jsonrpc": "2.0", **message}))


async def quiet():
    """Wait until no answer has come for a while."""
    known = -1
    while known != len(answers):
        known = len(answers)
        await asyncio.sleep(0.5)


CAPABILITIES = {
    "textDocument": {
        "publishDiagnostics": {"relatedInformation": True},
        "hover": {"contentFormat": ["markdown"]},
        "completion": {"completionItem": {"snippetSupport": True}},
        "codeAction": {
            "codeActionLiteralSupport": {"codeActionKind": {"valueSet": ["quickfix", "refactor"]}}
        },
        "documentSymbol": {"hierarchicalDocumentSymbolSupport": True},
    },
    "window": {"showDocument": {"support": True}},
}


async def rehearse():
    """Open, ask, edit, show and close each text."""
    client = Rehearsal()
    client.ask("initialize", {"processId": None, "rootUri": None, "capabilities": CAPABILITIES})
    client.tell("initialized", {})
    for number, text in enumerate(texts):  # noqa: F821 (set by the build)
        await show(client, f"file:///rehearsal{number}.kindsl", text)
    client.ask("shutdown", None)
    await quiet()


async def show(client, uri, text):
    """Do with one text what somebody does with it."""
    document = {"uri": uri}
    on_document = {"textDocument": document}
    opened = {**document, "languageId": "kinematics-dsl", "version": 1, "text": text}
    client.tell("textDocument/didOpen", {"textDocument": opened})
    await quiet()
    client.ask("workspace/executeCommand", {"command": "kindsl.preview", "arguments": [uri]})
    await quiet()
    page = json.loads(answers[-1]).get("result") or {}
    hello = {"type": "hello", "joints": {}, "parameters": {}}
    client.tell(PREVIEW_REQUEST, {"document": page.get("url"), "request": hello})
    await quiet()
    start_of_text = {"line": 0, "character": 0}
    change = {"range": {"start": start_of_text, "end": start_of_text}, "text": " "}
    changed = {"textDocument": {**document, "version": 2}, "contentChanges": [change]}
    client.tell("textDocument/didChange", changed)
    await quiet()
    place = {**on_document, "position": {"line": 3, "character": 6}}
    context = {"includeDeclaration": True, "triggerKind": 1, "isRetrigger": False}
    for method in ("hover", "completion", "definition", "documentHighlight", "references"):
        client.ask(f"textDocument/{method}", {**place, "context": context})
    for method in ("documentSymbol", "foldingRange", "semanticTokens/full", "codeLens"):
        client.ask(f"textDocument/{method}", on_document)
    whole = {"start": start_of_text, "end": {"line": text.count("\n"), "character": 0}}
    in_whole = {**on_document, "range": whole}
    client.ask("textDocument/codeAction", {**in_whole, "context": {"diagnostics": []}})
    client.ask("textDocument/inlayHint", in_whole)
    options = {"tabSize": 4, "insertSpaces": True}
    client.ask("textDocument/formatting", {**on_document, "options": options})
    await quiet()
    client.tell("textDocument/didClose", on_document)


await rehearse()  # noqa: F704, PLE1142 (run as asynchronous code)
problems = [error["message"] for error in (json.loads(a).get("error") for a in answers) if error]
answers.clear()
for _ in range(3):
    gc.collect()
"; ".join(problems)
