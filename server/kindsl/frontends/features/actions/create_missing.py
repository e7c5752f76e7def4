"""Create what a reference names and nothing has, beside what may be meant instead."""

from collections.abc import Iterator

from kindsl.frontends.features.actions.action import CodeAction
from kindsl.frontends.features.manipulation.new_blocks import new_frame
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.rules.base import Fix
from kindsl.judgement.rules.new_blocks import new_joint, new_link

_LINK, _JOINT, _FRAME = "KD105", "KD106", "KD107"


_ORIGIN = (0.0, 0.0, 0.0)


def create_missing(analysis: Analysis, finding: Diagnostic) -> Iterator[CodeAction]:
    """Offer the link, joint or frame that a finding misses, unless its own fix is that."""
    if finding.code == _FRAME:
        yield from _add_referenced_frame(analysis, finding)
    elif finding.code in (_LINK, _JOINT):
        fix = _block(analysis, finding)
        if fix is not None and (finding.fix is None or finding.fix.title != fix.title):
            edits = analysis.resolver.edits(fix)
            yield CodeAction(fix.title, "quickfix", edits, (finding,))


def _block(analysis: Analysis, finding: Diagnostic) -> Fix | None:
    model, span = analysis.model, (finding.start, finding.end)
    for edge in model.tree.edges:
        link, joint = edge.child
        if finding.code == _JOINT and analysis.resolver.span(joint) == span:
            return new_joint(model, str(joint))
        if finding.code == _LINK and analysis.resolver.span(link) == span:
            return new_link(model, str(link), parent_id=edge.predecessor.id or 0)
    return None


def _add_referenced_frame(analysis: Analysis, finding: Diagnostic) -> Iterator[CodeAction]:
    """Offer the frame that the `ref_frame` at a finding names, at the origin of its link.

    Not where something else has the name.
    """
    model = analysis.model
    taken = {name.lower() for name in (*model.body_named, *model.joint_named)}
    for link in model.bodies:
        name = link.inertia.frame if link.inertia is not None else None
        if name is None or analysis.resolver.span(name)[0] != finding.start:
            continue
        edit = new_frame(link, str(name), _ORIGIN)
        if edit is not None and name.lower() not in taken:
            edits = (analysis.resolver.edit_of(link.island, edit),)
            title = f"Create frame '{name}' in '{link.name}'"
            yield CodeAction(title, "quickfix", edits, (finding,))
