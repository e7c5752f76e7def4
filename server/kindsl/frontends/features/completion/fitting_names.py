"""Names that fit a place: own frames, and new ones that are used already and not declared."""

from collections.abc import Container, Iterable, Iterator
from itertools import count

from kindsl.frontends.features.completion import snippets
from kindsl.frontends.features.completion.context import CompletionContext
from kindsl.frontends.features.completion.fresh_names import next_id
from kindsl.frontends.features.completion.item import CompletionItem
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.semantics.declarations import Link
from kindsl.language.semantics.lowering import declarations


def own_frame_items(context: CompletionContext) -> Iterator[CompletionItem]:
    """Yield the frames of the link around the cursor."""
    for name in _frame_names(context):
        yield CompletionItem(name, "frame", name, "frame of this link")


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
    inertias = [body.inertia for body in bodies_at(context) if body.inertia is not None]
    frames = (str(inertia.frame) for inertia in inertias if inertia.frame is not None)
    for name in _missing(frames, _frame_names(context)):
        text = snippets.frame(name)
        yield CompletionItem(name, "frame", text, "used, not declared", is_snippet=True)
    text = snippets.frame()
    yield CompletionItem(
        "frame", "snippet", text, "a frame of this link", is_snippet=True, is_asked_for=True
    )


def id_items(analysis: Analysis, context: CompletionContext) -> Iterator[CompletionItem]:
    """Yield the number that a link or joint is to have; unasked it would swallow a quick Enter."""
    if context.block == "joint":
        number, detail = joint_id(analysis, context), "id of its link"
    else:
        number, detail = next_id(analysis, bodies_at(context)), "next free id"
    yield CompletionItem(str(number), "value", str(number), detail, is_asked_for=True)


def joint_id(analysis: Analysis, context: CompletionContext) -> int:
    """Return the number for the joint around the cursor: that of the link it moves, if known."""
    own = declarations(context.place.island).joints
    names = {str(joint.name) for joint in own}
    children = (child for body in analysis.model.bodies for child in body.children)
    moved = next((str(child.link) for child in children if child.joint in names), "")
    link = analysis.model.body_named.get(moved)
    taken = {joint.id for joint in analysis.model.joints if joint not in own}
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


def bodies_at(context: CompletionContext) -> tuple[Link, ...]:
    """Return the link or base around the cursor, closed or not; in broken text several."""
    return tuple(declarations(context.place.island).bodies())


def _frame_names(context: CompletionContext) -> list[str]:
    return [str(frame.name) for body in bodies_at(context) for frame in body.frames]


def _missing(names: Iterable[str], declared: Container[str]) -> Iterator[str]:
    yield from dict.fromkeys(name for name in names if name and name not in declared)
