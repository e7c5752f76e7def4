"""What is dragged in one document's pages: tried out while it moves, written when it is dropped.

A page sends names and numbers, never text. While something moves, the text as it would be is drawn
and checked as if it were typed, but the document stays as it is.
"""

import asyncio
import sys
from collections.abc import Awaitable, Callable
from contextlib import suppress
from typing import NamedTuple

from kindsl.analysis.analysis import Analysis
from kindsl.analysis.settings import Settings
from kindsl.features.manipulation.add_child import add_child
from kindsl.features.manipulation.add_frame import add_frame
from kindsl.features.manipulation.gesture import Gesture, Refusal
from kindsl.features.manipulation.handles import handles
from kindsl.features.manipulation.mirror_leg import mirror_leg
from kindsl.features.manipulation.pose_as_zero import pose_as_zero
from kindsl.features.manipulation.set_component import ComponentChange, set_component
from kindsl.features.manipulation.things import Thing, carrying_frame
from kindsl.preview.document_preview import DocumentPreview
from kindsl.preview.gesture_requests import Drag, GestureRequest, Grasp, Plan
from kindsl.preview.steps import Steps, difference
from kindsl.scene.messages import (
    DraggedMessage,
    EditingMessage,
    HandleRow,
    HandlesMessage,
    PlanMessage,
    WrittenMessage,
)
from kindsl.scene.state import keyed
from kindsl.semantics.parameters import Binding
from kindsl.text.edits import TextEdit

PATIENCE = 2.0  # seconds, for what was written to be shown
_OUTDATED = "the document has changed meanwhile"


class Writing(NamedTuple):
    """What is to be written, as one step of undo.

    Attributes:
        label: What it does, in the imperative.
        text: The document that it was made for.
        edits: Of that text.
        bindings: Parameters to bind anew in the configuration file.
    """

    label: str
    text: str
    edits: tuple[TextEdit, ...]
    bindings: tuple[tuple[str, float], ...] = ()


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
            if isinstance(request, Drag):
                self._refuse(request, "internal error")
            elif isinstance(request, Plan):
                self._preview.channel.announce(PlanMessage(request.gesture, "", "internal error"))

    async def _do(self, request: GestureRequest) -> None:
        if isinstance(request, Grasp):
            self._grasp(request)
        elif isinstance(request, Drag):
            await self._drag(request)
        else:
            await self._plan(request)

    def _grasp(self, request: Grasp) -> None:
        """Show the handles of a thing; of none for an empty name."""
        self._held = Thing(request.kind, request.name) if request.name else None
        self._tell_handles()

    async def _drag(self, request: Drag) -> None:
        """Try a new value out, or write it, or leave all as it was."""
        analysis = self._preview.analysis
        if analysis is None or request.revision != self._preview.revision:
            self._refuse(request, _OUTDATED)
            return
        if request.phase == "cancel":
            self._preview.put_back()
            self._answer(request, "", request.value, "")
            self._tell_handles()
            return
        change = set_component(
            analysis,
            Thing(request.kind, request.name),
            request.component,
            request.value,
            request.step,
            self._preview.typed,
        )
        if isinstance(change, Refusal):
            self._refuse(request, change.reason)
        elif request.phase == "move":
            self._try(analysis, request, change)
        else:
            await self._drop(analysis, request, change)

    async def _plan(self, request: Plan) -> None:
        """Show a gesture as a ghost, or write it when it is accepted."""
        analysis = self._preview.analysis
        if analysis is None or request.revision != self._preview.revision:
            self._preview.channel.announce(PlanMessage(request.gesture, "", _OUTDATED))
            return
        if request.gesture == "discard":
            self._preview.show_plan(None)
            return
        if request.gesture in ("undo", "redo"):
            await self._step(analysis.text, request.gesture)
            return
        gesture = _gesture(analysis, request)
        if isinstance(gesture, Refusal):
            self._preview.channel.announce(PlanMessage(request.gesture, "", gesture.reason))
        elif request.is_accepted:
            self._preview.show_plan(None)
            writing = Writing(gesture.title, analysis.text, gesture.edits)
            reason = await self._written(writing)
            self._preview.channel.announce(WrittenMessage(request.gesture, gesture.title, reason))
        else:
            self._preview.show_plan(analysis.edited(gesture.edits))
            self._preview.channel.announce(PlanMessage(request.gesture, gesture.title, ""))

    def _try(self, analysis: Analysis, request: Drag, change: ComponentChange) -> None:
        self._preview.set_parameters(dict(change.preview))
        self._preview.try_out(_changed(analysis, change))
        self._answer(request, change.text, change.value, "")

    async def _drop(self, analysis: Analysis, request: Drag, change: ComponentChange) -> None:
        self._preview.set_parameters(dict(change.preview))
        reason = ""
        if change.edits or change.bindings:
            label = f"Set {request.component} of {request.kind} '{request.name}'"
            writing = Writing(label, analysis.text, change.edits, change.bindings)
            reason = await self._written(writing)
        if reason:
            self._preview.put_back()
        is_written = bool(change.edits) and not reason
        self._answer(request, change.text, change.value, reason, is_written=is_written)
        self._tell_handles()

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

    async def _step(self, text: str, gesture: str) -> None:
        """Take back what was written last, or make it again."""
        steps, is_undo = self._steps, gesture == "undo"
        step = steps.to_undo(text) if is_undo else steps.to_redo(text)
        if isinstance(step, str):
            self._preview.channel.announce(PlanMessage(gesture, "", step))
            return
        label = f"Undo: {step.label}" if is_undo else step.label
        reason = await self._write_and_wait(Writing(label, text, (difference(step),)))
        if not reason:
            (steps.undone if is_undo else steps.redone)()
        self._preview.channel.announce(WrittenMessage(gesture, label, reason))

    def _refuse(self, request: Drag, reason: str) -> None:
        self._preview.put_back()
        self._answer(request, "", request.value, reason)
        self._tell_handles()

    def _answer(
        self, request: Drag, text: str, value: float, reason: str, *, is_written: bool = False
    ) -> None:
        message = DraggedMessage(
            request.phase, request.component, text, value, reason, written=is_written
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
            components=tuple(HandleRow(**handle._asdict()) for handle in found),
        )
        self._preview.channel.replace("handles", keyed([message]))


def _changed(analysis: Analysis, change: ComponentChange) -> Analysis:
    """Return the document as it would be."""
    trial = analysis.edited(change.edits) if change.edits else analysis
    if not change.bindings:
        return trial
    return trial.with_settings(_rebound(analysis.settings, dict(change.bindings)))


def _rebound(settings: Settings, values: dict[str, float]) -> Settings:
    known = settings.bindings
    new = {name: known.get(name, Binding(v))._replace(value=v) for name, v in values.items()}
    return settings._replace(bindings={**known, **new})


def _gesture(analysis: Analysis, request: Plan) -> Gesture | Refusal:
    if request.gesture == "add-frame":
        return add_frame(analysis, request.name, request.point)
    if request.gesture == "add-child":
        return add_child(analysis, request.name, request.point)
    if request.gesture == "mirror-leg":
        return mirror_leg(analysis, request.name)
    return pose_as_zero(analysis, request.joints)
