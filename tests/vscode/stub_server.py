"""The least of a server on pygls: one finding per document, and a command that kills it."""

import os
import sys

from lsprotocol import types
from pygls.lsp.server import LanguageServer

server = LanguageServer("stub", "0")


@server.feature(types.TEXT_DOCUMENT_DID_OPEN)
def did_open(ls: LanguageServer, params: types.DidOpenTextDocumentParams) -> None:
    place = types.Range(types.Position(0, 0), types.Position(0, 5))
    finding = types.Diagnostic(place, f"process {os.getpid()}", code="STUB", source="stub")
    uri = params.text_document.uri
    ls.text_document_publish_diagnostics(types.PublishDiagnosticsParams(uri, [finding]))


@server.feature(types.INITIALIZED)
def initialized(ls: LanguageServer, params: types.InitializedParams) -> None:
    if "--crash-when-initialized" in sys.argv:
        os._exit(3)


@server.command("stub.crash")
def crash(ls: LanguageServer) -> None:
    os._exit(3)


server.start_io()
