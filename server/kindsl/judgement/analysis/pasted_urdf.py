"""Elements of URDF in a document: the message, and the action that takes them over."""

import re
from collections.abc import Iterator

from kindsl.judgement.rules.base import Finding, Fix, Replacement
from kindsl.judgement.rules.inertia_writing import body_around, inertia_changes, new_inertia
from kindsl.language.semantics.declarations import Joint, Link
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.places import Located, Place, with_lines
from kindsl.language.syntax.indentation import indentation
from kindsl.language.text.phrases import listed
from kindsl.mechanics.rigid.body import MassDistribution
from kindsl.robots.cad.properties import MassProperties
from kindsl.robots.interchange.format import FormatError
from kindsl.robots.interchange.kindsl_writing import body_text, inertia_texts, joint_text, link_head
from kindsl.robots.interchange.portable_names import valid_name
from kindsl.robots.interchange.urdf.fragment import Fragment, fragment_of_urdf
from kindsl.robots.mechanism.linkage import RigidBody

_COMMENT = re.compile(r"<!--(.*?)-->", re.DOTALL)


class _NotTakenError(Exception):
    """Elements that cannot be taken over; the message is a sentence."""


def urdf_finding(model: Model, at: Place) -> Finding:
    """Return the finding of elements of URDF."""
    told = "elements of URDF"
    try:
        fragment = fragment_of_urdf(at.island.text[at.start : at.end])
        told = f"{_subject(fragment)} of URDF"
        changes = _with_comments(_changes(model, fragment, at), at)
    except (FormatError, _NotTakenError) as error:
        return Finding(at, f"{told} cannot be taken over: {error}")
    title = f"Take over {_subject(fragment)}"
    one = len(fragment.given_links) + len(fragment.given_joints) < 2
    fix = Fix(title, changes, is_safe=False)
    message = f"{told}: take {'it' if one else 'them'} over"
    limits = "; limits belong in kindsl.toml" if fragment.has_limits else ""
    return Finding(at, message + limits, fix=fix)


def _subject(fragment: Fragment) -> str:
    if fragment.inertial is not None:
        return "an inertia"
    names = [f"link '{link.name}'" for link in fragment.links if link.name in fragment.given_links]
    names += [f"joint '{name}'" for name in sorted(fragment.given_joints)]
    return listed(names)


def _changes(model: Model, fragment: Fragment, at: Place) -> tuple[Replacement, ...]:
    if fragment.inertial is not None:
        return _of_inertial(fragment.inertial, at)
    _check(model, fragment)
    new = [link for link in fragment.links if _name(link) not in model.body_named]
    changes = [Replacement(with_lines(at), "")]
    for link in fragment.links:
        known = model.body_named.get(_name(link))
        if known is not None and link.mass is not None:
            changes += new_inertia(known, _properties(link.mass))
    changes += _edges(model, fragment)
    last = [model.bodies[-1], model.joints[-1] if model.joints else model.bodies[-1]]
    texts = [list(_links(model, fragment, new)), list(_joints(fragment))]
    if any(_overlaps(change.at, at) for change in changes[1:]):
        raise _NotTakenError("it stands within what it would change")
    changes += _behind(last, texts)
    return tuple(changes)


def _overlaps(one: Located, other: Place) -> bool:
    is_near = one.start < other.end and other.start < one.end
    return one.island is other.island and is_near


def _with_comments(changes: tuple[Replacement, ...], at: Place) -> tuple[Replacement, ...]:
    """Return changes that leave the comments of the elements in place."""
    written = _COMMENT.findall(at.island.text[at.start : at.end])
    lines = [line.strip() for comment in written for line in comment.splitlines()]
    indent = indentation(at.island.text, at.start)
    kept = "".join(f"{indent}// {line}\n" for line in lines if line)
    first = next((c for c in changes if c.at.start <= at.start <= c.at.end), changes[0])
    with_them = first._replace(text=kept + first.text)
    return tuple(with_them if change is first else change for change in changes)


def _of_inertial(link: RigidBody, at: Place) -> tuple[Replacement, ...]:
    from kindsl.language.semantics.lowering import declarations

    declared = declarations(at.island)
    body = body_around((*declared.bases, *declared.links), at)
    if body is None:
        raise _NotTakenError("it belongs in a link")
    if link.mass is None:
        raise _NotTakenError("it has no mass")
    return inertia_changes(body, _properties(link.mass), at)


def _check(model: Model, fragment: Fragment) -> None:
    if not model.bodies:
        raise _NotTakenError("the document has no base yet")
    for link in fragment.links:
        name = _name(link)
        if name in model.body_named and link.frames:
            raise _NotTakenError(f"a fixed joint adds to link '{name}', use 'kindsl convert'")
        if link.joint in fragment.given_joints and valid_name(link.joint) in model.joint_named:
            raise _NotTakenError(f"joint '{link.joint}' is already defined")
    kept = {link.name for link in fragment.links}
    lumped = [name for name in fragment.given_links if name not in kept]
    stubs = [link for link in fragment.links if link.name not in fragment.given_links]
    if lumped and any(link.mass is not None or link.frames for link in stubs):
        raise _NotTakenError(f"link '{lumped[0]}' is fixed to one that is not given")


def _links(model: Model, fragment: Fragment, new: list[RigidBody]) -> Iterator[str]:
    number = 1 + max((link.id or 0 for link in model.links), default=0)
    for index, link in enumerate(fragment.links):
        is_child = link.joint in fragment.given_joints
        if link in new and (is_child or link.name in fragment.given_links):
            edges = [_edge(child) for child in fragment.links if child.parent == index]
            frames = [valid_name(frame.name) for frame in link.frames_elsewhere]
            yield body_text(link_head(_name(link), number), link, edges, frames)
            number += 1


def _joints(fragment: Fragment) -> Iterator[str]:
    for link in fragment.links:
        if link.joint in fragment.given_joints:
            yield joint_text(link, valid_name(link.joint))


def _edges(model: Model, fragment: Fragment) -> Iterator[Replacement]:
    """Yield changes that make links of the document parents of the new ones."""
    for index, link in enumerate(fragment.links):
        parent = model.body_named.get(_name(link))
        edges = [_edge(child) for child in fragment.links if child.parent == index]
        if parent is not None and edges:
            yield _carrying(parent, edges)


def _carrying(parent: Link, edges: list[str]) -> Replacement:
    section = next(parent.node.nodes("children"), None)
    text = parent.island.text
    if section is None:
        raise _NotTakenError(f"link '{parent.name}' has no children section")
    closing = section.end - 1
    before = text[: section.end - 1].rstrip()
    indent = indentation(text, section.start)
    lines = "".join(f"\n{indent}    {edge}" for edge in edges) + f"\n{indent}"
    return Replacement(Place(parent.island, len(before), closing), lines)


def _behind(last: list[Link | Joint], texts: list[list[str]]) -> Iterator[Replacement]:
    """Yield changes that write links and joints behind the last of their kind."""
    if last[0] is last[1]:
        last, texts = last[:1], [[*texts[0], *texts[1]]]
    for block, written in zip(last, texts, strict=True):
        if written:
            new = "".join(f"\n\n{text}" for text in written)
            yield Replacement(Place(block.island, block.end, block.end), new)


def _properties(body: MassDistribution) -> MassProperties:
    mass, com, *moments = inertia_texts(body)
    x, y, z = com.strip("()").split(", ")
    a, b, c, d, e, f = moments
    return MassProperties("URDF", mass, (x, y, z), (a, b, c, d, e, f))


def _name(link: RigidBody) -> str:
    return valid_name(link.name)


def _edge(link: RigidBody) -> str:
    return f"{_name(link)} via {valid_name(link.joint)}"
