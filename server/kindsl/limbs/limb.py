"""Limbs in plain numbers, and which of a robot are meant to be alike."""

from collections.abc import Iterator, Mapping
from enum import Enum
from typing import NamedTuple

from kindsl.limbs.names import is_held, label_of
from kindsl.rigid.body import Symmetric
from kindsl.rigid.pose import RigidPose, Rotation, Vector3
from kindsl.semantics.declarations import Link
from kindsl.semantics.kinematic_tree import Edge
from kindsl.semantics.model import Model
from kindsl.semantics.numbers import mass_distribution, triple, written_pose

# No robot has more or longer ones that are written by hand, and comparing takes their square.
_MOST_LIMBS = 12
_MOST_BODIES = 48

Side = tuple[object, ...]


class Body(NamedTuple):
    """A link with the joint that supports it, and all that it carries.

    Attributes:
        name: The link's.
        joint: The supporting joint's name.
        kind: `revolute` or `prismatic`.
        pose: Of the joint frame in the parent's frame, metres.
        angles: The rotation as written, radians.
        com: In the link frame, metres; None where it is not known.
        moments: `Ix Iy Iz Ixy Ixz Iyz` in the link frame, kg m²; None where they are not known.
        children: The bodies that it carries, in written order.
    """

    name: str
    joint: str
    kind: str
    pose: RigidPose
    angles: Vector3
    com: Vector3 | None
    moments: Symmetric | None
    children: tuple["Body", ...]

    @property
    def translation(self) -> Vector3:
        """Of the joint frame in the parent's frame, metres."""
        return self.pose.translation

    @property
    def rotation(self) -> Rotation:
        """Of the joint frame, as a matrix."""
        return self.pose.rotation


class Limbs(NamedTuple):
    """Limbs of one carrier that are meant to be alike.

    Attributes:
        heads: The first body of each by its label: side and row, or its numbers.
        is_named: Whether sides and rows tell them apart, else numbers do.
    """

    heads: dict[Side, Body]
    is_named: bool

    def pairs(self) -> Iterator[tuple[Side, Side, str]]:
        """Yield two labels and how their limbs lie to each other: `LR`, `ROW` or `TURN`."""
        labels = sorted(self.heads, key=repr)
        for index, one in enumerate(labels):
            for other in labels[index + 1 :]:
                if not self.is_named:
                    yield one, other, "TURN"
                elif one[1] == other[1] and one[0] != other[0] and one[0] and other[0]:
                    yield one, other, "LR"
                elif one[0] == other[0] and one[1] != other[1]:
                    yield one, other, "ROW"


def limbs_of(carrier: Link, model: Model, values: Mapping[str, float]) -> Iterator[Limbs]:
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
            limbs = {label: _limb(edge, model, values) for label, edge in single.items()}
            heads = {label: head for label, head in limbs.items() if head is not None}
            if len(heads) > 1:
                yield Limbs(heads, is_named)


def _limb(head: Edge, model: Model, values: Mapping[str, float]) -> Body | None:
    """Return what an edge leads to, None where it has very many bodies or no numbers."""
    edges = [head]
    for edge in edges:
        if edge.link is None or len(edges) > _MOST_BODIES:
            return None
        edges += model.tree.successor_edges(edge.link)
    made: dict[Link, list[Body]] = {}
    for edge in reversed(edges):
        body = _body(edge, tuple(reversed(made.get(edge.link, ()))), model, values)  # type: ignore[arg-type]
        if body is None:
            return None
        made.setdefault(edge.predecessor, []).append(body)
    return made[head.predecessor][0]


def _body(
    edge: Edge, children: tuple[Body, ...], model: Model, values: Mapping[str, float]
) -> Body | None:
    link, joint = edge.link, edge.joint
    if link is None or joint is None or model.tree.supporting_edge(link) is not edge:
        return None
    pose, angles = written_pose(joint.pose, values), triple(joint.pose.rotation, values)
    if pose is None or angles is None:
        return None
    com, moments = _inertia(link, values)
    names = str(link.name), str(joint.name)
    return Body(*names, joint.kind, pose, angles, com, moments, children)


def _inertia(link: Link, values: Mapping[str, float]) -> tuple[Vector3 | None, Symmetric | None]:
    """Return CoM and moments in the link frame; of a frame of their own the CoM only."""
    inertia = link.inertia
    written = mass_distribution(inertia, values) if inertia is not None else None
    if inertia is None or written is None:
        return None, None
    if inertia.frame is None:
        return written.com, written.moments
    frame = next((frame for frame in link.frames if frame.name == inertia.frame), None)
    place = written_pose(frame.pose, values) if frame is not None else None
    return (place.point(written.com) if place is not None else None), None


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
    """Which bodies of two limbs are compared."""

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
    for key in (_words, _words_without_numbers):
        here, there = {key(b): b for b in ones}, {key(b): b for b in others}
        if len(here) == len(ones) and set(here) == set(there):
            return [(here[k], there[k]) for k in here]
    return None


def _words(body: Body) -> tuple[str, ...]:
    return label_of(body.name).words


def _words_without_numbers(body: Body) -> tuple[str, ...]:
    return tuple(word for word in _words(body) if not word.isdigit())
