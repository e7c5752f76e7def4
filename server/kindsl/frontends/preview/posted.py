"""Previews whose pages are in the same browser: messages as JSON instead of a server."""

import asyncio
from collections.abc import Callable
from typing import Any, NamedTuple, TypeVar

from kindsl.frontends.preview.channel import Tab
from kindsl.frontends.preview.document_preview import DocumentPreview
from kindsl.frontends.preview.documents import DocumentPreviews, OnEdit, OnReveal
from kindsl.frontends.preview.documents import identifier as identifier_of
from kindsl.frontends.preview.requests import BadRequestError, Hello, request_of
from kindsl.robots.scene.encoding import as_json
from kindsl.robots.scene.messages import Change, RefusedMessage

T = TypeVar("T")

Post = Callable[[str, str], None]


class _Page(NamedTuple):
    """A connected page and the task that writes to it."""

    tab: Tab
    writing: "asyncio.Task[None]"


class PostedPreviews(DocumentPreviews):
    """Shows documents by messages.

    A page calls itself by the identifier of its document, and if there may be others of the same
    document by a name of its own after a slash.
    """

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

    def take(self, name: str, data: object) -> None:
        """Do what a page asks for; one that says hello is sent everything, None is goodbye."""
        document = self.document(name.partition("/")[0])
        if document is None:
            return
        if data is None:
            self._leave(name, document)
            return
        try:
            request = request_of(data)
        except BadRequestError as error:
            if name in self._pages:
                self._pages[name].tab.send(RefusedMessage(str(error)))
            return
        if isinstance(request, Hello):
            self._leave(name, document)
            self._join(name, document)
        if name in self._pages:
            self.receive(document, self._pages[name].tab, request)

    def _leave(self, name: str, document: DocumentPreview) -> None:
        """Forget a page, including its state before a reload."""
        if name in self._pages:
            former = self._pages.pop(name)
            document.channel.leave(former.tab)
            former.writing.cancel()

    def _join(self, name: str, document: DocumentPreview) -> None:
        async def write(change: Change) -> None:
            self._post(name, as_json(change))

        tab = Tab(write)
        self._pages[name] = _Page(tab, asyncio.ensure_future(tab.run()))
        document.channel.join(tab)


async def _at_once(work: Callable[..., T], *arguments: Any) -> T:
    """Return a function's result; there is no other thread to ask."""
    return work(*arguments)
