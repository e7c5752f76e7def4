"""Completions of names: those that fit a place, and new ones like the existing."""

from collections.abc import Collection, Container, Iterable, Iterator, Sequence
from itertools import count
from typing import NamedTuple

from kindsl.frontends.features.completion import snippets
from kindsl.frontends.features.completion.context import CompletionContext
from kindsl.frontends.features.completion.item import CompletionItem
from kindsl.frontends.features.names_taken import names_taken
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.semantics.declarations import Link
from kindsl.language.semantics.lowering import declarations


def fresh_link(analysis: Analysis) -> str:
    """Return a name for a new link: `link4` after `link3`."""
    return _fresh([link.name for link in analysis.model.links], "link", names_taken(analysis.model))


def fresh_joint(analysis: Analysis, child: str = "") -> str:
    """Return a name for a new joint: `joint4` after `joint3`, otherwise named after its child."""
    names: list[str] = [joint.name for joint in analysis.model.joints]
    names += [child.joint for body in analysis.model.bodies for child in body.children]
    stem = f"{child}_joint" if child and names else "joint"
    return _fresh(names, stem, names_taken(analysis.model))


def next_id(analysis: Analysis, own: Collection[Link] = ()) -> int:
    """Return the smallest free id; the ids of `own` count as free."""
    taken = {link.id for link in analysis.model.links if link not in own}
    return next(number for number in count(1) if number not in taken)


def _fresh(names: Sequence[str], stem: str, taken: Collection[str]) -> str:
    """Return the next name of the last numbered ones, else the stem, with a number if need be."""
    first = 1
    last = next(filter(_is_numbered, reversed(names)), "")
    if last:
        stem = last
        while _is_numbered(stem):
            stem = stem[:-1]
        ends = [name[len(stem) :] for name in set(names) if name.startswith(stem)]
        first = 1 + max(map(int, filter(str.isdecimal, ends)))
    elif stem not in ("link", "joint") and stem not in taken:
        return stem
    numbered = (f"{stem}{number}" for number in count(first))
    return next(name for name in numbered if name not in taken)


def _is_numbered(name: str) -> bool:
    return name[-1:].isdecimal()


def name_items(names: Iterable[str], kind: str, detail: str) -> Iterator[CompletionItem]:
    """Yield names as they are."""
    for name in names:
        yield CompletionItem(name, kind, name, detail)


def new_frame_items(context: CompletionContext) -> Iterator[CompletionItem]:
    """Yield a new frame, and the undeclared frame that the inertia is given in."""
    inertias = [body.inertia for body in bodies_at(context) if body.inertia is not None]
    frames = (str(inertia.frame) for inertia in inertias if inertia.frame is not None)
    for name in _missing(frames, frame_names_at(context)):
        text = snippets.frame(name)
        yield CompletionItem(name, "frame", text, "used, not declared")
    text = snippets.frame()
    yield CompletionItem("frame", "snippet", text, "a frame of this link", is_asked_for=True)


def id_items(analysis: Analysis, context: CompletionContext) -> Iterator[CompletionItem]:
    """Yield the number that a link or joint is to have; unasked it would swallow a quick Enter."""
    if context.block == "joint":
        number, detail = joint_id(analysis, context), "id of its link"
    else:
        number, detail = next_id(analysis, bodies_at(context)), "next free id"
    yield CompletionItem(str(number), "value", str(number), detail, is_asked_for=True)


def joint_id(analysis: Analysis, context: CompletionContext) -> int:
    """Return the id for the joint around the cursor: its link's, if known."""
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
    """Yield the undeclared names after `via`, each once."""
    names = (str(child.joint) for body in analysis.model.bodies for child in body.children)
    yield from _missing(names, analysis.model.joint_named)


def bodies_at(context: CompletionContext) -> tuple[Link, ...]:
    """Return the link or base around the cursor, closed or not; in broken text several."""
    return tuple(declarations(context.place.island).bodies())


def frame_names_at(context: CompletionContext) -> list[str]:
    """Return the names of the frames of the link around the cursor."""
    return [str(frame.name) for body in bodies_at(context) for frame in body.frames]


def _missing(names: Iterable[str], declared: Container[str]) -> Iterator[str]:
    yield from dict.fromkeys(name for name in names if name and name not in declared)


class _Uses(NamedTuple):
    """The children of all bodies, without the child that is being typed.

    Attributes:
        parents: The name of the body that carries a link, by the link's name.
        moved: The name of the link that a joint moves, by the joint's name.
    """

    parents: dict[str, str]
    moved: dict[str, str]


def child_items(analysis: Analysis, context: CompletionContext) -> Iterator[CompletionItem]:
    """Yield possible children, unattached ones first; none that would close a loop."""
    uses = _uses(analysis, context)
    free = _free_joint(analysis, uses)
    fitting = list(_fitting(analysis, context, uses))
    loose = [name for name in fitting if name not in uses.parents]
    for name in loose:
        joint = free or fresh_joint(analysis, name)
        text, label = f"{name} via ${{1:{joint}}}", f"{name} via …"
        yield CompletionItem(label, "snippet", text, "not yet attached")
    yield from name_items(loose, "link", "not yet attached")
    link, new = fresh_link(analysis), free or fresh_joint(analysis)
    text, label = f"${{1:{link}}} via ${{2:{new}}}", f"{link} via {new}"
    yield CompletionItem(label, "snippet", text, "new child", is_asked_for=True)
    for name in fitting:
        if name in uses.parents:
            detail = f"child of {uses.parents[name]} already"
            yield CompletionItem(name, "link", name, detail, is_asked_for=True)


def joint_items(analysis: Analysis, context: CompletionContext) -> Iterator[CompletionItem]:
    """Yield unused joints, a new one if there are none, then the others."""
    moved = _uses(analysis, context).moved
    joints = {str(joint.name): joint.kind for joint in analysis.model.joints if joint.name}
    for name, kind in joints.items():
        if name not in moved:
            yield CompletionItem(name, "joint", name, f"{kind}, free")
    if moved.keys() >= joints.keys():
        local = context.start - context.place.start
        before = [t for t in context.place.island.tokens if t.end <= local and not t.is_missing]
        name = fresh_joint(analysis, before[-2].text)
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
