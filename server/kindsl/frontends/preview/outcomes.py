"""The outcome of a page's request, decided before anything is shown or written."""

from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

from kindsl.frontends.features.manipulation.additions import add_child, add_frame
from kindsl.frontends.features.manipulation.carried_moments import with_moments
from kindsl.frontends.features.manipulation.gesture import Gesture, Refusal
from kindsl.frontends.features.manipulation.mirror_leg import mirror_leg
from kindsl.frontends.features.manipulation.pose_as_zero import pose_as_zero
from kindsl.frontends.features.manipulation.set_component import set_component
from kindsl.frontends.features.manipulation.things import Thing
from kindsl.frontends.preview.requests import Drag, Plan
from kindsl.frontends.preview.steps import Steps, Writing
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.rules.base import Severity
from kindsl.language.semantics.expressions import Values
from kindsl.robots.scene.messages import DraggedMessage, PlanMessage, WrittenMessage

_IMPOSSIBLE = ("KD301", "KD302")


class Outcome(NamedTuple):
    """The outcome of a request.

    Attributes:
        answer: For the page, if all goes well; None if it needs none.
        writing: The text to write now; None if something is only shown, or nothing changes.
        document: The document as it would be, to be shown; None to show it as it is.
        findings: What is found in that document.
        parameters: To be set in the preview only, by name.
    """

    answer: DraggedMessage | PlanMessage | WrittenMessage | None
    writing: Writing | None
    document: Analysis | None = None
    findings: Sequence[Diagnostic] = ()
    parameters: Mapping[str, float] = {}


def drag_outcome(analysis: Analysis, request: Drag, typed: Values) -> Outcome | Refusal:
    """Return what moving or dropping a handle would do.

    Args:
        typed: Values of parameters that the preview shows instead of the document's.
    """
    if request.phase == "cancel":
        return Refusal("")
    thing, component = Thing(request.kind, request.name), request.component
    change = set_component(analysis, thing, component, request.value, request.step, typed)
    if request.carries and thing.kind == "com" and not isinstance(change, Refusal):
        change = with_moments(analysis, thing.name, component, change)
    if isinstance(change, Refusal):
        return change
    tried = analysis.changed(change.edits, dict(change.bindings))
    phase, is_written = request.phase, request.phase == "drop" and bool(change.edits)
    is_about_bodies = bool(thing.kind != "joint" or change.bindings)
    findings = tried.check_without_twins() if phase == "move" or is_about_bodies else ()
    warning = _newly_impossible(analysis, findings) if is_about_bodies else ""
    answer = DraggedMessage(phase, component, change.text, change.value, "", is_written, warning)
    shown = dict(change.preview)
    if phase == "move":
        return Outcome(answer, None, tried, findings, shown)
    writing = Writing(change.label, analysis.text, change.edits, change.bindings)
    is_change = change.edits or change.bindings
    return Outcome(answer, writing if is_change else None, parameters=shown)


def plan_outcome(analysis: Analysis, request: Plan, steps: Steps) -> Outcome | Refusal:
    """Return what adding or rewriting something as a whole would do.

    Args:
        steps: What was written before, to be undone and redone.
    """
    gesture = request.gesture
    change: Gesture | Writing | Refusal
    if gesture == "discard":
        return Outcome(None, None)
    if gesture == "undo":
        change = steps.undo(analysis.text)
    elif gesture == "redo":
        change = steps.redo(analysis.text)
    elif gesture == "add-frame":
        change = add_frame(analysis, request.name, request.point)
    elif gesture == "add-child":
        change = add_child(analysis, request.name, request.point)
    elif gesture == "mirror-leg":
        change = mirror_leg(analysis, request.name)
    else:
        change = pose_as_zero(analysis, request.joints)
    if isinstance(change, Refusal):
        return change
    if isinstance(change, Gesture):
        if not request.accepted:
            # A pose that becomes zero moves nothing: its ghost would be turned once more.
            planned = None if gesture == "pose-as-zero" else analysis.edited(change.edits)
            return Outcome(PlanMessage(gesture, change.title, ""), None, planned)
        change = Writing(change.title, analysis.text, change.edits)
    return Outcome(WrittenMessage(gesture, change.label, ""), change)


def _newly_impossible(before: Analysis, after: Iterable[Diagnostic]) -> str:
    """Return the message about the first body that becomes impossible; empty for none."""
    known = {finding.subject.name for finding in _impossible(before.check_without_twins())}
    new = (f.message for f in _impossible(after) if f.subject.name not in known)
    return next(new, "")


def _impossible(findings: Iterable[Diagnostic]) -> list[Diagnostic]:
    return [f for f in findings if f.code in _IMPOSSIBLE and f.severity is Severity.ERROR]
