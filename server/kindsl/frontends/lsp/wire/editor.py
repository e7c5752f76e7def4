"""The editor at the other end: what it can be told and asked, by the protocol's names."""

from typing import Any

from lsprotocol import types
from pygls.lsp.server import LanguageServer

import kindsl
from kindsl.frontends.lsp.wire.protocol import KindslProtocol


class Editor(LanguageServer):
    """pygls' server with our protocol."""

    protocol: KindslProtocol

    def __init__(self) -> None:
        super().__init__(
            "kindsl",
            kindsl.__version__,
            types.TextDocumentSyncKind.Incremental,
            protocol_cls=KindslProtocol,
        )

    def report_server_error(self, error: Exception, source: Any) -> None:
        """Leave it at the log; a fault of ours never becomes a message box."""
