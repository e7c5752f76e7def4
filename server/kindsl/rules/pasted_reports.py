"""Reports of mass properties in a document: the message, and the action that takes them over."""

from kindsl.cad.properties import MassProperties
from kindsl.cad.report import ReportError
from kindsl.cad.taking_over import mass_properties
from kindsl.rules.base import Finding, Fix
from kindsl.rules.inertia_writing import body_around, inertia_changes
from kindsl.semantics.declarations import Link
from kindsl.semantics.lowering import declarations
from kindsl.semantics.places import Place
from kindsl.text.phrases import listed

_TITLE = "Take over the mass properties"
_CONVENTIONS = {
    1: f"{_TITLE}: products are Σ m x y, as in the language",
    -1: f"{_TITLE}: products are entries of the tensor, change their signs",
}


def report_finding(at: Place) -> Finding:
    """Return the finding of a report of mass properties.

    Args:
        at: Where it stands.
    """
    try:
        found = mass_properties(at.island.text[at.start : at.end])
    except ReportError as error:
        reasons = listed(error.reasons)
        return Finding(at, f"mass properties of {error.program} cannot be taken over: {reasons}")
    declared = declarations(at.island)
    body = body_around((*declared.bases, *declared.links), at)
    message = f"mass properties of {found.program}"
    if body is None:
        return Finding(at, f"{message} belong into a link")
    message = "; ".join((f"{message}: take them over", *_notes(found, body)))
    if found.sign is not None:
        return Finding(at, message, fix=_fix(_TITLE, body, found, at))
    choices = (_fix(title, body, found.by_sign(s), at) for s, title in _CONVENTIONS.items())
    return Finding(at, message, choices=tuple(choices))


def _notes(found: MassProperties, body: Link) -> tuple[str, ...]:
    """Return what a person has to know before he takes a report over."""
    is_own = found.system in {str(frame.name) for frame in body.frames}
    return () if is_own else found.notes


def _fix(title: str, body: Link, found: MassProperties, at: Place) -> Fix:
    return Fix(title, inertia_changes(body, found, at), is_safe=False)
