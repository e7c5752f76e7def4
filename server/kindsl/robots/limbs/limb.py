"""Limbs in plain numbers, and which of a robot are meant to be alike."""

from collections.abc import Iterator, Sequence
from itertools import combinations
from typing import NamedTuple

from kindsl.language.semantics.declarations import Link
from kindsl.language.semantics.expressions import Values
from kindsl.language.semantics.kinematic_tree import Edge, KinematicTree
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.numbers import triple, written_pose
from kindsl.mechanics.rigid.pose import (
    IDENTITY,
    RigidPose,
    Rotation,
    Vector3,
    pose_from,
    product,
    transposed,
)
from kindsl.robots.limbs.names import is_held, label_of
from kindsl.robots.limbs.slips import angles_near

# No robot has more or longer ones that are written by hand, and comparing takes their square.
_MOST_LIMBS, _MOST_BODIES = 12, 48
_DEEPEST = 16
_PARALLEL = 1e-6
# Named ones may be a left and a right one; of two numbered ones nothing can be told.
_FEWEST = {True: 2, False: 3}

AT_ORIGIN = IDENTITY.translation
Side = tuple[object, ...]


class JointAsWritten(NamedTuple):
    """The numbers of a joint frame in a file whose frames are not turned with axes.

    Attributes:
        above: The frame of the limb's body above in that in which the joint is placed.
        below: How the frame of the body that moves is turned in the joint's.
        translation: As written, metres.
        angles: As written, about fixed axes, radians.
    """

    above: RigidPose
    below: Rotation
    translation: Vector3
    angles: Vector3

    def to_write(self, what: str, meant: Vector3) -> Vector3:
        """Return what is to be written for a `translation` or `angles` in the limb's frames."""
        if what == "translation":
            return self.above.point(meant)
        turn = product(self.above.rotation, pose_from(AT_ORIGIN, meant).rotation)
        turn = product(turn, transposed(self.below))
        # Turns about fixed axes are those about own axes of the reverse, backwards.
        a, b, c = self.angles
        x, y, z = angles_near(transposed(turn), (-a, -b, -c), (-a, -b, -c))
        return 0.0 - x, 0.0 - y, 0.0 - z


class Body(NamedTuple):
    """A link with the joint that supports it, and all that it carries; of masses it knows nothing.

    Attributes:
        name: The link's.
        joint: The supporting joint's name.
        kind: `revolute` or `prismatic`.
        rotation: Of the joint frame in the parent's frame.
        translation: The same, metres.
        angles: The rotation as written, radians.
        children: The bodies that it carries, in written order, without those that it holds.
        held: Tools and hands that it holds, by their names; their own parts are not told apart.
        n_bodies: The number of bodies, with all that it carries.
        written: The joint frame's numbers where they are those of other frames.
    """

    name: str
    joint: str
    kind: str
    rotation: Rotation
    translation: Vector3
    angles: Vector3
    children: tuple["Body", ...] = ()
    held: tuple["Body", ...] = ()
    n_bodies: int = 1
    written: JointAsWritten | None = None

    def as_written(self, what: str) -> Vector3:
        """Return the `translation` or `angles` of its joint frame as they stand in the text."""
        own: Vector3 = getattr(self.written or self, what)
        return own

    def to_write(self, what: str, meant: Vector3) -> Vector3:
        """Return what is to be written for a `translation` or `angles` in the limb's frames."""
        return meant if self.written is None else self.written.to_write(what, meant)


class Limbs(NamedTuple):
    """Limbs of one carrier that are meant to be alike.

    Attributes:
        heads: The first body of each with its label: side and row, or its numbers.
        is_named: Whether sides and rows tell them apart, else numbers do.
        are_held: Whether they are what a left and a right limb hold.
        base: The base's origin in the carrier's frame, where their axes are parallel.
    """

    heads: tuple[tuple[Side, Body], ...]
    is_named: bool
    are_held: bool = False
    base: Vector3 = AT_ORIGIN

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
        values: Of its parameters and constants.
    """
    tree, base = model.tree, model.base
    whole: dict[Link, Body] = {}
    found: dict[Link, list[Limbs]] = {}
    for carrier in [base, *tree.in_topological_order(base)][::-1] if base is not None else ():
        edges = tree.successor_edges(carrier)
        carried = tuple([whole[e.link] for e in edges if e.link is not None and e.link in whole])
        groups = list(groups_of(carried))
        if groups:
            origin = base_origin(_pose_in_base(tree, carrier, values))
            found[carrier] = [limbs._replace(base=origin) for limbs in groups]
        above = tree.above.get(carrier, ())
        if len(carried) == len(edges) and len(above) == 1:
            body = body_of(above[0], values, carried)
            if body is not None:
                whole[carrier] = body
    return found


def way_up(tree: KinematicTree, link: Link) -> list[Edge]:
    """Return the edges from a link to the base, the first of them if they are very many."""
    way: list[Edge] = []
    edge = tree.supporting_edge(link)
    while edge is not None and len(way) < _DEEPEST:
        way.append(edge)
        edge = tree.supporting_edge(edge.predecessor)
    return way


def _pose_in_base(tree: KinematicTree, link: Link, values: Values) -> RigidPose | None:
    pose, way = IDENTITY, way_up(tree, link)
    if way and not way[-1].predecessor.is_base:
        return None
    for edge in way:
        above = written_pose(edge.joint.pose, values) if edge.joint is not None else None
        if above is None:
            return None
        pose = above.then(pose)
    return pose


def base_origin(pose: RigidPose | None) -> Vector3:
    """Return the base's origin in a body's frame, its own where axes are not parallel.

    Args:
        pose: Of the body in the base's frame, if it is known.
    """
    shares = (abs(x) for row in pose.rotation for x in row) if pose is not None else (0.5,)
    is_parallel = all(min(share, 1.0 - share) < _PARALLEL for share in shares)
    return pose.inverse().translation if pose is not None and is_parallel else AT_ORIGIN


def groups_of(carried: Sequence[Body]) -> Iterator[Limbs]:
    """Yield what one body carries that is called alike, by side and row, or else by numbers."""
    groups: dict[tuple[bool, tuple[str, ...]], dict[Side, list[Body]]] = {}
    for head in carried if len(carried) > 1 else ():
        side, row, words, part = label_of(head.name)
        is_named = bool(side or row)
        label: Side = (side, row) if is_named else tuple(int(w) for w in words if w.isdigit())
        if label:
            alike = groups.setdefault((is_named, words if is_named else part), {})
            alike.setdefault(label, []).append(head)
    for (is_named, _), by_label in groups.items():
        heads = tuple((label, found[0]) for label, found in by_label.items() if not found[1:])
        if len(by_label) <= _MOST_LIMBS and len(heads) >= _FEWEST[is_named]:
            yield Limbs(heads, is_named)


def body_of(edge: Edge, values: Values, carried: tuple[Body, ...] = ()) -> Body | None:
    """Return a link with its joint in numbers, None where they are not known."""
    link, joint = edge.link, edge.joint
    pose = written_pose(joint.pose, values) if joint is not None else None
    angles = triple(joint.pose.rotation, values) if joint is not None else None
    if link is None or joint is None or pose is None or angles is None:
        return None
    return assembled(str(link.name), str(joint.name), joint.kind, pose, angles, carried)


def assembled(
    name: str, by: str, kind: str, pose: RigidPose, angles: Vector3, carried: tuple[Body, ...]
) -> Body | None:
    """Return a body with what it carries, None where that is more than limbs have.

    Args:
        name: The link's.
        by: The supporting joint's.
        kind: The joint's.
        pose: The joint frame in the parent's frame.
        angles: Its rotation as written, radians.
        carried: The bodies that it carries.
    """
    held = () if is_held(name, by) else tuple([b for b in carried if is_held(b.name, b.joint)])
    children = tuple([b for b in carried if b not in held]) if held else carried
    n_bodies = 1 + sum([b.n_bodies for b in carried])
    if n_bodies > _MOST_BODIES:
        return None
    return Body(name, by, kind, *pose, angles, children, held, n_bodies)


def names_of(body: Body) -> Iterator[str]:
    """Yield the names of a body and of all that it carries but for what it holds."""
    yield body.name
    for child in body.children:
        yield from names_of(child)


class Match(NamedTuple):
    """Two bodies that stand at the same place of two limbs.

    Attributes:
        up: The index of the row of their parents, -1 for the heads.
        one: The body of the first limb.
        other: The body of its peer.
    """

    up: int
    one: Body
    other: Body


def matched(one: Body, other: Body) -> list[Match] | None:
    """Return two limbs body by body, without what they hold; None where they do not match."""
    rows = [Match(-1, one, other)]
    for index, (_, here, there) in enumerate(rows):
        pairs = _pairs(here.children, there.children)
        if pairs is None:
            return None
        rows += [Match(index, *pair) for pair in pairs]
    return rows


def held_by(rows: Sequence[Match]) -> Iterator[tuple[Body, ...]]:
    """Yield what two limbs hold at the same place: a hand, or a body with nothing but fingers."""
    for _, *both in rows:
        if all(body.held for body in both):
            hands = (b if len(b.held) > 1 else b.held[0] for b in both)
            yield tuple(h._replace(children=h.held, held=()) if h.held else h for h in hands)


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
