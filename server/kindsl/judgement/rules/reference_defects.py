"""Wrong references, each mistake counted once.

A wrong reference leaves something else without a reference: who writes `foream via elbow` has an
undefined link `foream`, and also a link `forearm` that nothing carries. Only the first is the
mistake. So each wrong reference here excuses one orphan, the one with the most similar name first,
and a link that is missing altogether excuses all: it may carry them. A wrong link in a pair, which
may close a loop, excuses no joint, and no link where a joint is left over besides.
"""

from collections.abc import Sequence
from typing import NamedTuple, TypeVar

from kindsl.judgement.rules.broken_text import is_cut_off
from kindsl.judgement.rules.duplicates import repeated_names
from kindsl.language.semantics.declarations import Joint, Link
from kindsl.language.semantics.kinematic_tree import Edge
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.places import Name, has_problem_within
from kindsl.language.text.facts import kept
from kindsl.language.text.nearest import nearest_name

# A document in which more is lost has no slips in names.
MOST_SUGGESTIONS = 20
_Thing = TypeVar("_Thing", Link, Joint)


class ReferenceDefects(NamedTuple):
    """The defects of parents and children.

    Attributes:
        swapped: Pairs that name a joint for the link and a link for the joint.
        loops: Kinematic loops, each as the edges around it.
        repeated: Pairs whose link the same body carries already, after the first such pair.
        extra_parents: Pairs whose link another body carries already, after the first such pair.
        reused_joints: Pairs whose joint another pair has already, after the first such pair.
        unused_joints: Joints that no pair names, and no wrong pair can mean.
        orphans: Links that no pair names, and no wrong pair can mean.
        idle_joints: All joints that no pair names.
        idle_links: All links that no pair names.
    """

    undefined_links: list[Edge]
    undefined_joints: list[Edge]
    swapped: list[Edge]
    bases: list[Edge]
    loops: list[tuple[Edge, ...]]
    repeated: list[tuple[Edge, Edge]]
    extra_parents: list[tuple[Edge, Edge]]
    reused_joints: list[tuple[Edge, Edge]]
    unused_joints: list[Joint]
    orphans: list[Link]
    idle_joints: list[Joint]
    idle_links: list[Link]


@kept
def reference_defects(model: Model) -> ReferenceDefects:
    """Return the wrong references of a model; computed once in its life."""
    found = ReferenceDefects(*([] for _ in ReferenceDefects._fields))
    for edge in model.tree.edges:
        if edge.link is None or edge.joint is None or edge.link.is_base:
            _classify(model, edge, found)
    found.loops.extend(
        loop for loop in model.tree.loops if not any(edge.link in model.bases for edge in loop)
    )
    if len(model.tree.above) < len(model.tree.edges):
        _collect_repetitions(model, found)
    if len(model.tree.joint_uses) < len(model.tree.edges):
        _collect_reuses(model, found)
    if model.base is not None:
        _collect_orphans(model, found)
    _excuse_duplicates(model, found)
    return found


def _classify(model: Model, edge: Edge, found: ReferenceDefects) -> None:
    link, joint = edge.child.link, edge.child.joint
    if edge.link is not None and edge.link.is_base and not any(t.name == link for t in model.links):
        found.bases.append(edge)
    is_unknown = edge.link is None and edge.joint is None
    if is_unknown and link in model.joint_named and joint in model.body_named:
        found.swapped.append(edge)
        return
    if not link or not joint or has_problem_within(edge.child):
        return
    if edge.link is None and not _may_be_lost(model, link, edge, model.links):
        found.undefined_links.append(edge)
    if edge.joint is None and not _may_be_lost(model, joint, edge, model.joints):
        found.undefined_joints.append(edge)


def _may_be_lost(model: Model, name: str, edge: Edge, things: Sequence[Link | Joint]) -> bool:
    """Return whether the declaration that is meant may stand where the syntax is broken."""
    if not things or is_cut_off(model):
        return True
    return bool(model.broken_islands) and (
        model.is_mentioned_in_broken_text(name, edge.child.island)
        or any(not thing.name for thing in things)
    )


def _collect_repetitions(model: Model, found: ReferenceDefects) -> None:
    on_loops = {id(edge.child) for loop in found.loops for edge in loop}
    for link, edges in model.tree.above.items():
        if link.is_base:
            continue
        first = next((edge for edge in edges if id(edge.child) not in on_loops), None)
        carriers: dict[Link, Edge] = {}
        for edge in edges:
            if model.body_named.get(edge.predecessor.name) is not edge.predecessor:
                continue
            known = carriers.setdefault(edge.predecessor, edge)
            if known is not edge:
                found.repeated.append((known, edge))
            elif first is not None and edge is not first and id(edge.child) not in on_loops:
                found.extra_parents.append((first, edge))


def _collect_reuses(model: Model, found: ReferenceDefects) -> None:
    reported = {id(edge.child) for _, edge in (*found.repeated, *found.extra_parents)}
    reported |= {id(loop[-1].child) for loop in found.loops}
    reported |= {id(edge.child) for edge in found.bases}
    twins = {again for _, again in repeated_names(model.bodies)}
    ambiguous = {str(again.name) for _, again in repeated_names(model.joints)}
    for edges in model.tree.joint_uses.values():
        if edges[0].child.joint not in ambiguous:
            found.reused_joints.extend(
                (edges[0], edge)
                for edge in edges[1:]
                if id(edge.child) not in reported and edge.predecessor not in twins
            )


def _collect_orphans(model: Model, found: ReferenceDefects) -> None:
    tree = model.tree
    found.idle_links.extend(
        link
        for link in model.links
        if link.name and link not in tree.above and model.body_named[link.name] is link
    )
    found.idle_joints.extend(
        joint
        for joint in model.joints
        if joint.name and joint not in tree.joint_uses and model.joint_named[joint.name] is joint
    )
    if found.undefined_links or not (found.idle_links or found.idle_joints):
        return
    misnamed, pasted = _wrong_pairs(model, found)
    links = [link for link in found.idle_links if not _is_mentioned(model, link)]
    joints = [joint for joint in found.idle_joints if not _is_mentioned(model, joint)]
    wrong_joints = [str(edge.child.joint) for edge in found.undefined_joints]
    wrong_joints += [str(edge.child.link) for edge in found.swapped]
    # A joint that is left over shows that a pair is missing: no wrong name in a pair explains it.
    missing = max(0, len(joints) - len(wrong_joints) - pasted - len(found.reused_joints))
    wrong_links = [str(edge.child.joint) for edge in found.swapped]
    excused = pasted + min(misnamed, max(0, len(links) - missing))
    found.orphans.extend(_unexcused(links, wrong_links, excused))
    excused = pasted + len(found.reused_joints) + len(found.orphans)
    excused += len(repeated_names(model.bodies))
    found.unused_joints.extend(_unexcused(joints, wrong_joints, excused))


def _wrong_pairs(model: Model, found: ReferenceDefects) -> tuple[int, int]:
    """Return how many pairs name a wrong link, and how many are wrong as a whole: pasted, say.

    The latter have a joint that another pair has as well; they leave a link and a joint over.
    """
    groups = [(edge,) for edge in found.bases]
    groups += [(again,) for _, again in (*found.repeated, *found.extra_parents)]
    uses = model.tree.joint_uses
    pasted = sum(
        any(edge.joint is not None and len(uses[edge.joint]) > 1 for edge in edges)
        for edges in (*groups, *found.loops)
    )
    return len(groups) + len(found.loops) - pasted, pasted


def _is_mentioned(model: Model, thing: Link | Joint) -> bool:
    return bool(model.broken_islands) and (
        model.is_mentioned_in_broken_text(thing.name, thing.island)
        or any(not edge.child.link or not edge.child.joint for edge in model.tree.edges)
    )


def _unexcused(things: list[_Thing], wrong: list[str], others: int) -> list[_Thing]:
    """Return the things left when each wrong reference has excused one of them."""
    left = dict.fromkeys(things)
    by_name = {str(thing.name): thing for thing in things}
    for name in wrong[:MOST_SUGGESTIONS]:
        meant = name if name in by_name else nearest_name(name, by_name)
        if meant is not None:
            left.pop(by_name.pop(meant), None)
    excused = max(0, len(wrong) + others - (len(things) - len(left)))
    return list(left)[excused:]


def _excuse_duplicates(model: Model, found: ReferenceDefects) -> None:
    if found.undefined_links:
        names = [edge.child.link for edge in found.undefined_links]
        _excuse(found.undefined_links, names, len(repeated_names(model.links)))
    if found.undefined_joints:
        names = [edge.child.joint for edge in found.undefined_joints]
        _excuse(found.undefined_joints, names, len(repeated_names(model.joints)))


def _excuse(undefined: list[Edge], names: list[Name], n_repeated: int) -> None:
    """Drop undefined names that a declaration with a repeated name can be meant to have."""
    excused = set(list(dict.fromkeys(names))[:n_repeated])
    pairs = zip(undefined, names, strict=True)
    undefined[:] = [edge for edge, name in pairs if name not in excused]
