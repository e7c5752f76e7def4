"""Runs the server where Python is a guest: no pipes, no threads, messages as JSON texts in and out.

The host is a browser's worker, or the editor's own Node on a machine without Python.

Besides the protocol's own messages, those of the previews' pages pass here. `kindsl.preview`
answers with a document's identifier, which a page calls itself by, with a name of its own after a
slash if it is not the only one. `kindsl/previewRequest` carries `{"document", "request"}` from the
page, null for goodbye, `kindsl/previewMessages` carries `{"document", "messages"}` to it.
"""

import asyncio
import json
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from kindsl.frontends.lsp.server import KindslLanguageServer
from kindsl.frontends.lsp.session.surroundings import Surroundings
from kindsl.frontends.lsp.session.worker import InlineWorker
from kindsl.frontends.lsp.wire.protocol import Encoded

if TYPE_CHECKING:
    from kindsl.frontends.preview.documents import OnEdit, OnReveal
    from kindsl.frontends.preview.posted import PostedPreviews

PREVIEW_REQUEST = "kindsl/previewRequest"
PREVIEW_MESSAGES = "kindsl/previewMessages"

PostText = Callable[[str], object]


def start(post: PostText, *, has_files: bool = False) -> Callable[[str], bool]:
    """Return what takes the client's messages; call it in the event loop that is to serve.

    Args:
        post: Sends a message to the client.
        has_files: Whether the host shows files that change unseen.
    """
    pages: list[PostedPreviews] = []

    def new_previews(on_reveal: "OnReveal", on_edit: "OnEdit") -> "PostedPreviews":
        from kindsl.frontends.preview.posted import PostedPreviews

        pages.append(PostedPreviews(post_to_page, on_reveal, on_edit))
        return pages[-1]

    def post_to_page(document: str, change: str) -> None:
        params = f'{{"document":{json.dumps(document)},"messages":[{change}]}}'
        server.protocol.notify_encoded(PREVIEW_MESSAGES, Encoded(params))

    server = KindslLanguageServer(Surroundings(InlineWorker(), new_previews, has_files=has_files))
    # It needs NumPy, which no guest brings along.
    del server.protocol.fm.commands["kindsl.compute"]
    server.session.loop = asyncio.get_event_loop()
    server.protocol.set_writer(_PostingWriter(post))

    @server.feature(PREVIEW_REQUEST)
    def take(params: Any) -> None:
        if pages and isinstance(params, dict):
            pages[-1].take(str(params.get("document")), params.get("request"))

    return lambda text: server.protocol.receive(text.encode())


class _PostingWriter:
    """Sends the body of each framed message."""

    def __init__(self, post: PostText) -> None:
        self._post = post

    def write(self, data: bytes) -> None:
        """Send a message."""
        self._post(data.partition(b"\r\n\r\n")[2].decode("ascii"))

    def close(self) -> None:
        """Do nothing: the worker ends with its page."""
