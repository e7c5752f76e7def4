"""The live preview of open documents, in the server's own event loop."""

import asyncio
from typing import TYPE_CHECKING, Any

from lsprotocol import types

from kindsl.lsp.session.state import State
from kindsl.lsp.session.worker import start_task
from kindsl.lsp.text import uris
from kindsl.lsp.text.document import Document
from kindsl.lsp.wire.client import asked
from kindsl.lsp.wire.protocol import RequestFailed

if TYPE_CHECKING:
    from kindsl.preview.server import PreviewServer
    from kindsl.text.span import Span


class Previews:
    """Shows documents, keeps them up to date, carries clicks back to the editor."""

    __slots__ = ("_preview", "_starting", "_state")

    def __init__(self, state: State) -> None:
        self._state = state
        self._preview: PreviewServer | None = None
        self._starting = asyncio.Lock()
        state.on_cursor.append(self._highlight)

    async def open(self, uri: str, origin: object = None) -> str:
        """Show a document and return the address of its page.

        Args:
            uri: The document.
            origin: Where else than on this machine's loopback the page is seen.

        Raises:
            RequestFailed: There is no such document, no such origin, or something is not installed.
        """
        document = self._state.documents.get(uri)
        if document is None or document.is_toml:
            raise RequestFailed(f"'{uri}' is no document that can be shown")
        preview = await self._started()
        if isinstance(origin, str):
            try:
                preview.admit(origin)
            except ValueError as error:
                raise RequestFailed(str(error)) from None
        await self._show(preview, document)
        return preview.url(uris.key(uri))

    async def update(self, document: Document) -> None:
        """Show a new version of a document that is shown."""
        if self._preview is not None and self._preview.shows(uris.key(document.uri)):
            await self._show(self._preview, document)

    def saved(self, uri: str) -> None:
        """Let the version that was saved stand as a ghost behind later ones."""
        if self._preview is not None:
            self._preview.saved(uris.key(uri))

    async def stop(self) -> None:
        """Close all pages."""
        if self._preview is not None:
            await self._preview.stop()

    async def _show(self, preview: "PreviewServer", document: Document) -> None:
        analysis = await self._state.analyses.of(document)
        findings = await self._state.analyses.findings(document)
        await preview.show(uris.key(document.uri), analysis, findings, uris.basename(document.uri))

    async def _started(self) -> "PreviewServer":
        async with self._starting:
            if self._preview is None:
                preview = await self._state.worker.run(self._load)
                try:
                    await preview.start()
                except (ImportError, OSError, RuntimeError) as error:
                    raise RequestFailed(f"the preview cannot start: {error}") from None
                self._preview = preview
        return self._preview

    def _load(self) -> "PreviewServer":
        try:
            from kindsl.preview.server import PreviewServer
        except ImportError as error:
            hint = "install it with: pip install 'kindsl[preview]'"
            raise RequestFailed(f"the preview needs {error.name}; {hint}") from None
        return PreviewServer(on_reveal=self._reveal)

    def _reveal(self, key: str, span: "Span", _: Any) -> None:
        """Show in the editor what was clicked in a page."""
        document = self._state.documents.get(key)
        if document is not None and self._state.client.can("window.show_document.support"):
            selection = document.range(*span)
            shown = types.ShowDocumentParams(document.uri, False, True, selection)
            start_task(asked(self._state.editor.window_show_document_async(shown)))

    def _highlight(self, uri: str, kind: str, name: str) -> None:
        """Light up what the cursor is on; from any thread."""
        if self._preview is not None:
            show = self._preview.highlight
            self._state.loop.call_soon_threadsafe(show, uris.key(uri), kind, name)
