"""The previews of many documents, whoever carries them to their pages."""

import asyncio
import hashlib
from abc import ABC, abstractmethod
from collections.abc import Awaitable, Callable, Coroutine, Sequence
from functools import partial
from typing import Any

from kindsl.frontends.preview.channel import Tab
from kindsl.frontends.preview.document_preview import DocumentPreview, ShownVersion
from kindsl.frontends.preview.dragging import Dragging
from kindsl.frontends.preview.requests import (
    Compare,
    Drag,
    GestureRequest,
    Hello,
    KeepPose,
    Request,
    Reveal,
    SetJoints,
    SetParameters,
    ShowMeshes,
    WriteParameters,
)
from kindsl.frontends.preview.reveal import place_of
from kindsl.frontends.preview.steps import Writing
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.language.text.span import Span
from kindsl.robots.scene.messages import LinesMessage

# Longer robots are drawn beside the loop, to keep it free for the editor.
FEW_LINKS = 60
BREATH = 0.005  # seconds between two moves of a handle in which others are heard

OnReveal = Callable[[str, Span, Reveal], None]
# Returns what to tell the page: lines to be written by hand, empty if they are written for it.
OnWrite = Callable[[str, WriteParameters | KeepPose], str]
# Returns why nothing was written, or an empty text.
OnEdit = Callable[[str, Writing], Awaitable[str]]
Beside = Callable[..., Awaitable[Any]]


class DocumentPreviews(ABC):
    """Shows any number of documents, each on any number of pages.

    Documents are known by keys of the caller's choice: URIs, paths. All methods are to be called
    in the loop that `start` was awaited in, and none of them waits for a page.

    Attributes:
        on_write: Called with a document's key and what is to be kept in its configuration.
    """

    def __init__(
        self, on_reveal: OnReveal | None, on_edit: OnEdit | None = None, *, beside: Beside
    ) -> None:
        """Prepare to show documents.

        Args:
            on_reveal: Called with the document's key, the place in its text (code points) and
                what was clicked.
            on_edit: Awaited with the document's key and what was dragged; else nothing can.
            beside: Awaits a function's result and lets the loop go on meanwhile, if it can.
        """
        self._on_reveal = on_reveal
        self.on_write: OnWrite | None = None
        self._on_edit = on_edit
        self._beside = beside
        self._documents: dict[str, DocumentPreview] = {}
        self._keys: dict[str, str] = {}
        self._dragging: dict[str, Dragging] = {}
        self._moves: dict[Dragging, GestureRequest] = {}
        self._comparing: dict[DocumentPreview, bool] = {}
        self._tasks: set[asyncio.Task[None]] = set()

    @abstractmethod
    async def start(self) -> str:
        """Be ready for pages; return the address of the first document's page."""

    @abstractmethod
    async def stop(self) -> None:
        """Leave all pages."""

    @abstractmethod
    def url(self, key: str) -> str:
        """Return the address of a document's page."""

    @abstractmethod
    def admit(self, origin: str) -> None:
        """Let pages of one more origin in."""

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
            findings: The list; None while it is not known, then the old one stays.
            label: Name of the document; the first time counts.
        """
        document = self._documents.get(key) or self._new(key, label or key)
        document.newest = analysis
        async with document.turn:
            if document.newest is not analysis:
                return
            if document.analysis is not analysis:
                document.put(analysis, await self._drawing(document, analysis))
            if findings is not None:
                document.list_findings(findings)

    def at(self, key: str) -> DocumentPreview | None:
        """Return what is shown of a document, if it has a preview."""
        return self._documents.get(key)

    def close(self, key: str) -> None:
        """Forget a document."""
        self._documents.pop(key, None)
        self._dragging.pop(key, None)
        self._keys.pop(identifier(key), None)

    def document(self, identifier: str | None) -> DocumentPreview | None:
        """Return the document of a page's address, the first for None."""
        first = next(iter(self._documents), None)
        key = first if identifier is None else self._keys.get(identifier)
        return None if key is None else self._documents[key]

    def receive(self, document: DocumentPreview, tab: Tab, request: Request) -> None:
        """Do what a page asks for."""
        if isinstance(request, SetJoints):
            for name, value in request.values.items():
                document.set_joint(name, value, tab)
        elif isinstance(request, SetParameters):
            document.set_parameters(request.values)
        elif isinstance(request, WriteParameters | KeepPose):
            self._write(document, tab, request)
        elif isinstance(request, Compare):
            document.choose_other(request.name)
        elif isinstance(request, ShowMeshes):
            document.show_meshes()
        elif isinstance(request, Hello):
            document.adopt(request.joints, request.parameters)
        elif isinstance(request, Reveal):
            self._reveal(document, request)
        else:
            self._gesture(document, request)

    def _gesture(self, document: DocumentPreview, request: GestureRequest) -> None:
        dragging = self._dragging.get(document.key)
        if dragging is None:
            return
        is_waiting = self._moves.pop(dragging, None) is not None
        if not isinstance(request, Drag) or request.phase != "move":
            self._start(dragging.receive(request))
            return
        self._moves[dragging] = request
        if not is_waiting:
            self._start(self._move(dragging))

    async def _move(self, dragging: Dragging) -> None:
        """Draw the last move of those that come at once, whatever a page sends."""
        await asyncio.sleep(BREATH)
        request = self._moves.pop(dragging, None)
        if request is not None:
            await dragging.receive(request)

    def _compare(self, document: DocumentPreview) -> None:
        """Compare a document beside the loop; once more if it changes meanwhile."""
        is_running = document in self._comparing
        self._comparing[document] = is_running
        if not is_running:
            self._start(self._compare_until_done(document))

    async def _compare_until_done(self, document: DocumentPreview) -> None:
        is_changed = True
        try:
            while is_changed:
                self._comparing[document] = False
                document.show_beside(await self._beside(document.beside))
                is_changed = self._comparing[document]
        finally:
            del self._comparing[document]

    def _start(self, work: Coroutine[Any, Any, None]) -> None:
        task = asyncio.ensure_future(work)
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)

    def _write(
        self, document: DocumentPreview, tab: Tab, request: WriteParameters | KeepPose
    ) -> None:
        """Have values kept that the document knows; send the lines that are left to the user."""
        analysis = document.analysis
        if self.on_write is None or analysis is None:
            return
        if isinstance(request, KeepPose):
            known = {str(joint.name) for joint in analysis.model.joints}
        else:
            names = {str(parameter.name) for parameter in analysis.model.parameters}
            known = names - analysis.settings.bindings.keys()
        values = {name: value for name, value in request.values.items() if name in known}
        if values or isinstance(request, KeepPose):
            lines = self.on_write(document.key, request._replace(values=values))
            if lines:
                tab.send(LinesMessage(lines))

    def _reveal(self, document: DocumentPreview, chosen: Reveal) -> None:
        if document.analysis is not None and self._on_reveal is not None:
            span = place_of(chosen, document.analysis, document.findings)
            if span is not None:
                self._on_reveal(document.key, span, chosen)

    def _new(self, key: str, label: str) -> DocumentPreview:
        document = self._documents[key] = DocumentPreview(label, key)
        document.recompare = partial(self._compare, document)
        self._keys[identifier(key)] = key
        if self._on_edit is not None:
            self._dragging[key] = Dragging(document, partial(self._on_edit, key))
        return document

    async def _drawing(self, document: DocumentPreview, analysis: Analysis) -> ShownVersion:
        """Return what there is to show of a version."""
        if len(analysis.model.links) <= FEW_LINKS:
            return document.drawing(analysis)
        drawing: ShownVersion = await self._beside(document.drawing, analysis)
        return drawing


def identifier(key: str) -> str:
    """Return a short name for a document's page address that does not reveal its path."""
    return hashlib.sha256(key.encode(errors="surrogatepass")).hexdigest()[:12]
