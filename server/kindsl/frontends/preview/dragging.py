"""Drags in one document's pages: tried out while they go on, written when they end.

A page sends names and numbers, never text. While something moves, the text as it would be is drawn
and checked as if it were typed, but the document stays as it is.
"""

import asyncio
import sys
from collections.abc import Awaitable, Callable
from contextlib import suppress
from dataclasses import replace

from kindsl.frontends.features.manipulation.gesture import Refusal
from kindsl.frontends.features.manipulation.handles import handles
from kindsl.frontends.features.manipulation.mirror_leg import can_mirror
from kindsl.frontends.features.manipulation.things import Thing, carrying_frame
from kindsl.frontends.preview.document_preview import DocumentPreview
from kindsl.frontends.preview.outcomes import Outcome, drag_outcome, plan_outcome
from kindsl.frontends.preview.requests import Drag, GestureRequest, Grasp, Plan
from kindsl.frontends.preview.steps import Steps, Writing
from kindsl.robots.scene.messages import DraggedMessage, EditingMessage, HandlesMessage, PlanMessage

PATIENCE = 2.0  # seconds, for what was written to be shown
_OUTDATED = Refusal("the document has changed in the meantime")
_FOREIGN = Refusal("only a .kindsl document is edited here: 'kindsl convert' makes one")

# Returns why nothing was written, or an empty text.
Write = Callable[[Writing], Awaitable[str]]


class Dragging:
    """The handles of one document."""

    def __init__(self, preview: DocumentPreview, write: Write) -> None:
        """Take what is shown, and who writes."""
        self._preview = preview
        self._write = write
        self._held: Thing | None = None
        self._steps = Steps()
        self._is_new = asyncio.Event()
        preview.on_change.append(self._follow)
        self._show_handles()

    async def receive(self, request: GestureRequest) -> None:
        """Do what a page asks for; it always gets an answer."""
        if isinstance(request, Grasp):
            self._held = Thing(request.kind, request.name) if request.name else None
            self._show_handles()
            return
        try:
            outcome = self._outcome(request)
            if isinstance(outcome, Refusal):
                self._refuse(request, outcome.reason)
            else:
                await self._carry_out(request, outcome)
        except Exception as error:
            print(f"internal error in the preview: {error!r}", file=sys.stderr)
            self._refuse(request, "internal error")

    def _outcome(self, request: Drag | Plan) -> Outcome | Refusal:
        analysis = self._preview.analysis
        if analysis is None or request.revision != self._preview.revision:
            return _OUTDATED
        if analysis.syntax.is_xml:
            return _FOREIGN
        if isinstance(request, Drag):
            return drag_outcome(analysis, request, self._preview.typed)
        return plan_outcome(analysis, request, self._steps)

    async def _carry_out(self, request: Drag | Plan, outcome: Outcome) -> None:
        """Show or write an outcome, and answer when that is done."""
        answer, writing = outcome.answer, outcome.writing
        self._preview.set_parameters(outcome.parameters)
        if isinstance(request, Plan):
            self._preview.show_plan(outcome.document)
        elif outcome.document is not None:
            self._preview.try_out(outcome.document, outcome.findings)
        reason = await self._write_and_wait(writing) if writing is not None else ""
        if reason and isinstance(answer, DraggedMessage):
            self._preview.put_back()
            answer = replace(answer, reason=reason, written=False, warning="")
        elif reason and answer is not None:
            answer = replace(answer, reason=reason)
        elif writing is not None and writing.edits:
            self._steps.keep(request.gesture if isinstance(request, Plan) else "", writing)
        if answer is not None:
            self._preview.channel.announce(answer)

    async def _write_and_wait(self, writing: Writing) -> str:
        """Write, and wait for the next version, so that pages know what they edit next."""
        revision = self._preview.revision
        reason = await self._write(writing)
        if reason or not writing.edits:
            return reason
        with suppress(TimeoutError):
            async with asyncio.timeout(PATIENCE):
                while self._preview.revision == revision:
                    self._is_new.clear()
                    await self._is_new.wait()
        return ""

    def _follow(self) -> None:
        self._is_new.set()
        self._show_handles()

    def _refuse(self, request: Drag | Plan, reason: str) -> None:
        """Leave all as it was, and say why; a handle that is let go goes back without a reason."""
        if isinstance(request, Plan):
            self._preview.channel.announce(PlanMessage(request.gesture, "", reason))
            return
        self._preview.put_back()
        phase, component = request.phase, request.component
        answer = DraggedMessage(phase, component, "", request.value, reason, False)
        self._preview.channel.announce(answer)

    def _show_handles(self) -> None:
        channel, revision = self._preview.channel, self._preview.revision
        analysis, held = self._preview.analysis, self._held
        is_foreign = analysis is not None and analysis.syntax.is_xml
        channel.replace("editing", () if is_foreign else (EditingMessage(revision),))
        if analysis is None or held is None or is_foreign:
            channel.replace("handles", ())
            return
        message = HandlesMessage(
            kind=held.kind,
            name=held.name,
            revision=revision,
            frame=carrying_frame(analysis.model, held),
            components=tuple(handles(analysis, held, self._preview.typed)),
            can_mirror=held.kind == "com" and can_mirror(analysis.model, held.name),
        )
        channel.replace("handles", (message,))
