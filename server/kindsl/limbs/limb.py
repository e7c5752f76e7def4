"""Limbs in plain numbers, and which of a robot are meant to be alike."""

from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations
from typing import NamedTuple

from kindsl.limbs.names import is_held, label_of
from kindsl.rigid.pose import Rotation, Vector3
from kindsl.semantics.declarations import Link
from kindsl.semantics.kinematic_tree import Edge
from kindsl.semantics.model import Model
from kindsl.semantics.numbers import triple, written_pose

# No robot has more or longer ones that are written by hand, and comparing takes their square.
_MOST_LIMBS, _MOST_BODIES = 12, 48
# Named ones may be a left and a right one; of two numbered ones nothing can be told.
_FEWEST = {True: 2, False: 3}

Side = tuple[object, ...]
Values = Mapping[str, float]


class Body(NamedTuple):
    """A link with the joint that supports it, and all that it carries; of masses it knows nothing.

    Attributes:
        name: The link's.
        joint: The supporting joint's name.
        kind: `revolute` or `prismatic`.
        rotation: Of the joint frame in the parent's frame.
        translation: The same, metres.
        angles: The rotation as written, radians.
        children: The bodies that it carries, in written order.
    """

    name: str
    joint: str
    kind: str
    rotation: Rotation
    translation: Vector3
    angles: Vector3
    children: tuple["Body", ...] = ()

    @property
    def is_held(self) -> bool:
        """True if it is a tool, a hand or a part of one, by its names."""
        return is_held(self.name, self.joint)


class Limbs(NamedTuple):
    """Limbs of one carrier that are meant to be alike.

    Attributes:
        heads: The first body of each with its label: side and row, or its numbers.
        is_named: Whether sides and rows tell them apart, else numbers do.
        are_held: Whether they are what a left and a right limb hold.
    """

    heads: tuple[tuple[Side, Body], ...]
    is_named: bool
    are_held: bool = False

    def pairs(self) -> Iterator[tuple[Side, Side, str]]:
        """Yield two labels and how they lie to each other: `LR`, `ROW`, `TURN` or `HELD`."""
        for one, other in combinations(sorted((side for side, _ in self.heads), key=repr), 2):
            if not self.is_named:
                yield one, other, "TURN"
            elif one[1] == other[1] and one[0] != other[0] and one[0] and other[0]:
                yield one, other, "HELD" if self.are_held else "LR"
            elif one[0] == other[0] and one[1] != other[1]:
                yield one, other, "ROW"


def limbs_of(model: Model, values: Values) -> dict[Link, list[Limbs]]:
    """Return the groups of limbs that each body carries; left out are those without numbers.

    Args:
        model: The robot.
        values: Of its parameters and constants.
    """
    made: dict[Link, _Whole | None] = {}
    found: dict[Link, list[Limbs]] = {}
    for body, edges in reversed(model.tree.below.items()):
        groups = []
        for is_named, by_label in _labelled(edges):
            limbs = ((label, _whole(edge, model, values, made)) for label, edge in by_label.items())
            heads = tuple((label, limb.head) for label, limb in limbs if limb is not None)
            if len(heads) >= _FEWEST[is_named]:
                groups.append(Limbs(heads, is_named))
        if groups:
            found[body] = groups
    return found


def _labelled(edges: Sequence[Edge]) -> Iterator[tuple[bool, dict[Side, Edge]]]:
    """Yield what one body carries that is called alike, by side and row, or else by numbers."""
    groups: dict[tuple[bool, tuple[str, ...]], dict[Side, list[Edge]]] = {}
    for edge in edges if len(edges) > 1 else ():
        side, row, words, part = label_of(str(edge.child.link))
        is_named = bool(side or row)
        label: Side = (side, row) if is_named else tuple(int(w) for w in words if w.isdigit())
        if label:
            alike = groups.setdefault((is_named, words if is_named else part), {})
            alike.setdefault(label, []).append(edge)
    for (is_named, _), by_label in groups.items():
        if _FEWEST[is_named] <= len(by_label) <= _MOST_LIMBS:
            yield is_named, {label: found[0] for label, found in by_label.items() if not found[1:]}


class _Whole(NamedTuple):
    """A body with all that it carries, and how many bodies that is."""

    head: Body
    n_bodies: int


def _whole(
    edge: Edge, model: Model, values: Values, made: dict[Link, _Whole | None], depth: int = 1
) -> _Whole | None:
    """Return what an edge leads to, None where it has very many bodies or no numbers."""
    link = edge.link
    if link is None or depth > _MOST_BODIES or len(model.tree.above[link]) > 1:
        return None
    if link not in made:
        edges = model.tree.successor_edges(link)
        carried = [_whole(each, model, values, made, depth + 1) for each in edges]
        known = [each for each in carried if each is not None]
        n_bodies = 1 + sum(each.n_bodies for each in known)
        is_whole = len(known) == len(edges) and n_bodies <= _MOST_BODIES
        head = body_of(edge, values, tuple(each.head for each in known)) if is_whole else None
        made[link] = _Whole(head, n_bodies) if head is not None else None
    return made[link]


def body_of(edge: Edge, values: Values, children: tuple[Body, ...] = ()) -> Body | None:
    """Return a link with its joint in numbers, None where they are not known."""
    link, joint = edge.link, edge.joint
    pose = written_pose(joint.pose, values) if joint is not None else None
    angles = triple(joint.pose.rotation, values) if joint is not None else None
    if link is None or joint is None or pose is None or angles is None:
        return None
    return Body(str(link.name), str(joint.name), joint.kind, *pose, angles, children)


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


def matched(one: Body, other: Body, with_held: bool = False) -> list[Match] | None:
    """Return two limbs body by body, without what they hold; None where they do not match."""
    rows = [Match(-1, one, other)]
    for index, (_, *both) in enumerate(rows):
        is_all = with_held or one.is_held
        pairs = _pairs(*([c for c in b.children if is_all or not c.is_held] for b in both))
        if pairs is None:
            return None
        rows += [Match(index, *pair) for pair in pairs]
    return rows


def held_by(rows: Sequence[Match]) -> Iterator[tuple[Body, ...]]:
    """Yield what two limbs hold at the same place: a hand, or a body with nothing but fingers."""
    for _, *both in rows:
        held = [tuple(c for c in body.children if c.is_held) for body in both]
        if all(held) and not both[0].is_held:
            pairs = zip(both, held, strict=True)
            yield tuple(h[0] if len(h) == 1 else b._replace(children=h) for b, h in pairs)


def _pairs(ones: Sequence[Body], others: Sequence[Body]) -> list[tuple[Body, Body]] | None:
    if len(ones) != len(others):
        return None
    if len(ones) < 2:
        return list(zip(ones, others, strict=True))
    for with_numbers in (True, False):
        here, there = _by_words(ones, with_numbers), _by_words(others, with_numbers)
        if len(here) == len(ones) and set(here) == set(there):
            return [(here[words], there[words]) for words in sorted(here)]
    return None


def _by_words(bodies: Sequence[Body], with_numbers: bool) -> dict[tuple[str, ...], Body]:
    found = ((label_of(body.name), body) for body in bodies)
    return {label.words if with_numbers else label.part: body for label, body in found}
