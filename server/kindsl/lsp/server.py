"""The language server: documents, their analyses, and who answers what."""

import asyncio
import contextlib
from collections.abc import Awaitable, Callable
from typing import TYPE_CHECKING, Any

from lsprotocol import types
from pygls.lsp.server import LanguageServer

import kindsl
from kindsl.lsp.handlers import (
    actions,
    commands,
    completing,
    configuration,
    diagnostics,
    formatting,
    highlighting,
    navigation,
    presentation,
    renaming,
    structure,
)
from kindsl.lsp.session import memory
from kindsl.lsp.session.analyses import Analyses
from kindsl.lsp.session.previews import Previews
from kindsl.lsp.session.publishing import Publisher
from kindsl.lsp.session.view import View
from kindsl.lsp.session.worker import Worker
from kindsl.lsp.session.workspace import Workspace
from kindsl.lsp.text.document import Document
from kindsl.lsp.text.open_documents import Documents
from kindsl.lsp.wire.client import Client
from kindsl.lsp.wire.protocol import Encoded, KindslProtocol

if TYPE_CHECKING:
    from kindsl.lsp.handlers.table import Handlers

Handler = Callable[[View, Any], Any]
Look = Callable[[View, Callable[[], Any]], Awaitable[Any]]

_LONG = 200_000
_PATIENCE = 0.1
_HANDLERS: "tuple[Handlers, ...]" = (
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
        news: Set when files or settings may have changed.
        refused: Documents of which the user was told that they are too broken to format.
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
        self.refused: set[str] = set()
        self.documents.on_close.append(lambda document: self.refused.discard(document.uri))
        self.previews = Previews(self)
        memory.collect_after_close(self.documents, self.worker)
        self.news = asyncio.Event()
        self.documents.on_close.append(lambda _: self.news.set())
        self._questions = 0
        self._quiet = asyncio.Event()
        self._quiet.set()
        self.loop: asyncio.AbstractEventLoop
        self.on_parent_known: Callable[[int | None], None] = lambda _: None
        super().__init__(
            "kindsl",
            kindsl.__version__,
            types.TextDocumentSyncKind.Incremental,
            protocol_cls=KindslProtocol,
        )
        for handlers in _HANDLERS:
            handlers.register(self)

    def ask_at_once(self, handler: Handler, uri: str, params: Any) -> Awaitable[Any]:
        """Ask a handler about a place of the document as it is now; None without a robot."""
        return self._answer(handler, self.documents.get(uri), params, self._look)

    def ask(self, handler: Handler, uri: str, params: Any) -> Awaitable[Any]:
        """Ask a handler about the whole document as it is now, a long one in the worker."""
        return self._answer(handler, self.documents.get(uri), params, self._read)

    def ask_judged(self, handler: Handler, uri: str, params: Any) -> Awaitable[Any]:
        """Ask a handler that needs to know what is wrong with the document as it is now."""
        return self._answer(handler, self.documents.get(uri), params, self._judge)

    async def until_quiet(self) -> None:
        """Wait until no question is open, but not for long: answers go before what is unasked."""
        if not self._quiet.is_set():
            with contextlib.suppress(TimeoutError):
                await asyncio.wait_for(self._quiet.wait(), _PATIENCE)

    async def _answer(
        self, handler: Handler, document: Document | None, params: Any, look: Look
    ) -> Any:
        if document is None or document.is_toml:
            return None
        self._questions += 1
        self._quiet.clear()
        try:
            view = View(document, await self.analyses.of(document), self)
            return await look(view, lambda: handler(view, params))
        finally:
            self._questions -= 1
            if not self._questions:
                self._quiet.set()

    async def _look(self, _: View, ask: Callable[[], Any]) -> Any:
        return ask()

    async def _read(self, view: View, ask: Callable[[], Any]) -> Any:
        if view.document.lines.length < _LONG:
            return ask()
        return await self.worker.run(lambda: self._encoded(ask))

    def _encoded(self, ask: Callable[[], Any]) -> Encoded:
        """Answer in the worker, as long as somebody waits for it."""
        result = ask()
        self.worker.checkpoint()
        return self.protocol.encoded(result)

    async def _judge(self, view: View, ask: Callable[[], Any]) -> Any:
        await self.analyses.findings(view.document)
        return await self._read(view, ask)

    def show_warning(self, message: str) -> None:
        """Tell the user why something that they asked for was not done; from any thread."""
        params = types.ShowMessageParams(types.MessageType.Warning, message)
        self.loop.call_soon_threadsafe(self.window_show_message, params)

    def report_server_error(self, error: Exception, source: Any) -> None:
        """Leave it at the log; a fault of ours never becomes a message box."""

    async def close(self) -> None:
        """Stop what runs beside the message loop."""
        await self.previews.stop()
