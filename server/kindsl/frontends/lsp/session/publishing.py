"""Diagnostics pushed to the client while someone types, and the line of its status bar."""

import asyncio
from collections.abc import Sized
from typing import TYPE_CHECKING, Any

from lsprotocol import types

from kindsl.frontends.lsp.session import calm, memory
from kindsl.frontends.lsp.session.analyses import Version
from kindsl.frontends.lsp.session.companions import companion_diagnostics, mentioned
from kindsl.frontends.lsp.session.findings import diagnostics
from kindsl.frontends.lsp.session.state import State
from kindsl.frontends.lsp.session.worker import Urgency, start_task
from kindsl.frontends.lsp.text import uris
from kindsl.frontends.lsp.text.document import Document
from kindsl.frontends.lsp.wire.protocol import Encoded

if TYPE_CHECKING:
    from kindsl.judgement.analysis.analysis import Analysis
    from kindsl.judgement.analysis.diagnostics import Diagnostic

STATUS = "kindsl/status"
_BASE_FREEDOM = 6
_MANY = 200
_LONG = 50_000


class Publisher:
    """Publishes what is wrong with each open document, a moment after the last keystroke.

    Documents that the client pulls diagnostics for are left to it, lest each is shown twice.
    """

    __slots__ = ("_checked", "_names", "_pulled", "_shown", "_state", "_tasks")

    def __init__(self, state: State) -> None:
        self._state = state
        self._tasks: dict[str, asyncio.Task[None]] = {}
        self._pulled: set[str] = set()
        self._checked: set[str] = set()
        self._shown: set[str] = set()
        self._names: dict[str, object] = {}
        state.documents.on_open.append(lambda document: self.schedule(document, 0.0))
        state.documents.on_change.append(self._changed)
        state.documents.on_close.append(self._close)

    def schedule(self, document: Document, delay: float) -> None:
        """Publish for this version after some seconds, unless another one comes before."""
        key = uris.key(document.uri)
        if key in self._tasks:
            self._tasks[key].cancel()
        self._tasks[key] = start_task(self._publish_later(document, delay))

    def leave_to_pull(self, document: Document) -> None:
        """Push no more for a document that the client pulls for."""
        key = uris.key(document.uri)
        if self._state.client.can("text_document.diagnostic") and key not in self._pulled:
            self._pulled.add(key)
            if key in self._shown:
                self.publish(document.uri, [])

    def refresh(self) -> None:
        """Publish for all open documents again, to a client that pulls unless it can be asked."""
        if not self._state.client.is_told_to_pull:
            self._pulled.clear()
        for document in self._state.documents:
            self.schedule(document, 0.0)

    def publish(self, uri: str, diagnostics: list[dict[str, Any]]) -> None:
        """Publish for a file that no editor shows."""
        self._publish(uri, None, diagnostics)

    def _changed(self, document: Document) -> None:
        settings = self._state.workspace.editor_settings(document.uri)
        self.schedule(document, settings.diagnostics_delay)

    def _close(self, document: Document) -> None:
        key = uris.key(document.uri)
        if key in self._tasks:
            self._tasks.pop(key).cancel()
        self._pulled.discard(key)
        self._checked.discard(key)
        self._names.pop(key, None)
        self.publish(document.uri, [])

    async def _publish_later(self, document: Document, delay: float) -> None:
        if delay:
            await asyncio.sleep(delay)
        if not document.is_judged:
            await self._publish_companion(document)
            return
        version = await self._state.analyses.version(document)
        first = await self._first_findings(version)
        if uris.key(document.uri) not in self._checked:
            self._checked.add(uris.key(document.uri))
            memory.set_aside()
        if not self._state.documents.is_current(document):
            return
        told = self._state.calm.shown(document, first)
        await self._tell(version, told)
        findings = await version.findings(Urgency.DIAGNOSTICS)
        if findings != first:
            told = self._state.calm.shown(document, findings)
            await self._tell_again(version, told)
        if len(told) != len(findings):
            await asyncio.sleep(calm.PATIENCE - delay)
            self._state.calm.settle(document, findings)
            await self._tell_again(version, findings)

    async def _first_findings(self, version: Version) -> "tuple[Diagnostic, ...]":
        """Return findings without twins, of a long document after the answers that wait."""
        if version.document.lines.length > _LONG:
            await version.analysis()  # which is enough for most questions
        await self._state.until_quiet()
        return await version.findings_without_twins(Urgency.DIAGNOSTICS)

    async def _tell_again(self, version: Version, findings: "tuple[Diagnostic, ...]") -> None:
        await self._tell(version, findings)
        self._ask_to_pull(version.document)

    async def _tell(self, version: Version, findings: "tuple[Diagnostic, ...]") -> None:
        document = version.document
        shown = await self._encoded(document, findings)
        if self._state.documents.is_current(document):
            if uris.key(document.uri) not in self._pulled:
                self._send(document.uri, shown, bool(findings))
            for listener in self._state.on_findings:
                listener(document, findings)
            if document.is_xml:
                return
            analysis = await version.analysis()
            self._check_companions(document, analysis)
            if self._state.client.announces(STATUS):
                status = await self._state.worker.run(
                    lambda: status_of(analysis, findings), Urgency.DIAGNOSTICS
                )
                self._state.editor.protocol.notify(STATUS, {"uri": document.uri, **status})

    async def _encoded(self, document: Document, findings: "tuple[Diagnostic, ...]") -> Encoded:
        """Return findings as they are sent; many are made ready in the worker."""

        def encoded() -> Encoded:
            shown = diagnostics(document, findings, self._state.client.shows_in_diagnostics)
            params = {"uri": document.uri, "version": document.version, "diagnostics": shown}
            return self._state.editor.protocol.encoded(params)

        if len(findings) < _MANY:
            return encoded()
        return await self._state.worker.run(encoded, Urgency.DIAGNOSTICS)

    async def _publish_companion(self, document: Document) -> None:
        shown = await companion_diagnostics(self._state, document)
        is_pulled = uris.key(document.uri) in self._pulled
        if self._state.documents.is_current(document) and not is_pulled:
            self._publish(document.uri, document.version, shown)

    def _check_companions(self, document: Document, analysis: "Analysis") -> None:
        companions = [other for other in self._state.documents if not other.is_judged]
        if not companions:
            return
        key = uris.key(document.uri)
        names = mentioned(analysis)
        if self._names.get(key) == names:
            return
        self._names[key] = names
        for other in companions:
            if not self._ask_to_pull(other):
                self._pulled.discard(uris.key(other.uri))
                self.schedule(other, 0.0)

    def _ask_to_pull(self, document: Document) -> bool:
        """Ask the client to pull again; return whether it pulls for the document and can be."""
        is_asked = self._state.client.is_told_to_pull and uris.key(document.uri) in self._pulled
        if is_asked:
            self._state.editor.workspace_diagnostic_refresh(None)
        return is_asked

    def _publish(self, uri: str, version: int | None, diagnostics: list[dict[str, Any]]) -> None:
        params: dict[str, Any] = {"uri": uri, "diagnostics": diagnostics}
        if version is not None:
            params["version"] = version
        self._send(uri, self._state.editor.protocol.encoded(params), bool(diagnostics))

    def _send(self, uri: str, params: Encoded, has_findings: bool) -> None:
        (self._shown.add if has_findings else self._shown.discard)(uris.key(uri))
        self._state.editor.protocol.notify_encoded(types.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS, params)


def status_of(analysis: "Analysis", findings: Sized) -> dict[str, object]:
    """Return the number of findings, the degrees of freedom, None without a tree, and a word."""
    from kindsl.robots.mechanism.errors import ModelError
    from kindsl.robots.mechanism.numbering import numbered_by_id

    model = analysis.model
    try:
        edges = numbered_by_id(model)
    except ModelError:
        return {"findings": len(findings), "dof": None, "state": "broken model"}
    dof = len(edges) + (_BASE_FREEDOM if model.floating else 0)
    names = {str(parameter.name) for parameter in model.parameters}
    is_bound = names <= analysis.context.values.keys()
    state = "ready" if is_bound else "unbound parameters"
    return {"findings": len(findings), "dof": dof, "state": state}
