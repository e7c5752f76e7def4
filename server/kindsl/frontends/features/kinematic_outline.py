"""The kinematic tree, as a view beside the text shows it.

A link stands below the link that carries it; below itself it has its supporting joint, the links
that it carries and its optional frames. What no base carries stands after the base, so nothing is
ever lost; a branch that is deeper than clients bear begins anew at the top.
"""

from collections.abc import Iterator

from kindsl.frontends.features.document_symbols import (
    DocumentSymbol,
    body_symbol,
    frame_symbol,
    id_detail,
    joint_symbol,
)
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.semantics.declarations import Joint, Link
from kindsl.language.semantics.kinematic_tree import Edge

_DEPTH = 100


def kinematic_outline(analysis: Analysis) -> tuple[DocumentSymbol, ...]:
    """Return the tree, its entries in the order of the tree rather than of the text."""
    model = analysis.model
    seen: set[Link | Joint] = set()
    tree = [
        _body(analysis, body, None, seen, _DEPTH)
        for body in (*model.bases, *_roots(analysis), *model.links)
        if body not in seen
    ]
    rest = [joint_symbol(analysis, joint) for joint in model.joints if joint not in seen]
    return (*tree, *rest)


def _roots(analysis: Analysis) -> Iterator[Link]:
    """Yield the links that nothing carries, in the order of the document."""
    above = analysis.model.tree.above
    return (link for link in analysis.model.links if link not in above)


def _body(
    analysis: Analysis, body: Link, edge: Edge | None, seen: set[Link | Joint], depth: int
) -> DocumentSymbol:
    seen.add(body)
    below = []
    if edge is not None and edge.joint is not None and edge.joint not in seen:
        seen.add(edge.joint)
        below.append(joint_symbol(analysis, edge.joint))
    for successor in analysis.model.tree.successor_edges(body):
        if depth and successor.link is not None and successor.link not in seen:
            below.append(_body(analysis, successor.link, successor, seen, depth - 1))
    frames = [frame_symbol(analysis, frame) for frame in body.frames]
    return body_symbol(analysis, body, _detail(body, edge), (*below, *frames))


def _detail(body: Link, edge: Edge | None) -> str:
    if edge is None:
        return id_detail(body)
    kind = f" ({edge.joint.kind})" if edge.joint is not None else ""
    return ", ".join(part for part in (f"via {edge.child.joint}{kind}", id_detail(body)) if part)
