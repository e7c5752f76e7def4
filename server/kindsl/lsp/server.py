"""The language server: documents, their analyses, and who answers what."""

from collections.abc import Awaitable, Callable
from typing import TYPE_CHECKING, Any

from lsprotocol import types
from pygls.lsp.server import LanguageServer

import kindsl
from kindsl.lsp import configuration, diagnostics, lifecycle
from kindsl.lsp.analyses import Analyses
from kindsl.lsp.client import Client
from kindsl.lsp.document import Document
from kindsl.lsp.documents import Documents
from kindsl.lsp.protocol import KindslProtocol
from kindsl.lsp.publishing import Publisher
from kindsl.lsp.view import View
from kindsl.lsp.worker import Worker
from kindsl.lsp.workspace import Workspace

if TYPE_CHECKING:
    from kindsl.lsp.handlers import Handlers

_LONG = 200_000
_HANDLERS: "tuple[Handlers, ...]" = (
    lifecycle.handlers,
    configuration.handlers,
    diagnostics.handlers,
)


class KindslLanguageServer(LanguageServer):
    """What the handlers share.

    Attributes:
        client: What the editor can do.
        documents: What the editor shows.
        worker: The thread for long work.
        settings: The folders and their settings.
        analyses: What is known about each version of a document.
        publisher: Pushes diagnostics.
        on_parent_known: Called with the id of the process that started the server, if it says so.
    """

    protocol: KindslProtocol

    def __init__(self) -> None:
        self.client = Client(types.ClientCapabilities(), {})
        self.documents = Documents()
        self.worker = Worker()
        self.settings = Workspace()
        self.analyses = Analyses(self.worker, self.settings.settings)
        self.publisher = Publisher(self)
        self.on_parent_known: Callable[[int | None], None] = lambda _: None
        super().__init__(
            "kindsl",
            getattr(kindsl, "__version__", "0.1.0"),
            types.TextDocumentSyncKind.Incremental,
            protocol_cls=KindslProtocol,
        )
        for handlers in _HANDLERS:
            handlers.register(self)

    def answer(
        self, handler: Callable[[View, Any], Any], uri: str, params: Any
    ) -> Awaitable[Any] | None:
        """Ask a handler about the document as it is now; None when there is none."""
        document = self.documents.get(uri)
        return None if document is None else self.view(document, handler, params)

    async def view(
        self, document: Document, handler: Callable[[View, Any], Any], params: Any
    ) -> Any:
        """Let a handler look at one version of a document, for a long one in the worker."""
        analysis = await self.analyses.of(document)
        view = View(document, analysis, self)
        if document.lines.length < _LONG:
            return handler(view, params)
        return await self.worker.run(lambda: handler(view, params))

    def report_server_error(self, error: Exception, source: Any) -> None:
        """Leave it at the log; a fault of ours never becomes a message box."""

    async def close(self) -> None:
        """Stop what runs beside the message loop."""
