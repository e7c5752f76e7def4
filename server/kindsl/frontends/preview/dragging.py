"""Drags in one document's pages: tried out while they go on, written when they end.

A page sends names and numbers, never text. While something moves, the text as it would be is drawn
and checked as if it were typed, but the document stays as it is.
"""

import asyncio
import sys
from collections.abc import Awaitable, Callable
from contextlib import suppress

from kindsl.frontends.features.manipulation.gesture import Refusal
from kindsl.frontends.features.manipulation.handles import handles
from kindsl.frontends.features.manipulation.mirror_leg import can_mirror
from kindsl.frontends.features.manipulation.things import Thing, carrying_frame
from kindsl.frontends.preview.document_preview import DocumentPreview
from kindsl.frontends.preview.outcomes import RequestOutcome, Writing, drag_outcome, plan_outcome
from kindsl.frontends.preview.requests import Drag, GestureRequest, Grasp, Plan
from kindsl.frontends.preview.steps import Steps
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.text.edits import difference
from kindsl.robots.scene.messages import (
    DraggedMessage,
    EditingMessage,
    HandlesMessage,
    PlanMessage,
    WrittenMessage,
)
from kindsl.robots.scene.state import keyed

PATIENCE = 2.0  # seconds, for what was written to be shown
_OUTDATED = "the document has changed in the meantime"

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
        preview.on_put.append(self._follow)
        self._tell_handles()

    async def receive(self, request: GestureRequest) -> None:
        """Do what a page asks for; it always gets an answer."""
        try:
            await self._do(request)
        except Exception as error:
            print(f"internal error in the preview: {error!r}", file=sys.stderr)
            self._refuse(request, "internal error")

    async def _do(self, request: GestureRequest) -> None:
        """Decide first what a request does, then show or write it."""
        analysis = self._preview.analysis
        if isinstance(request, Grasp):
            self._held = Thing(request.kind, request.name) if request.name else None
            self._tell_handles()
        elif analysis is None or request.revision != self._preview.revision:
            self._refuse(request, _OUTDATED)
        elif isinstance(request, Drag):
            await self._drag(analysis, request)
        else:
            await self._plan(analysis, request)

    async def _drag(self, analysis: Analysis, request: Drag) -> None:
        """Try a new value out, or write it, or leave all as it was."""
        if request.phase == "cancel":
            self._refuse(request, "")
            return
        outcome = drag_outcome(analysis, request, self._preview.typed)
        if isinstance(outcome, Refusal):
            self._refuse(request, outcome.reason)
            return
        self._preview.set_parameters(outcome.parameters)
        if outcome.document is None:
            await self._drop(request, outcome)
        else:
            self._preview.try_out(outcome.document)
            self._answer(request, outcome.text, outcome.value, "", warning=outcome.warning)

    async def _drop(self, request: Drag, outcome: RequestOutcome) -> None:
        writing, reason = outcome.writing, ""
        if writing.edits or writing.bindings:
            reason = await self._written(writing)
        if reason:
            self._preview.put_back()
        is_written = bool(writing.edits) and not reason
        warning = "" if reason else outcome.warning
        told = (request, outcome.text, outcome.value, reason)
        self._answer(*told, is_written=is_written, warning=warning)
        self._tell_handles()

    async def _plan(self, analysis: Analysis, request: Plan) -> None:
        """Show a gesture as a ghost, or write it when it is accepted."""
        if request.gesture == "discard":
            self._preview.show_plan(None)
            return
        if request.gesture in ("undo", "redo"):
            await self._step(analysis.text, request)
            return
        outcome = plan_outcome(analysis, request)
        if isinstance(outcome, Refusal):
            self._refuse(request, outcome.reason)
            return
        title = outcome.writing.label
        # A pose that becomes zero moves nothing: a ghost would be turned by its joints once more.
        is_still = request.gesture == "pose-as-zero"
        self._preview.show_plan(None if is_still else outcome.document)
        if outcome.document is None:
            reason = await self._written(outcome.writing)
            self._preview.channel.announce(WrittenMessage(request.gesture, title, reason))
        else:
            self._preview.channel.announce(PlanMessage(request.gesture, title, ""))

    async def _step(self, text: str, request: Plan) -> None:
        """Take back what was written last, or make it again."""
        steps, is_undo = self._steps, request.gesture == "undo"
        step = steps.to_undo(text) if is_undo else steps.to_redo(text)
        if isinstance(step, str):
            self._refuse(request, step)
            return
        label = f"Undo: {step.label}" if is_undo else step.label
        reason = await self._write_and_wait(Writing(label, text, (difference(step.old, step.new),)))
        if not reason:
            (steps.undone if is_undo else steps.redone)()
        self._preview.channel.announce(WrittenMessage(request.gesture, label, reason))

    async def _written(self, writing: Writing) -> str:
        """Have something written and shown; return why it was not, or an empty text."""
        reason = await self._write_and_wait(writing)
        if not reason and writing.edits:
            self._steps.add(writing.label, writing.text, writing.edits)
        return reason

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
        self._tell_handles()

    def _refuse(self, request: GestureRequest, reason: str) -> None:
        """Leave all as it was, and say why; a handle that is let go goes back without a reason."""
        if isinstance(request, Plan):
            self._preview.channel.announce(PlanMessage(request.gesture, "", reason))
        elif isinstance(request, Drag):
            self._preview.put_back()
            self._answer(request, "", request.value, reason)
            self._tell_handles()

    def _answer(
        self,
        request: Drag,
        text: str,
        value: float,
        reason: str,
        *,
        is_written: bool = False,
        warning: str = "",
    ) -> None:
        message = DraggedMessage(
            request.phase, request.component, text, value, reason, is_written, warning
        )
        self._preview.channel.announce(message)

    def _tell_handles(self) -> None:
        analysis, held = self._preview.analysis, self._held
        editing = EditingMessage(self._preview.revision)
        self._preview.channel.replace("editing", keyed([editing]))
        if analysis is None or held is None:
            self._preview.channel.replace("handles", {})
            return
        found = handles(analysis, held, self._preview.typed)
        message = HandlesMessage(
            kind=held.kind,
            name=held.name,
            revision=self._preview.revision,
            frame=carrying_frame(analysis.model, held),
            components=tuple(found),
            can_mirror=held.kind == "com" and can_mirror(analysis.model, held.name),
        )
        self._preview.channel.replace("handles", keyed([message]))
