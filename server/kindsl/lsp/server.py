"""The language server: documents, their analyses, and who answers what."""

import asyncio
from collections.abc import Awaitable, Callable
from typing import TYPE_CHECKING, Any

from lsprotocol import types
from pygls.lsp.server import LanguageServer

import kindsl
from kindsl.lsp import (
    actions,
    commands,
    completing,
    configuration,
    diagnostics,
    formatting,
    highlighting,
    lifecycle,
    navigation,
    presentation,
    renaming,
    structure,
)
from kindsl.lsp.analyses import Analyses
from kindsl.lsp.client import Client
from kindsl.lsp.document import Document
from kindsl.lsp.documents import Documents
from kindsl.lsp.previews import Previews
from kindsl.lsp.protocol import KindslProtocol
from kindsl.lsp.publishing import Publisher
from kindsl.lsp.view import View
from kindsl.lsp.worker import Worker
from kindsl.lsp.workspace import Workspace

if TYPE_CHECKING:
    from kindsl.lsp.handlers import Handlers

Handler = Callable[[View, Any], Any]

_LONG = 200_000
_HANDLERS: "tuple[Handlers, ...]" = (
    lifecycle.handlers,
    configuration.handlers,
    diagnostics.handlers,
    navigation.handlers,
    structure.handlers,
    highlighting.handlers,
    renaming.handlers,
    formatting.handlers,
    actions.handlers,
    presentation.handlers,
    completing.handlers,
    commands.handlers,
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
        previews: The live previews.
        tokens: The semantic tokens that the client knows.
        on_parent_known: Called with the id of the process that started the server, if it says so.
    """

    protocol: KindslProtocol

    def __init__(self) -> None:
        self.client = Client(types.ClientCapabilities(), {})
        self.documents = Documents()
        self.worker = Worker()
        self.settings = Workspace()
        self.analyses = Analyses(self.worker, self.settings)
        self.publisher = Publisher(self)
        self.tokens = highlighting.TokenMemory()
        self.documents.on_close.append(self.tokens.forget)
        self.previews = Previews(self)
        self.loop: asyncio.AbstractEventLoop
        self.on_parent_known: Callable[[int | None], None] = lambda _: None
        super().__init__(
            "kindsl",
            getattr(kindsl, "__version__", "0.1.0"),
            types.TextDocumentSyncKind.Incremental,
            protocol_cls=KindslProtocol,
        )
        for handlers in _HANDLERS:
            handlers.register(self)

    def ask_judged(self, handler: Handler, uri: str, params: Any) -> Awaitable[Any]:
        """Ask a handler that needs to know what is wrong with the document as it is now."""
        return self._answer_judged(handler, self.documents.get(uri), params)

    def ask(self, handler: Handler, uri: str, params: Any) -> Awaitable[Any]:
        """Ask a handler about the document as it is now; None when there is no such robot."""
        return self._answer(handler, self.documents.get(uri), params)

    async def _answer_judged(self, handler: Handler, document: Document | None, params: Any) -> Any:
        if document is not None and not document.is_toml:
            await self.analyses.findings(document)
        return await self._answer(handler, document, params)

    async def _answer(self, handler: Handler, document: Document | None, params: Any) -> Any:
        """Let a handler look at one version of a document, for a long one in the worker."""
        if document is None or document.is_toml:
            return None
        view = View(document, await self.analyses.of(document), self)
        if document.lines.length < _LONG:
            return handler(view, params)
        return await self.worker.run(lambda: self.protocol.encoded(handler(view, params)))

    def show_warning(self, message: str) -> None:
        """Tell the user why something that they asked for was not done; from any thread."""
        params = types.ShowMessageParams(types.MessageType.Warning, message)
        self.loop.call_soon_threadsafe(self.window_show_message, params)

    def report_server_error(self, error: Exception, source: Any) -> None:
        """Leave it at the log; a fault of ours never becomes a message box."""

    async def close(self) -> None:
        """Stop what runs beside the message loop."""
        await self.previews.stop()
