"""The state of one session with an editor, as all that takes part in it sees it."""

import asyncio
import contextlib
from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING

from lsprotocol import types

from kindsl.frontends.lsp.session import memory
from kindsl.frontends.lsp.session.analyses import Analyses
from kindsl.frontends.lsp.session.calm import Calm
from kindsl.frontends.lsp.session.helper import Helper
from kindsl.frontends.lsp.session.surroundings import Surroundings
from kindsl.frontends.lsp.session.worker import Urgency
from kindsl.frontends.lsp.session.workspace import Workspace
from kindsl.frontends.lsp.text import uris
from kindsl.frontends.lsp.text.document import Document
from kindsl.frontends.lsp.wire.client import Client
from kindsl.frontends.lsp.wire.protocol import Editor

if TYPE_CHECKING:
    from kindsl.judgement.analysis.diagnostics import Diagnostic

PATIENCE = 0.1


class State:
    """The state of one session; it decides nothing.

    Attributes:
        quiet: Set while no question is open.
        news: Set when files or settings may have changed.
        refused: Documents of which the user was told that they are too broken to format.
        until_told: Done when the editor knows the latest preview's address.
        asked_list: URI and start of the open list of completions, if the user asked for it.
        loop: Where messages are read, once they are.
        on_cursor: Called with a document, and the kind and name of what the cursor is on there.
        on_findings: Called with an open document and what was found in that version.
        on_parent_known: Called with the id of the process that started the server, if it says so.
    """

    def __init__(self, editor: Editor, surroundings: Surroundings) -> None:
        self.editor = editor
        self.surroundings = surroundings
        self.client = Client(types.ClientCapabilities(), {})
        self.helper = Helper(surroundings.worker, surroundings.n_helpers)
        self.documents = editor.protocol.documents
        self.worker = surroundings.worker
        self.workspace = Workspace()
        self.analyses = Analyses(self.worker, self.workspace)
        self.calm = Calm(self.documents)
        self.news = asyncio.Event()
        self.refused: set[str] = set()
        self.until_told: asyncio.Future[None] | None = None
        self.asked_list: tuple[str, int] | None = None
        self.loop: asyncio.AbstractEventLoop
        self.on_cursor: list[Callable[[str, str, str], None]] = []
        self.on_findings: list[Callable[[Document, Sequence[Diagnostic]], None]] = []
        self.on_parent_known: Callable[[int | None], None] = lambda _: None
        self._questions = 0
        self.quiet = asyncio.Event()
        self.quiet.set()
        self.documents.on_close += [
            lambda document: self.refused.discard(document.uri),
            lambda _: self.news.set(),
        ]
        memory.collect_after_close(self.documents, self.worker)

    @contextlib.contextmanager
    def question(self) -> Iterator[None]:
        """Count a question as open while it is answered."""
        self._questions += 1
        self.quiet.clear()
        try:
            yield
        finally:
            self._questions -= 1
            if not self._questions:
                self.quiet.set()

    async def until_quiet(self) -> None:
        """Wait until no question is open, but not for long: answers go before what is unasked."""
        if not self.quiet.is_set():
            with contextlib.suppress(TimeoutError):
                await asyncio.wait_for(self.quiet.wait(), PATIENCE)

    def show_warning(self, message: str) -> None:
        """Tell the user why something that they asked for was not done; from any thread."""
        params = types.ShowMessageParams(types.MessageType.Warning, message)
        self.loop.call_soon_threadsafe(self.editor.window_show_message, params)

    async def open_and_closed(self) -> list[str]:
        """Return the URI of every document that is open and robot in the workspace, each once."""
        files = await self.worker.run(
            lambda: [uris.uri(file) for file in self.workspace.files()], Urgency.BACKGROUND
        )
        found = {uris.key(document.uri): document.uri for document in self.documents}
        for uri in files:
            found.setdefault(uris.key(uri), uri)
        return list(found.values())
