"""Names that fit a place: children not yet attached, joints not yet used, own frames, new ones."""

from collections.abc import Container, Iterable, Iterator

from kindsl.analysis.analysis import Analysis
from kindsl.features.completion.context import CompletionContext
from kindsl.features.completion.item import CompletionItem
from kindsl.features.tree_path import path_at
from kindsl.semantics.declarations import Link
from kindsl.semantics.lowering import declarations


def child_items(analysis: Analysis) -> Iterator[CompletionItem]:
    """Yield links to carry: those that nothing carries first, with a joint that is free."""
    model = analysis.model
    parents = {str(child.link): body for body in model.bodies for child in body.children}
    used = {str(child.joint) for body in model.bodies for child in body.children}
    free = next((str(j.name) for j in model.joints if j.name and j.name not in used), "joint")
    names = [str(link.name) for link in model.links if link.name]
    for name in names:
        if name not in parents:
            text, label = f"{name} via ${{1:{free}}}", f"{name} via …"
            yield CompletionItem(label, "snippet", text, "not yet attached", 1, is_snippet=True)
            yield CompletionItem(name, "link", name, "not yet attached", 2)
    for name in names:
        if name in parents:
            yield CompletionItem(name, "link", name, f"child of {parents[name].name}", 7)


def joint_items(analysis: Analysis) -> Iterator[CompletionItem]:
    """Yield joints: those that connect nothing yet first."""
    moved = {str(c.joint): str(c.link) for body in analysis.model.bodies for c in body.children}
    joints = [joint for joint in analysis.model.joints if joint.name]
    for joint in joints:
        if joint.name not in moved:
            name, detail = str(joint.name), f"{joint.kind}, free"
            yield CompletionItem(name, "joint", name, detail, 1)
    for joint in joints:
        if joint.name in moved:
            name, detail = str(joint.name), f"{joint.kind}, moves {moved[joint.name]}"
            yield CompletionItem(name, "joint", name, detail, 7)


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
    names = (str(child.link) for body in analysis.model.bodies for child in body.children)
    yield from _missing(names, analysis.model.body_named)


def undeclared_joints(analysis: Analysis) -> Iterator[str]:
    """Yield the names behind `via` that no joint declares, each once."""
    names = (str(child.joint) for body in analysis.model.bodies for child in body.children)
    yield from _missing(names, analysis.model.joint_named)


def _missing(names: Iterable[str], declared: Container[str]) -> Iterator[str]:
    yield from dict.fromkeys(name for name in names if name and name not in declared)


def _body_at(context: CompletionContext) -> Link | None:
    island, local = context.place.island, context.start - context.place.start
    path = path_at(island, local)
    bodies = declarations(island).bodies()
    return next((body for body in bodies if path and body.node is path[0]), None)
