"""HTTP and websocket requests: each is checked first, then answered from memory."""

import asyncio
import sys
from collections.abc import Callable
from contextlib import suppress
from time import monotonic
from typing import Any, NamedTuple

from tornado.web import Application, HTTPError, RequestHandler
from tornado.websocket import WebSocketClosedError, WebSocketHandler

from kindsl.frontends.preview.access import Access
from kindsl.frontends.preview.assets import assets, live_page
from kindsl.frontends.preview.channel import Tab
from kindsl.frontends.preview.documents import DocumentPreviews
from kindsl.frontends.preview.requests import MOST_BYTES, BadRequestError, parse_request
from kindsl.robots.scene.encoding import encode
from kindsl.robots.scene.messages import Change, RefusedMessage

# A drag sends some 60 messages a second; a restarted server is told all values of a page at once.
BURST = 600.0
PER_SECOND = 200.0
_CHARACTERS = 1000  # of a message that cost as much as the message itself
TOO_MUCH = 1008
# The viewer and its control library set styles from scripts; nothing may evaluate text as code.
# An editor shows the page in a frame: VS Code's own pages, or a local server's.
POLICY = "; ".join((
    "default-src 'none'", "script-src 'self'", "style-src 'self' 'unsafe-inline'",
    "img-src 'self' data: blob:", "connect-src 'self' {sockets}", "base-uri 'none'",
    "form-action 'none'",
    "frame-ancestors vscode-webview: vscode-file: https://*.vscode-cdn.net "
    "http://127.0.0.1:* http://localhost:* {outside}",
))  # fmt: skip


class Serving(NamedTuple):
    """What requests are answered from.

    Attributes:
        previews: The documents.
        access: Returns the access that is granted now.
        lines: The open tabs.
    """

    previews: DocumentPreviews
    access: Callable[[], Access]
    lines: "set[LiveHandler]"


def application(serving: Serving) -> Application:
    """Return what answers requests; there is nothing but the page, its parts and the socket."""
    routes: list[tuple[str, type[CheckedHandler]]] = [
        *((r"/", PageHandler), (r"/live", LiveHandler)),
        *((r"/mesh/([\w.-]+)", MeshHandler), (r"/(.*)", AssetHandler)),
    ]
    return Application(
        [(pattern, handler, {"serving": serving}) for pattern, handler in routes],
        websocket_max_message_size=MOST_BYTES,
        log_function=lambda _: None,  # An address has the token in it.
    )


class CheckedHandler(RequestHandler):
    """Refuses what is not ours before anything else."""

    def initialize(self, serving: Serving) -> None:
        """Take what all handlers share."""
        self.serving = serving

    def prepare(self) -> None:
        """Check the request."""
        headers = self.request.headers
        token = self.get_query_argument("token", None)
        reason = self.serving.access().refusal(headers.get("Host"), headers.get("Origin"), token)
        if reason is not None:
            raise HTTPError(403, reason)

    def log_exception(self, kind: Any, error: Any, trace: Any) -> None:  # noqa: ARG002
        """Say no more than what failed: tornado's own line has the address, token and all, in it.

        A request that is refused is none of the user's business: any page can send one.
        """
        if not isinstance(error, HTTPError):
            print(f"internal error in the preview: {error!r}", file=sys.stderr)

    def set_default_headers(self) -> None:
        """Keep the answer, and the token in its address, to ourselves."""
        self.set_header("Cache-Control", "no-store")
        self.set_header("Referrer-Policy", "no-referrer")
        self.set_header("X-Content-Type-Options", "nosniff")
        self.clear_header("Server")

    def write_error(self, status_code: int, **details: Any) -> None:
        """Answer with one line of plain text."""
        error = details.get("exc_info", (None, None))[1]
        reason = error.log_message if isinstance(error, HTTPError) else None
        self.set_header("Content-Type", "text/plain; charset=utf-8")
        self.finish(f"{status_code}: {reason or 'not here'}\n")


class PageHandler(CheckedHandler):
    """The page itself."""

    def get(self) -> None:
        """Answer with the page."""
        access = self.serving.access()
        policy = POLICY.format(
            sockets=" ".join(access.sockets()), outside=" ".join(sorted(access.outside))
        )
        self.set_header("Content-Security-Policy", policy.rstrip())
        self.set_header("Content-Type", "text/html; charset=utf-8")
        self.finish(live_page(access.token))


class AssetHandler(CheckedHandler):
    """The page's scripts and style, by name."""

    def get(self, name: str) -> None:
        """Answer with a part of the page."""
        asset = assets().get(name)
        if asset is None:
            raise HTTPError(404)
        self.set_header("Content-Type", f"{asset.media_type}; charset=utf-8")
        self.finish(asset.content)


class MeshHandler(CheckedHandler):
    """The meshes that a document is drawn with, by their names in its messages."""

    async def get(self, name: str) -> None:
        """Answer with a file of the folder that the user named."""
        document = self.serving.previews.document(self.get_query_argument("document", None))
        file = None if document is None else document.mesh_files.get(name)
        content = None if file is None else await asyncio.to_thread(file.read)
        if content is None:
            raise HTTPError(404)
        self.set_header("Content-Type", "application/octet-stream")
        self.finish(content)


class Budget:
    """Messages that a page may still send: they come back with time."""

    def __init__(self, clock: Callable[[], float] = monotonic) -> None:
        """Begin with a full budget; `clock` returns seconds."""
        self._clock = clock
        self._left = BURST
        self._last = clock()

    def spend(self, message: str | bytes) -> bool:
        """Take the price of a message; return whether there was enough left."""
        now = self._clock()
        self._left = min(BURST, self._left + PER_SECOND * (now - self._last))
        self._last = now
        self._left -= 1.0 + len(message) / _CHARACTERS
        return self._left >= 0.0


class LiveHandler(CheckedHandler, WebSocketHandler):
    """The line to one tab."""

    def check_origin(self, origin: str) -> bool:  # noqa: ARG002
        """Leave it to `prepare`, which has checked it."""
        return True

    def open(self, *_: str) -> None:
        """Send the state, and keep sending what changes."""
        document = self.serving.previews.document(self.get_query_argument("document", None))
        if document is None:
            self.close(4404, "no such document")
            return
        # Small frames go at once, not after the acknowledgement of the one before.
        self.set_nodelay(True)
        self.document = document
        self.tab = Tab(self._write)
        self.budget = Budget()
        document.channel.join(self.tab)
        self.writer = asyncio.ensure_future(self.tab.run())
        self.serving.lines.add(self)

    def on_message(self, message: str | bytes) -> None:
        """Do what the page asks for, or answer why it is no request.

        A page that asks for more than it may loses its line; ours comes back with its values.
        """
        if not self.budget.spend(message):
            self.close(TOO_MUCH, "too many messages")
            return
        try:
            request = parse_request(message)
        except BadRequestError as error:
            self.tab.send(RefusedMessage(str(error)))
        else:
            self.serving.previews.receive(self.document, self.tab, request)

    def on_close(self) -> None:
        """Forget the tab."""
        if hasattr(self, "writer"):
            self.document.channel.leave(self.tab)
            self.writer.cancel()
            self.serving.lines.discard(self)

    async def _write(self, change: Change) -> None:
        """Write a change; a line that is closing loses it, and `on_close` follows."""
        with suppress(WebSocketClosedError):
            await self.write_message(encode(change), binary=True)
