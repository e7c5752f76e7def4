"""Bodies with their supporting joints in plain numbers, and which limbs are meant to be alike."""

from collections.abc import Iterator, Mapping, Sequence
from enum import Enum
from typing import NamedTuple

from kindsl.limbs.names import is_held, label_of
from kindsl.rigid.body import Symmetric
from kindsl.rigid.pose import Rotation, Vector3, pose_from
from kindsl.semantics.declarations import Link
from kindsl.semantics.model import Model
from kindsl.semantics.numbers import mass_distribution, triple, written_pose

ORIGIN: Vector3 = (0.0, 0.0, 0.0)
Side = tuple[object, ...]
Heads = dict[Side, "list[Body]"]


class Body:
    """A link with the joint that supports it, as written.

    Attributes:
        name: The link's.
        parent: The name of the parent link, empty for the base.
        joint: The supporting joint's name, empty for the base.
        kind: `revolute` or `prismatic`.
        translation: Of the joint frame in the parent's frame, metres.
        angles: Of the joint frame, radians.
        rotation: The same as a matrix.
        com: In the link frame, metres; None where it is not known.
        moments: `Ix Iy Iz Ixy Ixz Iyz` in the link frame, kg m²; None where they are not known.
        children: The bodies that it carries, in written order.
    """

    __slots__ = (
        "angles", "children", "com", "joint", "kind", "moments", "name", "parent", "rotation",
        "translation",
    )  # fmt: skip

    def __init__(
        self,
        names: tuple[str, str, str],
        kind: str,
        pose: tuple[Vector3, Vector3],
        inertia: tuple[Vector3 | None, Symmetric | None],
    ) -> None:
        self.name, self.parent, self.joint = names
        self.kind = kind
        self.translation, self.angles = pose
        self.rotation: Rotation = pose_from(ORIGIN, self.angles).rotation
        self.com, self.moments = inertia
        self.children: list[Body] = []

    @property
    def key(self) -> tuple[object, ...]:
        """Everything but the children, to be compared."""
        here = self.name, self.parent, self.joint, self.kind
        return *here, self.translation, self.angles, self.com, self.moments


def bodies_of(model: Model, values: Mapping[str, float]) -> list[Body]:
    """Return the bodies of a robot, parents first, those without a known pose and theirs left out.

    Args:
        model: The robot.
        values: Of its parameters and constants.
    """
    if model.base is None:
        return []
    base = Body((str(model.base.name), "", ""), "", (ORIGIN, ORIGIN), (None, None))
    found: dict[Link, Body] = {model.base: base}
    for link in model.tree.in_topological_order(model.base):
        edge = model.tree.supporting_edge(link)
        parent = found.get(edge.predecessor) if edge is not None else None
        if edge is None or edge.joint is None or parent is None:
            continue
        pose = edge.joint.pose
        translation, angles = triple(pose.translation, values), triple(pose.rotation, values)
        if translation is None or angles is None:
            continue
        names = str(link.name), parent.name, str(edge.joint.name)
        body = Body(names, edge.joint.kind, (translation, angles), _inertia(link, values))
        parent.children.append(body)
        found[link] = body
    return list(found.values())


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


class Limbs(NamedTuple):
    """Limbs of one carrier that are meant to be alike.

    Attributes:
        heads: The first body of each by its label: side and row, or its numbers.
        is_named: Whether sides and rows tell them apart, else numbers do.
    """

    heads: Mapping[Side, Body]
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


def like_limbs(bodies: Sequence[Body]) -> Iterator[Limbs]:
    """Yield the groups of limbs at each body that carries some."""
    for carrier in bodies:
        named: dict[object, Heads] = {}
        numbered: dict[object, Heads] = {}
        for head in carrier.children:
            side, row, words = label_of(head.name)
            if side or row:
                named.setdefault(words, {}).setdefault((side, row), []).append(head)
            elif digits := tuple(int(word) for word in words if word.isdigit()):
                others = tuple(word for word in words if not word.isdigit())
                numbered.setdefault(others, {}).setdefault(digits, []).append(head)
        for is_named, table in ((True, named), (False, numbered)):
            for heads in table.values():
                single = {label: found[0] for label, found in heads.items() if len(found) == 1}
                if len(single) > 1:
                    yield Limbs(single, is_named)


class Row(NamedTuple):
    """Two bodies that stand at the same place of two limbs.

    Attributes:
        up: The index of the row of their parents, -1 for the heads.
        one: The body of the first limb.
        other: The body of its twin.
    """

    up: int
    one: Body
    other: Body


class Part(Enum):
    """Which bodies of two limbs are compared."""

    WHOLE = "all"
    BARE = "all but what they hold"
    HELD = "what these two bodies hold"


def rows_of(one: Body, other: Body, part: Part) -> tuple[list[Row], bool]:
    """Return two limbs matched body by body, and whether they match to their ends."""
    rows: list[Row] = []
    is_whole, waiting = True, [Row(-1, one, other)]
    while waiting:
        row = waiting.pop(0)
        index = len(rows)
        rows.append(row)
        is_head = row.up < 0
        matched = _matched(_chosen(row.one, part, is_head), _chosen(row.other, part, is_head))
        if matched is None:
            is_whole = False
        else:
            waiting += [Row(index, *pair) for pair in matched]
    return rows, is_whole


def _chosen(body: Body, part: Part, is_head: bool) -> list[Body]:
    if part is Part.WHOLE or (part is Part.HELD and not is_head):
        return body.children
    return [c for c in body.children if is_held(c.name, c.joint) == (part is Part.HELD)]


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
