"""Completions in `children`: links to carry and the joints that move them."""

from collections.abc import Iterator
from typing import NamedTuple

from kindsl.frontends.features.completion.context import CompletionContext
from kindsl.frontends.features.completion.fitting_names import bodies_at
from kindsl.frontends.features.completion.fresh_names import fresh_joint, fresh_link
from kindsl.frontends.features.completion.item import CompletionItem
from kindsl.judgement.analysis.analysis import Analysis


class _Uses(NamedTuple):
    """The children of all bodies, without the child that is being typed.

    Attributes:
        parents: The name of the body that carries a link, by the link's name.
        moved: The name of the link that a joint moves, by the joint's name.
    """

    parents: dict[str, str]
    moved: dict[str, str]


def child_items(analysis: Analysis, context: CompletionContext) -> Iterator[CompletionItem]:
    """Yield links to carry, never one that would close a loop: those that nothing carries first."""
    uses = _uses(analysis, context)
    free = _free_joint(analysis, uses)
    fitting = list(_fitting(analysis, context, uses))
    loose = [name for name in fitting if name not in uses.parents]
    for name in loose:
        joint = free or fresh_joint(analysis, name)
        text, label = f"{name} via ${{1:{joint}}}", f"{name} via …"
        yield CompletionItem(label, "snippet", text, "not yet attached", is_snippet=True)
    for name in loose:
        yield CompletionItem(name, "link", name, "not yet attached")
    yield _new_child(analysis, free)
    for name in fitting:
        if name in uses.parents:
            detail = f"child of {uses.parents[name]} already"
            yield CompletionItem(name, "link", name, detail, is_asked_for=True)


def joint_items(analysis: Analysis, context: CompletionContext) -> Iterator[CompletionItem]:
    """Yield joints: those that connect nothing yet, a new one if all do, then the others."""
    moved = _uses(analysis, context).moved
    joints = {str(joint.name): joint.kind for joint in analysis.model.joints if joint.name}
    for name, kind in joints.items():
        if name not in moved:
            yield CompletionItem(name, "joint", name, f"{kind}, free")
    if moved.keys() >= joints.keys():
        name = fresh_joint(analysis, _child_before(context))
        yield CompletionItem(name, "joint", name, "new joint", is_asked_for=True)
    for name, kind in joints.items():
        if name in moved:
            detail = f"{kind}, moves {moved[name]} already"
            yield CompletionItem(name, "joint", name, detail, is_asked_for=True)


def first_child(analysis: Analysis, context: CompletionContext) -> tuple[str, str]:
    """Return the link that comes first to mind as a child of the one at the cursor, and its joint.

    Both are new names where nothing is free.
    """
    uses = _uses(analysis, context)
    fitting = _fitting(analysis, context, uses)
    link = next((name for name in fitting if name not in uses.parents), "")
    joint = _free_joint(analysis, uses) or fresh_joint(analysis, link)
    return link or fresh_link(analysis), joint


def _new_child(analysis: Analysis, free_joint: str) -> CompletionItem:
    link, joint = fresh_link(analysis), free_joint or fresh_joint(analysis)
    text, label = f"${{1:{link}}} via ${{2:{joint}}}", f"{link} via {joint}"
    return CompletionItem(label, "snippet", text, "new child", is_snippet=True, is_asked_for=True)


def _uses(analysis: Analysis, context: CompletionContext) -> _Uses:
    local = context.start - context.place.start
    own = (child for body in bodies_at(context) for child in body.children)
    typed = next((c for c in own if any(name.start == local for name in c)), None)
    uses = _Uses({}, {})
    for body in analysis.model.bodies:
        for child in body.children:
            if child is not typed:
                uses.parents.setdefault(child.link, body.name)
                uses.moved.setdefault(child.joint, child.link)
    return uses


def _fitting(analysis: Analysis, context: CompletionContext, uses: _Uses) -> Iterator[str]:
    """Yield the links that the one at the cursor may carry: neither itself nor one above it."""
    name = next((str(body.name) for body in bodies_at(context)), "")
    above: set[str] = set()
    while name and name not in above:
        above.add(name)
        name = uses.parents.get(name, "")
    names = (str(link.name) for link in analysis.model.links)
    return (name for name in names if name and name not in above)


def _free_joint(analysis: Analysis, uses: _Uses) -> str:
    names = (joint.name for joint in analysis.model.joints)
    return str(next((name for name in names if name and name not in uses.moved), ""))


def _child_before(context: CompletionContext) -> str:
    """Return the name of the link that a joint is typed for."""
    local = context.start - context.place.start
    tokens = [t for t in context.place.island.tokens if t.end <= local and not t.is_missing]
    return tokens[-2].text
