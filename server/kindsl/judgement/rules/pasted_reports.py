"""Reports of mass properties in a document: the message, and the action that takes them over."""

from kindsl.judgement.rules.base import Finding, Fix
from kindsl.judgement.rules.inertia_writing import body_around, inertia_changes
from kindsl.language.semantics.declarations import Link
from kindsl.language.semantics.lowering import declarations
from kindsl.language.semantics.places import Place
from kindsl.language.syntax.passages import SHAPES
from kindsl.language.text.phrases import listed
from kindsl.robots.cad.properties import MassProperties
from kindsl.robots.cad.report import ReportError
from kindsl.robots.cad.shape import ShapeError, shape_called
from kindsl.robots.cad.taking_over import mass_properties

_TITLE = "Take over the mass properties"
_CONVENTIONS = {
    1: f"{_TITLE}: products are Σ m x y, as in the language",
    -1: f"{_TITLE}: products are entries of the tensor, change their signs",
}


def report_finding(at: Place) -> Finding:
    """Return the finding of a report of mass properties, or of a shape."""
    text = at.island.text[at.start : at.end]
    if text.startswith(SHAPES):
        return _shape_finding(text, at)
    try:
        found = mass_properties(text)
    except ReportError as error:
        reasons = listed(error.reasons)
        return Finding(at, f"mass properties of {error.program} cannot be taken over: {reasons}")
    body = _body(at)
    message = f"mass properties of {found.program}"
    if body is None:
        return Finding(at, f"{message} belong in a link")
    message = "; ".join((f"{message}: take them over", *_notes(found, body)))
    if found.sign is not None:
        return Finding(at, message, fix=_fix(_TITLE, body, found, at))
    choices = (_fix(title, body, found.by_sign(s), at) for s, title in _CONVENTIONS.items())
    return Finding(at, message, choices=tuple(choices))


def _shape_finding(text: str, at: Place) -> Finding:
    """Return the finding of a shape whose inertia is asked for."""
    try:
        found = shape_called(text)
    except ShapeError as error:
        return Finding(at, f"no inertia of this shape: {error}")
    body = _body(at)
    if body is None:
        return Finding(at, f"{found.program} belongs in a link")
    title = f"Write the inertia of {found.program}"
    return Finding(at, f"{found.program} instead of its inertia", fix=_fix(title, body, found, at))


def _body(at: Place) -> Link | None:
    declared = declarations(at.island)
    return body_around((*declared.bases, *declared.links), at)


def _notes(found: MassProperties, body: Link) -> tuple[str, ...]:
    """Return what a person has to know before he takes a report over."""
    is_own = found.system in {str(frame.name) for frame in body.frames}
    return () if is_own else found.notes


def _fix(title: str, body: Link, found: MassProperties, at: Place) -> Fix:
    return Fix(title, inertia_changes(body, found, at), is_safe=False)
