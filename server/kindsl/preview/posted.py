"""Previews whose pages are in the same browser: messages as JSON instead of a server."""

import asyncio
from collections.abc import Callable
from typing import Any, NamedTuple, TypeVar

from kindsl.preview.channel import Tab
from kindsl.preview.document_preview import DocumentPreview
from kindsl.preview.documents import DocumentPreviews, OnEdit, OnReveal
from kindsl.preview.documents import identifier as identifier_of
from kindsl.preview.requests import Hello, request_of
from kindsl.scene.encoding import as_json
from kindsl.scene.messages import Change

T = TypeVar("T")

Post = Callable[[str, str], None]


class _Page(NamedTuple):
    """A page that has said hello, and the task that writes to it."""

    tab: Tab
    writing: "asyncio.Task[None]"


class PostedPreviews(DocumentPreviews):
    """Shows documents by messages; a page is told by the identifier of its document."""

    def __init__(
        self, post: Post, on_reveal: OnReveal | None = None, on_edit: OnEdit | None = None
    ) -> None:
        """Take what sends a JSON text to the pages of a document."""
        super().__init__(on_reveal, on_edit=on_edit, beside=_at_once)
        self._post = post
        self._pages: dict[str, _Page] = {}

    async def start(self) -> str:
        """Do nothing: pages come by themselves."""
        return ""

    async def stop(self) -> None:
        """Forget all pages."""
        for page in self._pages.values():
            page.writing.cancel()
        self._pages.clear()

    def url(self, key: str) -> str:
        """Return how a document's page calls itself."""
        return identifier_of(key)

    def admit(self, origin: str) -> None:
        """Do nothing: who may send messages is decided where they come from."""

    def take(self, identifier: str, data: object) -> None:
        """Do what a page asks for; one that says hello is sent everything."""
        document = self.document(identifier)
        request = request_of(data)
        if document is None or request is None:
            return
        if isinstance(request, Hello):
            self._join(identifier, document)
        if identifier in self._pages:
            self.receive(document, self._pages[identifier].tab, request)

    def _join(self, identifier: str, document: DocumentPreview) -> None:
        """Make a page the one that shows a document, instead of what it was before a reload."""

        async def write(change: Change) -> None:
            self._post(identifier, as_json(change))

        former = self._pages.get(identifier)
        if former is not None:
            document.channel.leave(former.tab)
            former.writing.cancel()
        tab = Tab(write)
        self._pages[identifier] = _Page(tab, asyncio.ensure_future(tab.run()))
        document.channel.join(tab)


async def _at_once(work: Callable[..., T], *arguments: Any) -> T:
    """Return a function's result; there is no other thread to ask."""
    return work(*arguments)
