"""Limbs in plain numbers, and which of a robot are meant to be alike."""

from collections.abc import Iterator, Mapping
from enum import Enum
from itertools import combinations
from typing import NamedTuple

from kindsl.limbs.names import is_held, label_of
from kindsl.mechanism.link_inertia import link_inertia
from kindsl.rigid.body import Symmetric
from kindsl.rigid.pose import Rotation, Vector3
from kindsl.semantics.declarations import Link
from kindsl.semantics.kinematic_tree import Edge
from kindsl.semantics.model import Model
from kindsl.semantics.numbers import triple, written_pose
from kindsl.semantics.unknown import Unknown

# No robot has more or longer ones that are written by hand, and comparing takes their square.
_MOST_LIMBS, MOST_BODIES = 12, 48

Side = tuple[object, ...]
Values = Mapping[str, float]


class Body(NamedTuple):
    """A link with the joint that supports it, and all that it carries.

    Attributes:
        name: The link's.
        joint: The supporting joint's name.
        kind: `revolute` or `prismatic`.
        rotation: Of the joint frame in the parent's frame.
        translation: The same, metres.
        angles: The rotation as written, radians.
        com: In the link frame, metres; None where it is not known.
        moments: `Ix Iy Iz Ixy Ixz Iyz` in the link frame, kg m²; None where they are not known.
        children: The bodies that it carries, in written order.
    """

    name: str
    joint: str
    kind: str
    rotation: Rotation
    translation: Vector3
    angles: Vector3
    com: Vector3 | None
    moments: Symmetric | None
    children: tuple["Body", ...]


class Limbs(NamedTuple):
    """Limbs of one carrier that are meant to be alike.

    Attributes:
        heads: The first body of each with its label: side and row, or its numbers.
        is_named: Whether sides and rows tell them apart, else numbers do.
    """

    heads: tuple[tuple[Side, Body], ...]
    is_named: bool

    def pairs(self) -> Iterator[tuple[Side, Side, str]]:
        """Yield two labels and how their limbs lie to each other: `LR`, `ROW` or `TURN`."""
        for one, other in combinations(sorted((side for side, _ in self.heads), key=repr), 2):
            if not self.is_named:
                yield one, other, "TURN"
            elif one[1] == other[1] and one[0] != other[0] and one[0] and other[0]:
                yield one, other, "LR"
            elif one[0] == other[0] and one[1] != other[1]:
                yield one, other, "ROW"


def limbs_of(carrier: Link, model: Model, values: Values) -> Iterator[Limbs]:
    """Yield the groups of limbs that a body carries, those left out whose numbers are not known.

    Args:
        carrier: The body.
        model: The robot.
        values: Of its parameters and constants.
    """
    groups: dict[tuple[bool, tuple[str, ...]], dict[Side, list[Edge]]] = {}
    edges = model.tree.successor_edges(carrier)
    for edge in edges if len(edges) > 1 else ():
        side, row, words = label_of(str(edge.child.link))
        is_named = bool(side or row)
        label: Side = (side, row) if is_named else tuple(int(w) for w in words if w.isdigit())
        if label:
            kept = tuple(word for word in words if is_named or not word.isdigit())
            groups.setdefault((is_named, kept), {}).setdefault(label, []).append(edge)
    for (is_named, _), by_label in groups.items():
        if 1 < len(by_label) <= _MOST_LIMBS:
            single = {label: found[0] for label, found in by_label.items() if len(found) == 1}
            limbs = {label: _limb(edge, model, values, []) for label, edge in single.items()}
            heads = tuple((label, head) for label, head in limbs.items() if head is not None)
            if len(heads) > 1:
                yield Limbs(heads, is_named)


def _limb(edge: Edge, model: Model, values: Values, seen: list[Link]) -> Body | None:
    """Return what an edge leads to, None where it has very many bodies or no numbers."""
    is_only = edge.link is not None and model.tree.supporting_edge(edge.link) is edge
    if edge.link is None or not is_only or len(seen) >= MOST_BODIES:
        return None
    seen.append(edge.link)
    children = []
    for each in model.tree.successor_edges(edge.link):
        child = _limb(each, model, values, seen)
        if child is None:
            return None
        children.append(child)
    return body_of(edge, values, tuple(children))


def body_of(edge: Edge, values: Values, children: tuple[Body, ...] = ()) -> Body | None:
    """Return a link with its joint in numbers, None where they are not known."""
    link, joint = edge.link, edge.joint
    pose = written_pose(joint.pose, values) if joint is not None else None
    angles = triple(joint.pose.rotation, values) if joint is not None else None
    if link is None or joint is None or pose is None or angles is None:
        return None
    inertia = link_inertia(link, values)
    com = None if isinstance(inertia, Unknown) else inertia.com
    moments = None if isinstance(inertia, Unknown) else inertia.moments
    names = str(link.name), str(joint.name)
    return Body(*names, joint.kind, *pose, angles, com, moments, children)


class Match(NamedTuple):
    """Two bodies that stand at the same place of two limbs.

    Attributes:
        up: The index of the row of their parents, -1 for the heads.
        one: The body of the first limb.
        other: The body of its twin.
    """

    up: int
    one: Body
    other: Body


class LimbPart(Enum):
    """The bodies of two limbs that are compared."""

    WHOLE = "all"
    BARE = "all but what they hold"
    HELD = "what these two bodies hold"


def rows_of(one: Body, other: Body, part: LimbPart) -> tuple[list[Match], bool]:
    """Return two limbs matched body by body, and whether they match to their ends."""
    rows = [Match(-1, one, other)]
    is_whole = True
    for index, row in enumerate(rows):
        is_head = row.up < 0
        matched = _matched(_chosen(row.one, part, is_head), _chosen(row.other, part, is_head))
        is_whole = is_whole and matched is not None
        rows += [Match(index, *pair) for pair in matched or ()]
    return rows, is_whole


def _chosen(body: Body, part: LimbPart, is_head: bool) -> list[Body]:
    if part is LimbPart.WHOLE or (part is LimbPart.HELD and not is_head):
        return list(body.children)
    return [c for c in body.children if is_held(c.name, c.joint) == (part is LimbPart.HELD)]


def _matched(ones: list[Body], others: list[Body]) -> list[tuple[Body, Body]] | None:
    if len(ones) != len(others):
        return None
    if len(ones) < 2:
        return list(zip(ones, others, strict=True))
    for with_numbers in (True, False):
        here, there = _by_words(ones, with_numbers), _by_words(others, with_numbers)
        if len(here) == len(ones) and set(here) == set(there):
            return [(here[words], there[words]) for words in here]
    return None


def _by_words(bodies: list[Body], with_numbers: bool) -> dict[tuple[str, ...], Body]:
    found = ((label_of(body.name).words, body) for body in bodies)
    return {tuple(w for w in words if with_numbers or not w.isdigit()): b for words, b in found}
