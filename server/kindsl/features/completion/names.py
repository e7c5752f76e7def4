"""Names that fit a place: own frames, and new ones that are used already and not declared."""

from collections.abc import Container, Iterable, Iterator
from itertools import count
from typing import TypeVar

from kindsl.analysis.analysis import Analysis
from kindsl.features.completion import snippets
from kindsl.features.completion.context import CompletionContext
from kindsl.features.completion.fresh_names import next_id
from kindsl.features.completion.item import CompletionItem
from kindsl.semantics.declarations import Joint, Link
from kindsl.semantics.lowering import declarations

_Block = TypeVar("_Block", Link, Joint)


def own_frame_items(context: CompletionContext) -> Iterator[CompletionItem]:
    """Yield the frames of the link around the cursor."""
    body = body_at(context)
    for frame in body.frames if body is not None else ():
        if frame.name:
            yield CompletionItem(str(frame.name), "frame", str(frame.name), "frame of this link")


def new_link_items(analysis: Analysis) -> Iterator[CompletionItem]:
    """Yield names for a new link: children that are named somewhere and declared nowhere."""
    for name in undeclared_links(analysis):
        yield CompletionItem(name, "link", name, "named as a child, not declared")


def new_joint_items(analysis: Analysis) -> Iterator[CompletionItem]:
    """Yield names for a new joint: those behind a `via` that are declared nowhere."""
    for name in undeclared_joints(analysis):
        yield CompletionItem(name, "joint", name, "used, not declared")


def new_frame_items(context: CompletionContext) -> Iterator[CompletionItem]:
    """Yield a new frame, and the name of one that the inertia is given in and nobody declares."""
    body = body_at(context)
    frame = body.inertia.frame if body is not None and body.inertia is not None else None
    declared = {str(frame.name) for frame in body.frames} if body is not None else set()
    if frame and str(frame) not in declared:
        text = snippets.frame(str(frame))
        yield CompletionItem(str(frame), "frame", text, "used, not declared", is_snippet=True)
    text = snippets.frame()
    yield CompletionItem(
        "frame", "snippet", text, "a frame of this link", is_snippet=True, is_asked_for=True
    )


def id_items(analysis: Analysis, context: CompletionContext) -> Iterator[CompletionItem]:
    """Yield the number that a link or joint is to have."""
    if context.block == "joint":
        number, detail = joint_id(analysis, context), "id of the link that it moves"
    else:
        number, detail = next_id(analysis, body_at(context)), "next free id"
    yield CompletionItem(str(number), "value", str(number), detail)


def joint_id(analysis: Analysis, context: CompletionContext) -> int:
    """Return the number for the joint around the cursor: that of the link it moves, if known."""
    joint = _joint_at(context)
    children = (child for body in analysis.model.bodies for child in body.children)
    name = str(joint.name) if joint is not None else ""
    moved = next((str(child.link) for child in children if name and child.joint == name), "")
    link = analysis.model.body_named.get(moved)
    taken = {other.id for other in analysis.model.joints if other is not joint}
    free = next(number for number in count(1) if number not in taken)
    return link.id if link is not None and link.id else free


def undeclared_links(analysis: Analysis) -> Iterator[str]:
    """Yield the names of children that no link declares, each once."""
    names = (str(child.link) for body in analysis.model.bodies for child in body.children)
    yield from _missing(names, analysis.model.body_named)


def undeclared_joints(analysis: Analysis) -> Iterator[str]:
    """Yield the names behind `via` that no joint declares, each once."""
    names = (str(child.joint) for body in analysis.model.bodies for child in body.children)
    yield from _missing(names, analysis.model.joint_named)


def body_at(context: CompletionContext) -> Link | None:
    """Return the link or base around the cursor, which may not be closed yet."""
    return _last_before(context, declarations(context.place.island).bodies())


def _joint_at(context: CompletionContext) -> Joint | None:
    return _last_before(context, declarations(context.place.island).joints)


def _last_before(context: CompletionContext, blocks: Iterable[_Block]) -> _Block | None:
    local = context.start - context.place.start
    return max((b for b in blocks if b.start < local), key=lambda b: b.start, default=None)


def _missing(names: Iterable[str], declared: Container[str]) -> Iterator[str]:
    yield from dict.fromkeys(name for name in names if name and name not in declared)
