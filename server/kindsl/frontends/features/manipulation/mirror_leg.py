"""Write the right leg that mirrors the left one, or the reverse.

Mirrored in the plane of x and z of what carries the leg, with each frame mirrored in its own: then
every number stays, but for the signs of y, of the turns about x and z, and of Ixy and Iyz. A
mirrored revolute joint turns the other way, a mirrored prismatic joint slides alike.
"""

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from kindsl.frontends.features.manipulation.gesture import Gesture, Refusal
from kindsl.frontends.features.manipulation.new_blocks import behind_last, next_id, with_child
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.judgement.rules.number_writing import opposite
from kindsl.language.semantics.declarations import Child, Link, Pose, Vector
from kindsl.language.semantics.expressions import Expression
from kindsl.language.semantics.kinematic_tree import Edge
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.places import Construct, Name
from kindsl.language.text.edits import TextEdit, apply_edits
from kindsl.robots.limbs.names import other_side

_MIRRORED_PRODUCTS = ("Ixy", "Iyz")


class _Leg(NamedTuple):
    """A link with all that it carries, and the names on the other side."""

    edge: Edge
    links: Sequence[Link]
    children: Sequence[Child]
    names: Mapping[str, str]


def can_mirror(model: Model, link: str) -> bool:
    """Return whether a link and all that it carries have names of a side, and the other is free."""
    return isinstance(_leg(model, link), _Leg)


def mirror_leg(analysis: Analysis, link: str) -> Gesture | Refusal:
    """Return the edits that add the counterpart of a link with all that it carries."""
    model = analysis.model
    leg = _leg(model, link)
    if isinstance(leg, Refusal):
        return leg
    edge, names = leg.edge, leg.names
    joints = [model.joint_named[child.joint] for child in leg.children]
    head = names[link], names[edge.child.joint]
    is_listed = head in edge.predecessor.children
    listed = with_child(analysis, edge.predecessor, *head)
    ids = enumerate(leg.links, next_id(model))
    new_links = [_mirrored_link(body, names, number) for number, body in ids]
    new_joints = [
        _rewritten(joint, [_renamed(joint.name, names), *_mirrored_pose(joint.pose)])
        for joint in joints
    ]
    linked = behind_last(analysis, model.links, new_links)
    jointed = behind_last(analysis, model.joints, new_joints)
    if listed is None:
        return Refusal(f"link '{link}' is not whole")
    title = f"Mirror '{link}' as '{names[link]}'"
    edits = (linked, jointed) if is_listed else (listed, linked, jointed)
    return Gesture(title, tuple(sorted(edits)), tuple(names.values()))


def _leg(model: Model, link: str) -> _Leg | Refusal:
    edge = next((each for each in model.tree.edges if each.child.link == link), None)
    if edge is None or edge.link is None:
        return Refusal(f"there is no link '{link}' with a supporting joint")
    links = [edge.link, *model.tree.in_topological_order(edge.link)]
    children = [edge.child, *(child for body in links for child in body.children)]
    names = _mirrored_names(model, links, children)
    if isinstance(names, Refusal):
        return names
    image = names[edge.child.link], names[edge.child.joint]
    for body in model.bodies:
        for child in body.children:
            is_image = body is edge.predecessor and child == image
            if not is_image and not {*names.values()}.isdisjoint(child):
                return Refusal(f"'{body.name}' has '{child.link} via {child.joint}' already")
    return _Leg(edge, links, children, names)


def _mirrored_names(
    model: Model, links: Sequence[Link], children: Sequence[Child]
) -> dict[str, str] | Refusal:
    """Return the new names of all links, joints and frames of a leg; none may be taken."""
    own = [str(child.link) for child in children] + [str(child.joint) for child in children]
    own += [str(frame.name) for link in links for frame in link.frames]
    names: dict[str, str] = {}
    for name in own:
        other = other_side(name)
        if other is None:
            return Refusal(f"the name '{name}' tells no side, such as 'LF' or 'left'")
        names[name] = other
    lost = [child.link for child in children if child.link not in model.body_named]
    lost += [child.joint for child in children if child.joint not in model.joint_named]
    if lost:
        return Refusal(f"'{lost[0]}' is not defined")
    taken = {*model.body_named, *model.joint_named, *(str(frame.name) for frame in model.frames)}
    clash = next((name for name in names.values() if name in taken), None)
    return Refusal(f"'{clash}' is already defined") if clash is not None else names


def _mirrored_link(link: Link, names: Mapping[str, str], number: int) -> str:
    changes = [_renamed(link.name, names)]
    if link.id_place is not None:
        changes.append(TextEdit(link.id_place.start, link.id_place.end, str(number)))
    for child in link.children:
        changes += [_renamed(child.link, names), _renamed(child.joint, names)]
    for frame in link.frames:
        changes += [_renamed(frame.name, names), *_mirrored_pose(frame.pose)]
    inertia = link.inertia
    if inertia is not None:
        changes += _negated(inertia.com, (1,))
        products = [inertia.moments[name] for name in _MIRRORED_PRODUCTS if name in inertia.moments]
        changes += [_negative(product) for product in products]
        changes += [_renamed(inertia.frame, names)] if inertia.frame is not None else []
    return _rewritten(link, changes)


def _mirrored_pose(pose: Pose) -> Iterator[TextEdit]:
    yield from _negated(pose.translation, (1,))
    yield from _negated(pose.rotation, (0, 2))


def _negated(vector: Vector | None, axes: Sequence[int]) -> Iterator[TextEdit]:
    if vector is not None:
        yield from (_negative(vector.components[axis]) for axis in axes)


def _negative(value: Expression) -> TextEdit:
    return TextEdit(value.start, value.end, opposite(value))


def _renamed(name: Name, names: Mapping[str, str]) -> TextEdit:
    return TextEdit(name.start, name.end, names.get(str(name), str(name)))


def _rewritten(block: Construct, changes: Sequence[TextEdit]) -> str:
    """Return the text of a block after changes given in its island's offsets."""
    moved = [TextEdit(e.start - block.start, e.end - block.start, e.text) for e in changes]
    return apply_edits(block.island.text[block.start : block.end], sorted(moved))
