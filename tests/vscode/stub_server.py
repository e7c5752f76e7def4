"""The least of a server on pygls: one finding per document, and a command that kills it.

With `--silent-tree` it never tells the kinematic tree, but finds that it was asked for.
"""

import asyncio
import os
import sys
from typing import Any

from lsprotocol import types
from pygls.lsp.server import LanguageServer

server = LanguageServer("stub", "0")
found: dict[tuple[str, str], types.Diagnostic] = {}


@server.feature(types.TEXT_DOCUMENT_DID_OPEN)
def did_open(ls: LanguageServer, params: types.DidOpenTextDocumentParams) -> None:
    find(ls, params.text_document.uri, f"process {os.getpid()}")


async def kinematic_tree(ls: LanguageServer, params: Any) -> None:
    find(ls, params.textDocument.uri, f"tree of process {os.getpid()}")
    await asyncio.Event().wait()


if "--silent-tree" in sys.argv:
    server.feature("kindsl/kinematicTree")(kinematic_tree)


def find(ls: LanguageServer, uri: str, message: str) -> None:
    place = types.Range(types.Position(0, 0), types.Position(0, 5))
    found[uri, message] = types.Diagnostic(place, message, code="STUB", source="stub")
    findings = [finding for (known, _), finding in found.items() if known == uri]
    ls.text_document_publish_diagnostics(types.PublishDiagnosticsParams(uri, findings))


@server.feature(types.INITIALIZED)
def initialized(ls: LanguageServer, params: types.InitializedParams) -> None:
    if "--crash-when-initialized" in sys.argv:
        os._exit(3)


@server.command("stub.crash")
def crash(ls: LanguageServer) -> None:
    os._exit(3)


server.start_io()
