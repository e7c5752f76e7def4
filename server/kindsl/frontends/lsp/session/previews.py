"""The live preview of documents, in the server's own event loop.

A version is drawn as soon as its model is there and no question waits for an answer; what is wrong
with it is listed when that is known. Of versions that come while one is drawn only the newest is
drawn, and drawing takes at most half the time.
"""

import asyncio
import time
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from lsprotocol import types

from kindsl.frontends.lsp.session.binding import bound, pose_edit, request_edits
from kindsl.frontends.lsp.session.state import State
from kindsl.frontends.lsp.session.view import View
from kindsl.frontends.lsp.session.worker import Urgency, start_task
from kindsl.frontends.lsp.text import uris
from kindsl.frontends.lsp.text.document import Document
from kindsl.frontends.lsp.wire.client import asked
from kindsl.frontends.lsp.wire.edits import text_edits, workspace_edit
from kindsl.frontends.lsp.wire.protocol import RequestFailed
from kindsl.judgement.config.parameter_lines import parameter_table, pose_table

if TYPE_CHECKING:
    from kindsl.frontends.preview.document_preview import DocumentPreview
    from kindsl.frontends.preview.documents import DocumentPreviews
    from kindsl.frontends.preview.requests import KeepPose, WriteParameters
    from kindsl.frontends.preview.steps import Writing
    from kindsl.judgement.analysis.diagnostics import Diagnostic
    from kindsl.language.text.span import Span

FRAME = 0.03


class _Version(NamedTuple):
    """A version to show, and what is wrong with it if that is known."""

    document: Document
    findings: "Sequence[Diagnostic] | None" = None


class Previews:
    """Shows documents, keeps them up to date, carries clicks back to the editor."""

    __slots__ = ("_drawing", "_newest", "_preview", "_starting", "_state")

    def __init__(self, state: State) -> None:
        self._state = state
        self._preview: DocumentPreviews | None = None
        self._starting = asyncio.Lock()
        self._newest: dict[str, _Version] = {}
        self._drawing: set[str] = set()
        state.documents.on_open.append(self._follow)
        state.documents.on_change.append(self._follow)
        state.on_findings.append(self._follow)
        state.on_cursor.append(self._highlight)

    async def open(self, uri: str, origin: object = None) -> str:
        """Show a document and return the address of its page.

        The origin is where else than on this machine's loopback the page is seen.

        Raises:
            RequestFailed: There is no such document, no such origin, or something is not installed.
        """
        document = self._state.documents.get(uri)
        if document is None or not document.is_judged:
            raise RequestFailed(f"'{uri}' is not a document that can be shown")
        preview = await self._started()
        if isinstance(origin, str):
            try:
                preview.admit(origin)
            except ValueError as error:
                raise RequestFailed(str(error)) from None
        await self._show(preview, _Version(document))
        start_task(self._judge(uri))
        return preview.url(uris.key(uri))

    def refresh(self) -> None:
        """Show all open documents again, for the settings have changed."""
        for document in self._state.documents:
            self._follow(document)

    def saved(self, uri: str) -> None:
        """Let the version that was saved stand as a ghost behind later ones."""
        if (shown := self._preview_of(uri)) is not None:
            shown.keep_as_ghost()

    def set_parameter(self, uri: str, name: str, value: float) -> None:
        """Let a parameter that nothing binds have a value in the picture."""
        if (shown := self._preview_of(uri)) is not None:
            shown.set_parameters({name: value})

    async def stop(self) -> None:
        """Close all pages."""
        if self._preview is not None:
            await self._preview.stop()

    def _preview_of(self, uri: str) -> "DocumentPreview | None":
        return None if self._preview is None else self._preview.at(uris.key(uri))

    def _follow(self, document: Document, findings: "Sequence[Diagnostic] | None" = None) -> None:
        """Show a version of a document that has a page, unless a newer one comes first."""
        key = uris.key(document.uri)
        if self._preview is None or self._preview.at(key) is None:
            return
        self._newest[key] = _Version(document, findings)
        if key not in self._drawing:
            self._drawing.add(key)
            start_task(self._draw(self._preview, key))

    async def _draw(self, preview: "DocumentPreviews", key: str) -> None:
        try:
            while (version := self._newest.pop(key, None)) is not None:
                start = time.monotonic()
                await self._show(preview, version)
                await asyncio.sleep(max(FRAME, time.monotonic() - start))
        finally:
            self._drawing.discard(key)

    async def _show(self, preview: "DocumentPreviews", version: _Version) -> None:
        from kindsl.judgement.analysis.translated_robot import UnreadableRobotError

        document, findings = version
        try:
            analysis = await (await self._state.analyses.version(document)).shown()
        except UnreadableRobotError as error:
            if (shown := self._preview_of(document.uri)) is None:
                raise RequestFailed(str(error)) from None
            shown.lose(str(error))
            return
        await self._state.until_quiet()
        await preview.show(uris.key(document.uri), analysis, findings, uris.basename(document.uri))

    async def _judge(self, uri: str) -> None:
        """List the findings of a document that is shown for the first time."""
        document = self._state.documents.get(uri)
        if document is not None:
            version = await self._state.analyses.version(document)
            findings = await version.findings(Urgency.DIAGNOSTICS)
            if self._state.documents.get(uri) is document:
                self._follow(document, findings)

    async def _started(self) -> "DocumentPreviews":
        async with self._starting:
            if self._preview is None:
                preview = await self._state.worker.run(self._load)
                try:
                    await preview.start()
                except (ImportError, OSError, RuntimeError) as error:
                    raise RequestFailed(f"the preview cannot start: {error}") from None
                preview.on_write = self.keep
                self._preview = preview
        return self._preview

    def _load(self) -> "DocumentPreviews":
        try:
            return self._state.surroundings.new_previews(self.reveal, self.write)
        except ImportError as error:
            hint = "install with: pip install 'kindsl[preview]'"
            raise RequestFailed(f"the preview needs {error.name}; {hint}") from None

    def reveal(self, key: str, span: "Span", _: Any) -> None:
        """Show in the editor what was clicked in a page."""
        document = self._state.documents.get(key)
        if document is not None and self._state.client.can("window.show_document.support"):
            selection = document.range(*span)
            shown = types.ShowDocumentParams(document.uri, False, True, selection)
            start_task(asked(self._state.editor.window_show_document_async(shown)))

    async def write(self, key: str, writing: "Writing") -> str:
        """Write what was dragged in a page into the document, if it is still the one shown."""
        document = self._state.documents.get(key)
        if document is None or document.text != writing.text:
            return "the document has changed in the meantime"
        view = View(document, await self._state.analyses.of(document), self._state)
        return await request_edits(view, writing.label, writing.edits, writing.bindings)

    def keep(self, key: str, wanted: "WriteParameters | KeepPose") -> str:
        """Let the editor write values or a pose; return what to write by hand if it cannot."""
        from kindsl.frontends.preview.requests import KeepPose

        document, client = self._state.documents.get(key), self._state.client
        if isinstance(wanted, KeepPose):
            lines, label = pose_table(*wanted), f"Keep pose '{wanted.name}'"
            made = pose_edit(self._state, document, *wanted)
        else:
            lines, label = parameter_table(wanted.values), "Give parameters values"
            made = bound(self._state, document, wanted.values.items())
        if made is None or not client.can("workspace.apply_edit"):
            return lines
        edits = [(made.document, text_edits(made.document, [made.edit]))]
        edit = workspace_edit(client, edits, [made.document] if made.is_new else [])
        params = types.ApplyWorkspaceEditParams(edit, label=label)
        start_task(asked(self._state.editor.workspace_apply_edit_async(params)))
        return ""

    def _highlight(self, uri: str, kind: str, name: str) -> None:
        if (shown := self._preview_of(uri)) is not None:
            self._state.loop.call_soon_threadsafe(shown.highlight, kind, name)
