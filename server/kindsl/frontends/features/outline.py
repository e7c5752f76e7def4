"""The outline of a document, its kinematic tree, and the search for names in a workspace."""

from collections.abc import Iterator
from typing import NamedTuple

from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.semantics.declarations import Frame, Joint, Link
from kindsl.language.semantics.kinematic_tree import Edge
from kindsl.language.semantics.places import Construct

_DEPTH = 100


class DocumentSymbol(NamedTuple):
    """An entry of the outline: a whole construct, and inside it its name.

    Attributes:
        name: As written, or a stand-in where the name is missing.
        detail: A few words beside the name.
        kind: `robot`, `base`, `link`, `joint` or `frame`.
    """

    name: str
    detail: str
    kind: str
    start: int
    end: int
    name_start: int
    name_end: int
    children: "tuple[DocumentSymbol, ...]" = ()


def document_symbols(analysis: Analysis) -> tuple[DocumentSymbol, ...]:
    """Return the outline: robot, then base, links and joints, then frames."""
    blocks = sorted(_blocks(analysis), key=lambda symbol: symbol.start)
    name = next((d.robot for d in analysis.model.declared if d.robot), None)
    if name is None:
        return tuple(blocks)
    head = next(node for node in name.island.nodes if node.kind == "head")
    start, _ = analysis.resolver.span(Construct(head, name.island))
    before = [block for block in blocks if block.start < start]
    inside = tuple(blocks[len(before) :])
    name_start, name_end = analysis.resolver.span(name)
    end = max((name_end, *_closing_braces(analysis), *(block.end for block in inside)))
    robot = DocumentSymbol(str(name), "robot", "robot", start, end, name_start, name_end, inside)
    return (*before, robot)


def flat_symbols(analysis: Analysis) -> Iterator[DocumentSymbol]:
    """Yield bodies, joints and frames in the order of the text, without nesting."""
    frames = (frame_symbol(analysis, frame) for frame in analysis.model.frames)
    blocks = (block._replace(children=()) for block in _blocks(analysis))
    yield from sorted((*blocks, *frames), key=lambda symbol: symbol.start)


def body_symbol(
    analysis: Analysis, body: Link, detail: str, children: tuple[DocumentSymbol, ...] = ()
) -> DocumentSymbol:
    """Return the entry of a link or base."""
    kind = "base" if body.is_base else "link"
    return _entry(analysis, body, kind, detail, children)


def joint_symbol(analysis: Analysis, joint: Joint) -> DocumentSymbol:
    """Return the entry of a joint."""
    return _entry(analysis, joint, "joint", joint.kind)


def frame_symbol(analysis: Analysis, frame: Frame) -> DocumentSymbol:
    """Return the entry of an optional frame."""
    return _entry(analysis, frame, "frame", "frame")


def _id_detail(body: Link) -> str:
    if body.is_base:
        return "floating base" if body.is_floating else "base"
    return "" if body.id is None else f"id {body.id}"


def _blocks(analysis: Analysis) -> Iterator[DocumentSymbol]:
    for body in analysis.model.bodies:
        frames = tuple(frame_symbol(analysis, frame) for frame in body.frames)
        yield body_symbol(analysis, body, _id_detail(body), frames)
    for joint in analysis.model.joints:
        yield joint_symbol(analysis, joint)


def _closing_braces(analysis: Analysis) -> Iterator[int]:
    syntax = analysis.syntax
    for island, start in zip(syntax.islands, syntax.starts, strict=True):
        yield from (start + node.end for node in island.nodes if node.kind == "end")


def _entry(
    analysis: Analysis,
    thing: Link | Joint | Frame,
    kind: str,
    detail: str,
    children: tuple[DocumentSymbol, ...] = (),
) -> DocumentSymbol:
    start, end = analysis.resolver.span(thing)
    name_start, name_end = analysis.resolver.span(thing.name)
    shown = str(thing.name) or f"({kind} without a name)"
    return DocumentSymbol(shown, detail, kind, start, end, name_start, name_end, children)


def kinematic_outline(analysis: Analysis) -> tuple[DocumentSymbol, ...]:
    """Return the tree, its entries in the order of the tree rather than of the text."""
    model = analysis.model
    seen: set[Link | Joint] = set()
    roots = (link for link in model.links if link not in model.tree.above)
    tree = [
        _body(analysis, body, None, seen, _DEPTH)
        for body in (*model.bases, *roots, *model.links)
        if body not in seen
    ]
    rest = [joint_symbol(analysis, joint) for joint in model.joints if joint not in seen]
    return (*tree, *rest)


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
        return _id_detail(body)
    kind = f" ({edge.joint.kind})" if edge.joint is not None else ""
    return ", ".join(part for part in (f"via {edge.child.joint}{kind}", _id_detail(body)) if part)


class WorkspaceSymbol(NamedTuple):
    """A link, joint, frame or robot; `container` is the robot's name."""

    name: str
    kind: str
    container: str
    start: int
    end: int


def is_match(query: str, name: str) -> bool:
    """Return whether the letters of a query stand in a name in this order, whatever their case."""
    folded, place = name.casefold(), 0
    for letter in query.casefold():
        place = place if letter.isspace() else folded.find(letter, place) + 1
        if not place and not letter.isspace():
            return False
    return True


def workspace_symbols(analysis: Analysis) -> Iterator[WorkspaceSymbol]:
    """Yield what a document names, the robot first, then in the order of the text."""
    robot = analysis.model.name
    for declared in analysis.model.declared:
        if declared.robot:
            yield WorkspaceSymbol(robot, "robot", "", *analysis.resolver.span(declared.robot))
    for symbol in flat_symbols(analysis):
        if symbol.name_start < symbol.name_end:
            yield WorkspaceSymbol(
                symbol.name, symbol.kind, robot, symbol.name_start, symbol.name_end
            )
