"""The live viewer's server: loopback only, in the caller's asyncio loop, without threads."""

import asyncio
import hashlib
import os
import socket
from collections.abc import Callable, Sequence
from contextlib import suppress

from tornado.httpserver import HTTPServer

from kindsl.analysis.analysis import Analysis
from kindsl.analysis.diagnostics import Diagnostic
from kindsl.preview.access import ADDRESS, Access, new_token
from kindsl.preview.assets import assets
from kindsl.preview.channel import Tab
from kindsl.preview.document_preview import DocumentPreview, Drawing
from kindsl.preview.handlers import LiveHandler, application
from kindsl.preview.requests import Hello, Request, Reveal, SetJoint, SetParameter
from kindsl.preview.reveal import place_of
from kindsl.preview.scene.geometry import PreviewUnavailableError
from kindsl.preview.session import Session, last_session, remember
from kindsl.text.span import Span

GOING_AWAY = 1001
# Longer robots are drawn in a thread, to keep the loop free for the editor.
FEW_LINKS = 60
PATIENCE = 1.0  # seconds, for tabs to say goodbye

OnReveal = Callable[[str, Span, Reveal], None]


class PreviewServer:
    """Serves the previews of any number of documents, each to any number of tabs.

    Documents are known by keys of the caller's choice: URIs, paths. All methods are to be called
    in the loop that `start` was awaited in, and none of them waits for a tab.
    """

    def __init__(
        self,
        on_reveal: OnReveal | None = None,
        *,
        port: int = 0,
        token: str | None = None,
        session: str | None = None,
    ) -> None:
        """Prepare a server.

        Args:
            on_reveal: Called with the document's key, the place in its text (code points) and
                what was clicked.
            port: To listen on; 0 for a free one.
            token: To ask for; None for a new one.
            session: A name (of a document, a workspace). A server of the same name listens where
                the last one did, if it can, so that pages which are still open find it.
        """
        self._session = session
        self._on_reveal = on_reveal or _reveal_nowhere
        self._access = Access(token or new_token(), port)
        self._documents: dict[str, DocumentPreview] = {}
        self._keys: dict[str, str] = {}
        self._lines: set[LiveHandler] = set()
        self._http: HTTPServer | None = None

    @property
    def access(self) -> Access:
        """Who may talk to it."""
        return self._access

    def admit(self, origin: str) -> None:
        """Answer pages of an outside origin too: a tunnel or proxy that the editor told of.

        Raises:
            ValueError: It is no origin.
        """
        self._access = self._access.admitting(origin)

    @property
    def token(self) -> str:
        """What each request must show."""
        return self._access.token

    @property
    def port(self) -> int:
        """Where it listens, once started."""
        return self._access.port

    @property
    def is_running(self) -> bool:
        """Whether it was started and not stopped."""
        return self._http is not None

    async def start(self) -> str:
        """Begin to listen and return the address of the first document's page.

        Raises:
            PreviewUnavailableError: meshcat is not installed, or the port is taken.
        """
        assets()
        last = last_session(self._session) if self._session else None
        if last is not None and self._access.port in (0, last.port):
            with suppress(PreviewUnavailableError):
                return self._listen(Access(last.token, last.port))
        address = self._listen(self._access)
        if self._session:
            remember(self._session, Session(self.port, self.token))
        return address

    async def stop(self) -> None:
        """Close all connections and the port."""
        if self._http is not None:
            http, self._http = self._http, None
            http.stop()
            for line in list(self._lines):
                line.close(GOING_AWAY)
            with suppress(TimeoutError):
                await asyncio.wait_for(self._all_gone(), PATIENCE)
            await http.close_all_connections()

    def connected(self, line: LiveHandler) -> None:
        """Know a tab's line, to close it in the end."""
        self._lines.add(line)

    def disconnected(self, line: LiveHandler) -> None:
        """Forget a line that is closed."""
        self._lines.discard(line)

    def url(self, key: str) -> str:
        """Return the address of a document's page."""
        return f"{self._address()}&document={_identifier(key)}"

    def shows(self, key: str) -> bool:
        """Return whether a document has a preview."""
        return key in self._documents

    async def show(
        self,
        key: str,
        analysis: Analysis,
        findings: Sequence[Diagnostic] | None = None,
        label: str = "",
    ) -> None:
        """Show a version of a document; one that is overtaken by a newer one is left out.

        Args:
            key: The document's.
            analysis: The version; it is drawn once.
            findings: What to list; None while it is not known, then what was listed stays.
            label: What to call the document; the first time counts.
        """
        document = self._document(key, label)
        document.newest = analysis
        async with document.turn:
            if document.newest is not analysis:
                return
            if document.analysis is not analysis:
                document.put(analysis, await _drawing(document, analysis))
            if findings is not None:
                document.tell(findings)

    def saved(self, key: str) -> None:
        """Let the version that is shown stand as a ghost behind later ones."""
        if key in self._documents:
            self._documents[key].keep_as_ghost()

    def compare(self, key: str, other: Analysis) -> None:
        """Let another document stand as a ghost behind this one.

        Raises:
            ModelError: The other document has no bodies.
        """
        self._document(key, "").compare(other)

    def highlight(self, key: str, kind: str, name: str) -> None:
        """Light up a `"link"`, `"joint"` or `"frame"`; nothing for an empty name."""
        if key in self._documents:
            self._documents[key].highlight(kind, name)

    def close(self, key: str) -> None:
        """Forget a document."""
        self._documents.pop(key, None)
        self._keys.pop(_identifier(key), None)

    def document(self, identifier: str | None) -> DocumentPreview | None:
        """Return the document of a page's address, the first for None."""
        first = next(iter(self._documents), None)
        key = first if identifier is None else self._keys.get(identifier)
        return None if key is None else self._documents[key]

    def receive(self, document: DocumentPreview, tab: Tab, request: Request) -> None:
        """Do what a page asks for."""
        if isinstance(request, SetJoint):
            document.set_joint(request.name, request.value, tab)
        elif isinstance(request, SetParameter):
            document.set_parameter(request.name, request.value)
        elif isinstance(request, Hello):
            document.adopt(request.joints, request.parameters)
        else:
            self._reveal(document, request)

    async def _all_gone(self) -> None:
        while self._lines:
            await asyncio.sleep(0.01)

    def _listen(self, access: Access) -> str:
        listening = _listening_socket(access.port)
        self._access = access._replace(port=listening.getsockname()[1])
        self._http = HTTPServer(application(self))
        self._http.add_sockets([listening])
        return self._address()

    def _reveal(self, document: DocumentPreview, chosen: Reveal) -> None:
        key = next((key for key, known in self._documents.items() if known is document), None)
        if key is None or document.analysis is None:
            return
        span = place_of(chosen, document.analysis, document.findings)
        if span is not None:
            self._on_reveal(key, span, chosen)

    def _document(self, key: str, label: str) -> DocumentPreview:
        if key not in self._documents:
            self._documents[key] = DocumentPreview(label or key)
            self._keys[_identifier(key)] = key
        return self._documents[key]

    def _address(self) -> str:
        return f"http://{ADDRESS}:{self._access.port}/?token={self._access.token}"


async def _drawing(document: DocumentPreview, analysis: Analysis) -> Drawing:
    """Return what there is to show of a version; a long one does not keep the loop waiting."""
    if len(analysis.model.links) <= FEW_LINKS:
        return document.drawing(analysis)
    return await asyncio.to_thread(document.drawing, analysis)


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


def _reveal_nowhere(_key: str, _span: Span, _chosen: Reveal) -> None:
    """Stand in for a callback."""


def _identifier(key: str) -> str:
    """Return a short name of a document for its page's address, which tells nothing of its path."""
    return hashlib.sha256(key.encode(errors="surrogatepass")).hexdigest()[:12]
