"""A session with an editor: what it knows, what it offers unasked, and how it is asked."""

from collections.abc import Awaitable, Callable
from math import inf
from typing import Any

from kindsl.frontends.lsp.session.closed_configurations import ClosedConfigurations
from kindsl.frontends.lsp.session.previews import Previews
from kindsl.frontends.lsp.session.publishing import Publisher
from kindsl.frontends.lsp.session.state import State
from kindsl.frontends.lsp.session.surroundings import Surroundings
from kindsl.frontends.lsp.session.view import View
from kindsl.frontends.lsp.text.document import Document
from kindsl.frontends.lsp.wire.protocol import Editor, Encoded

Handler = Callable[[View, Any], Any]

_LONG = 200_000


class Session(State):
    """Answers questions about documents; handlers are asked with a view of one version."""

    def __init__(self, editor: Editor, surroundings: Surroundings) -> None:
        super().__init__(editor, surroundings)
        self.previews = Previews(self)
        self.publisher = Publisher(self)
        self.closed = ClosedConfigurations(self, self.publisher.publish)

    def ask_at_once(self, handler: Handler, uri: str, params: Any) -> Awaitable[Any]:
        """Ask a handler about a place of the document as it is now; None without a robot."""
        return self._answer(handler, self.documents.get(uri), params, inf)

    def ask(self, handler: Handler, uri: str, params: Any) -> Awaitable[Any]:
        """Ask a handler about the whole document as it is now, a long one in the worker."""
        return self._answer(handler, self.documents.get(uri), params)

    def ask_judged(self, handler: Handler, uri: str, params: Any) -> Awaitable[Any]:
        """Ask a handler that needs to know what is wrong with the document as it is now."""
        return self._answer(handler, self.documents.get(uri), params, is_judged=True)

    async def view(self, document: Document) -> View:
        """Return a version of a document with its analysis."""
        return View(document, await self.analyses.of(document), self)

    async def close(self) -> None:
        """Stop what runs beside the message loop."""
        await self.previews.stop()
        self.helper.stop()

    async def _answer(
        self,
        handler: Handler,
        document: Document | None,
        params: Any,
        long: float = _LONG,
        *,
        is_judged: bool = False,
    ) -> Any:
        """Return an answer, made in the worker where a document is long; once it is judged first.

        Until it is judged, the question holds up nothing.
        """
        if document is None or not document.is_robot:
            return None
        if is_judged:
            await (await self.analyses.version(document)).findings()
        with self.question():
            view = await self.view(document)
            if document.lines.length < long:
                return handler(view, params)
            return await self.worker.run(lambda: self._encoded(handler(view, params)))

    def _encoded(self, answer: Any) -> Encoded:
        self.worker.checkpoint()
        return self.editor.protocol.encoded(answer)
