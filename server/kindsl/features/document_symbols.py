"""The outline of a document: the kinematic tree.

A link stands below the link that carries it; below itself it has its supporting joint, the links
that it carries and its optional frames. What no base carries stands after the base, so nothing is
ever lost; a branch that is deeper than clients bear begins anew at the top.
"""

from collections.abc import Iterator
from typing import NamedTuple

from kindsl.analysis.analysis import Analysis
from kindsl.semantics.declarations import Frame, Joint, Link
from kindsl.semantics.kinematic_tree import Edge
from kindsl.semantics.places import Located, Name


class DocumentSymbol(NamedTuple):
    """An entry of the outline.

    Attributes:
        name: As written, or a stand-in where the name is missing.
        detail: What else to tell of it.
        kind: `robot`, `base`, `link`, `joint` or `frame`.
        start: Start of the whole construct.
        end: Its end.
        name_start: Start of the name, inside the construct.
        name_end: Its end.
        children: Entries below.
    """

    name: str
    detail: str
    kind: str
    start: int
    end: int
    name_start: int
    name_end: int
    children: "tuple[DocumentSymbol, ...]" = ()


_DEPTH = 100


def document_symbols(analysis: Analysis) -> tuple[DocumentSymbol, ...]:
    """Return the outline; an editor that cannot nest reads it from the top."""
    model = analysis.model
    seen: set[Link | Joint] = set()
    tree = [
        _body(analysis, body, None, seen, _DEPTH)
        for body in (*model.bases, *_roots(analysis), *model.links)
        if body not in seen
    ]
    rest = [_joint(analysis, joint) for joint in model.joints if joint not in seen]
    return (*tree, *rest)


def flat_symbols(analysis: Analysis) -> Iterator[DocumentSymbol]:
    """Yield bodies, joints and frames in the order of the text, without nesting."""
    model = analysis.model
    found = [
        _entry(analysis, body, body.name, _kind(body), _id_detail(body)) for body in model.bodies
    ]
    found += [_joint(analysis, joint) for joint in model.joints]
    found += [_frame(analysis, frame) for frame in model.frames]
    yield from sorted(found, key=lambda symbol: symbol.start)


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
        below.append(_joint(analysis, edge.joint))
    for successor in analysis.model.tree.successor_edges(body):
        if depth and successor.link is not None and successor.link not in seen:
            below.append(_body(analysis, successor.link, successor, seen, depth - 1))
    frames = [_frame(analysis, frame) for frame in body.frames]
    detail = _detail(body, edge)
    return _entry(analysis, body, body.name, _kind(body), detail, (*below, *frames))


def _detail(body: Link, edge: Edge | None) -> str:
    if edge is None:
        return _id_detail(body)
    kind = f" ({edge.joint.kind})" if edge.joint is not None else ""
    return ", ".join(part for part in (f"via {edge.child.joint}{kind}", _id_detail(body)) if part)


def _id_detail(body: Link) -> str:
    if body.is_base:
        return "floating base" if body.is_floating else "base"
    return "" if body.id is None else f"id {body.id}"


def _kind(body: Link) -> str:
    return "base" if body.is_base else "link"


def _joint(analysis: Analysis, joint: Joint) -> DocumentSymbol:
    return _entry(analysis, joint, joint.name, "joint", joint.kind)


def _frame(analysis: Analysis, frame: Frame) -> DocumentSymbol:
    return _entry(analysis, frame, frame.name, "frame", "frame")


def _entry(
    analysis: Analysis,
    at: Located,
    name: Name,
    kind: str,
    detail: str,
    children: tuple[DocumentSymbol, ...] = (),
) -> DocumentSymbol:
    start, end = analysis.resolver.span(at)
    name_start, name_end = analysis.resolver.span(name)
    shown = str(name) or f"({kind} without a name)"
    return DocumentSymbol(shown, detail, kind, start, end, name_start, name_end, children)
