"""The live viewer's server: loopback only, in the caller's asyncio loop, without threads."""

import asyncio
import os
import socket
from contextlib import suppress

from tornado.httpserver import HTTPServer

from kindsl.frontends.preview.access import ADDRESS, Access, new_token
from kindsl.frontends.preview.assets import PreviewUnavailableError, assets
from kindsl.frontends.preview.documents import DocumentPreviews, OnEdit, OnReveal, identifier
from kindsl.frontends.preview.handlers import LiveHandler, Serving, application
from kindsl.frontends.preview.session import last_session, remember

GOING_AWAY = 1001
PATIENCE = 1.0  # seconds, for tabs to say goodbye


class PreviewServer(DocumentPreviews):
    """Serves the previews of any number of documents, each to any number of tabs."""

    def __init__(
        self,
        on_reveal: OnReveal | None = None,
        *,
        on_edit: OnEdit | None = None,
        port: int = 0,
        token: str | None = None,
        session: str | None = None,
    ) -> None:
        """Prepare a server.

        Args:
            on_reveal: Called with the document's key, the place in its text (code points) and
                what was clicked.
            on_edit: Awaited with the document's key and what was dragged; else nothing can.
            port: To listen on; 0 for a free one.
            token: To ask for; None for a new one.
            session: A name (of a document, a workspace). A server of the same name listens where
                the last one did, if it can, so that pages which are still open find it.
        """
        super().__init__(on_reveal, on_edit, beside=asyncio.to_thread)
        self._session = session
        self._access = Access(token or new_token(), port)
        self._lines: set[LiveHandler] = set()
        self._http: HTTPServer | None = None

    def admit(self, origin: str) -> None:
        """Also accept pages from an outside origin: a tunnel or proxy announced by the editor.

        Raises:
            ValueError: It is no origin.
        """
        self._access = self._access.admitting(origin)

    @property
    def token(self) -> str:
        """The token that each request must show."""
        return self._access.token

    @property
    def port(self) -> int:
        """The port that it listens at, once started."""
        return self._access.port

    async def start(self) -> str:
        """Begin to listen and return the address of the first document's page.

        Raises:
            PreviewUnavailableError: meshcat is not installed, or the port is taken.
        """
        assets()
        last = last_session(self._session) if self._session else None
        if last is not None and self._access.port in (0, last.port):
            with suppress(PreviewUnavailableError):
                return self._listen(last)
        address = self._listen(self._access)
        if self._session:
            remember(self._session, self._access)
        return address

    async def stop(self) -> None:
        """Close all connections and the port."""
        if self._http is not None:
            http, self._http = self._http, None
            http.stop()
            for line in list(self._lines):
                line.close(GOING_AWAY)
            with suppress(TimeoutError):
                async with asyncio.timeout(PATIENCE):
                    while self._lines:
                        await asyncio.sleep(0.01)
            await http.close_all_connections()

    def url(self, key: str) -> str:
        """Return the address of a document's page."""
        return f"{self._address()}&document={identifier(key)}"

    def _listen(self, access: Access) -> str:
        listening = _listening_socket(access.port)
        self._access = access._replace(port=listening.getsockname()[1])
        self._http = HTTPServer(application(Serving(self, lambda: self._access, self._lines)))
        self._http.add_sockets([listening])
        return self._address()

    def _address(self) -> str:
        return f"http://{ADDRESS}:{self._access.port}/?token={self._access.token}"


def _listening_socket(port: int) -> socket.socket:
    listening = socket.socket(socket.AF_INET, socket.SOCK_STREAM)
    try:
        if os.name == "posix":
            # A port is free again as soon as its last server is gone.
            listening.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        listening.setblocking(False)
        listening.bind((ADDRESS, port))
        listening.listen()
    except OSError as error:
        listening.close()
        problem = f"cannot listen on {ADDRESS}:{port}: {error.strerror}"
        raise PreviewUnavailableError(problem) from error
    return listening
