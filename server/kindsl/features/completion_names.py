"""Names that fit a place: children not yet attached, joints not yet used, own frames, new ones."""

from collections.abc import Iterator

from kindsl.features.completion_context import CompletionContext
from kindsl.features.completion_item import CompletionItem
from kindsl.features.tree_path import path_at
from kindsl.rules.analysis import Analysis
from kindsl.semantics.declarations import Link
from kindsl.semantics.lowering import declarations


def child_items(analysis: Analysis) -> Iterator[CompletionItem]:
    """Yield links to carry: those that nothing carries first, with a joint that is free."""
    tree = analysis.model.tree
    joint = next((j for j in analysis.model.joints if j not in tree.joint_uses and j.name), None)
    via = str(joint.name) if joint is not None else "joint"
    for link in analysis.model.links:
        if link.name and link not in tree.above:
            text, label = f"{link.name} via ${{1:{via}}}", f"{link.name} via …"
            yield CompletionItem(label, "snippet", text, "not yet attached", 1, is_snippet=True)
            yield CompletionItem(str(link.name), "link", str(link.name), "not yet attached", 2)
    for link in analysis.model.links:
        if link.name and link in tree.above:
            parent = tree.above[link][0].predecessor.name
            yield CompletionItem(str(link.name), "link", str(link.name), f"child of {parent}", 7)


def joint_items(analysis: Analysis) -> Iterator[CompletionItem]:
    """Yield joints: those that connect nothing yet first."""
    uses = analysis.model.tree.joint_uses
    joints = [joint for joint in analysis.model.joints if joint.name]
    for joint in joints:
        if joint not in uses:
            detail = f"{joint.kind}, free"
            yield CompletionItem(str(joint.name), "joint", str(joint.name), detail, 1)
    for joint in joints:
        if joint in uses:
            detail = f"{joint.kind}, moves {uses[joint][0].child.link}"
            yield CompletionItem(str(joint.name), "joint", str(joint.name), detail, 7)


def own_frame_items(context: CompletionContext) -> Iterator[CompletionItem]:
    """Yield the frames of the link around the cursor."""
    body = _body_at(context)
    for frame in body.frames if body is not None else ():
        if frame.name:
            yield CompletionItem(str(frame.name), "frame", str(frame.name), "frame of this link", 1)


def new_link_items(analysis: Analysis) -> Iterator[CompletionItem]:
    """Yield names for a new link: children that are named somewhere and declared nowhere."""
    for name in undeclared_links(analysis):
        yield CompletionItem(name, "link", name, "named as a child, not declared", 1)


def new_joint_items(analysis: Analysis) -> Iterator[CompletionItem]:
    """Yield names for a new joint: those behind a `via` that are declared nowhere."""
    for name in undeclared_joints(analysis):
        yield CompletionItem(name, "joint", name, "used, not declared", 1)


def id_items(analysis: Analysis, context: CompletionContext) -> Iterator[CompletionItem]:
    """Yield the smallest number that no other link has."""
    number = str(next_id(analysis, _body_at(context)))
    yield CompletionItem(number, "value", number, "next free id", 1)


def next_id(analysis: Analysis, own: Link | None = None) -> int:
    """Return the smallest id that no link has, a link of one's own left out."""
    taken = {link.id for link in analysis.model.links if link is not own}
    return next(number for number in range(1, len(taken) + 2) if number not in taken)


def undeclared_links(analysis: Analysis) -> Iterator[str]:
    """Yield the names of children that no link declares, each once."""
    edges = analysis.model.tree.edges
    names = [str(edge.child.link) for edge in edges if edge.link is None and edge.child.link]
    yield from dict.fromkeys(names)


def undeclared_joints(analysis: Analysis) -> Iterator[str]:
    """Yield the names behind `via` that no joint declares, each once."""
    edges = analysis.model.tree.edges
    names = [str(edge.child.joint) for edge in edges if edge.joint is None and edge.child.joint]
    yield from dict.fromkeys(names)


def _body_at(context: CompletionContext) -> Link | None:
    island, local = context.place.island, context.start - context.place.start
    path = path_at(island, local)
    bodies = declarations(island).bodies()
    return next((body for body in bodies if path and body.node is path[0]), None)
