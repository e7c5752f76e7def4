"""From what was clicked in a page to its place in the source."""

from collections.abc import Sequence

from kindsl.frontends.preview.findings import listed
from kindsl.frontends.preview.requests import Reveal
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.places import Located
from kindsl.language.text.span import Span


def place_of(chosen: Reveal, analysis: Analysis, findings: Sequence[Diagnostic]) -> Span | None:
    """Return the place that a click means, None if the document has it no longer.

    For a link, joint, frame or parameter that is its name; for a finding, what it marks.
    """
    if chosen.kind == "finding":
        return _place_of_finding(chosen.name, findings)
    located = _located(chosen, analysis.model)
    return None if located is None else Span(*analysis.resolver.span(located))


def _place_of_finding(number: str, findings: Sequence[Diagnostic]) -> Span | None:
    shown = listed(findings)
    if not number.isdecimal() or int(number) >= len(shown):
        return None
    finding = shown[int(number)]
    return Span(finding.start, finding.end)


def _located(chosen: Reveal, model: Model) -> Located | None:
    if chosen.kind == "link":
        link = model.body_named.get(chosen.name)
        return link.name if link else None
    if chosen.kind == "joint":
        joint = model.joint_named.get(chosen.name)
        return joint.name if joint else None
    if chosen.kind == "frame":
        return _frame_name(chosen.name, model)
    return next((p.name for p in model.parameters if p.name == chosen.name), None)


def _frame_name(name: str, model: Model) -> Located | None:
    """Return a frame's name; one whose name was taken is called `link.frame`."""
    for frame in model.frames:
        if name in (str(frame.name), f"{frame.link}.{frame.name}"):
            return frame.name
    return None
