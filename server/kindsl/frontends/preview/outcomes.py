"""The outcome of a page's request, decided before anything is shown or written."""

from collections.abc import Mapping
from typing import NamedTuple

from kindsl.frontends.features.manipulation.additions import add_child, add_frame
from kindsl.frontends.features.manipulation.carried_moments import with_moments
from kindsl.frontends.features.manipulation.gesture import Gesture, Refusal
from kindsl.frontends.features.manipulation.mirror_leg import mirror_leg
from kindsl.frontends.features.manipulation.pose_as_zero import pose_as_zero
from kindsl.frontends.features.manipulation.set_component import set_component
from kindsl.frontends.features.manipulation.things import Thing
from kindsl.frontends.preview.requests import Drag, Plan
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.judgement.rules.base import Severity
from kindsl.language.text.edits import TextEdit

Bindings = tuple[tuple[str, float], ...]
_IMPOSSIBLE = ("KD301", "KD302")


class Writing(NamedTuple):
    """The text to be written, as one step of undo.

    Attributes:
        label: Its title, in the imperative.
        text: The document that it was made for.
        edits: Of that text.
        bindings: Parameters to bind anew in the configuration file.
    """

    label: str
    text: str
    edits: tuple[TextEdit, ...]
    bindings: Bindings = ()


class RequestOutcome(NamedTuple):
    """The outcome of a request.

    Attributes:
        writing: The text to write; nothing where all is so already.
        document: The document as it would be; None where it is written at once.
        text: The component that was dragged, or what carries it, as it would be written.
        value: Its value then, metres or radians; 0 of a gesture.
        parameters: To be set in the preview only, by name.
        warning: Which body becomes impossible by it, one sentence; empty for none.
    """

    writing: Writing
    document: Analysis | None
    text: str = ""
    value: float = 0.0
    parameters: Mapping[str, float] = {}
    warning: str = ""


def drag_outcome(
    analysis: Analysis, request: Drag, typed: Mapping[str, float]
) -> RequestOutcome | Refusal:
    """Return what moving or dropping a handle would do.

    Args:
        analysis: The document that is shown.
        request: The page's request.
        typed: Values of parameters that the preview shows instead of the document's.
    """
    thing = Thing(request.kind, request.name)
    change = set_component(analysis, thing, request.component, request.value, request.step, typed)
    if isinstance(change, Refusal):
        return change
    if request.carries and request.kind == "com":
        change = with_moments(analysis, request.name, request.component, change)
        if isinstance(change, Refusal):
            return change
    writing = Writing(change.label, analysis.text, change.edits, change.bindings)
    tried = analysis.changed(change.edits, dict(change.bindings))
    document = tried if request.phase == "move" else None
    is_about_bodies = request.kind != "joint" or change.bindings
    warning = _newly_impossible(analysis, tried) if is_about_bodies else ""
    parameters = dict(change.preview)
    return RequestOutcome(writing, document, change.text, change.value, parameters, warning)


def _newly_impossible(before: Analysis, after: Analysis) -> str:
    """Return what is said of the first body that is impossible now and was not; empty for none."""
    known = _impossible_bodies(before)
    return next((told for name, told in _impossible_bodies(after).items() if name not in known), "")


def _impossible_bodies(analysis: Analysis) -> dict[str, str]:
    """Return what is said of each impossible body, by its name."""
    return {
        finding.subject.name: finding.message
        for finding in analysis.check_without_twins()
        if finding.code in _IMPOSSIBLE and finding.severity is Severity.ERROR
    }


def plan_outcome(analysis: Analysis, request: Plan) -> RequestOutcome | Refusal:
    """Return what adding or rewriting something as a whole would do."""
    gesture = _gesture(analysis, request)
    if isinstance(gesture, Refusal):
        return gesture
    writing = Writing(gesture.title, analysis.text, gesture.edits)
    return RequestOutcome(writing, None if request.accepted else analysis.edited(gesture.edits))


def _gesture(analysis: Analysis, request: Plan) -> Gesture | Refusal:
    if request.gesture == "add-frame":
        return add_frame(analysis, request.name, request.point)
    if request.gesture == "add-child":
        return add_child(analysis, request.name, request.point)
    if request.gesture == "mirror-leg":
        return mirror_leg(analysis, request.name)
    return pose_as_zero(analysis, request.joints)
