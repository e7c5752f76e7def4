"""Create what a reference names and nothing has, beside what may be meant instead."""

from collections.abc import Iterator

from kindsl.frontends.features.actions.action import CodeAction
from kindsl.frontends.features.actions.new_frame import add_referenced_frame
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.rules.base import Fix
from kindsl.judgement.rules.new_blocks import new_joint, new_link
from kindsl.language.text.edits import TextEdit

_LINK, _JOINT, _FRAME = "KD105", "KD106", "KD107"


def create_missing(analysis: Analysis, finding: Diagnostic) -> Iterator[CodeAction]:
    """Offer the link, joint or frame that a finding misses, unless its own fix is that."""
    if finding.code == _FRAME:
        yield from add_referenced_frame(analysis, finding)
    elif finding.code in (_LINK, _JOINT):
        fix = _block(analysis, finding)
        if fix is not None and (finding.fix is None or finding.fix.title != fix.title):
            edits = (
                TextEdit(*analysis.resolver.span(change.at), change.text) for change in fix.changes
            )
            yield CodeAction(fix.title, "quickfix", tuple(edits), (finding,))


def _block(analysis: Analysis, finding: Diagnostic) -> Fix | None:
    """Return the fix that writes the block whose name stands at a finding."""
    model, span = analysis.model, (finding.start, finding.end)
    for edge in model.tree.edges:
        link, joint = edge.child
        if finding.code == _JOINT and analysis.resolver.span(joint) == span:
            return new_joint(model, str(joint))
        if finding.code == _LINK and analysis.resolver.span(link) == span:
            return new_link(model, str(link), parent_id=edge.predecessor.id or 0)
    return None
