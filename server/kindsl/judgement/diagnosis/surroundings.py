"""Evidence from the rest of the robot on a link's inertia: its children's joints, its peers."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import partial
from math import dist, hypot
from operator import add
from typing import NamedTuple

from kindsl.judgement.diagnosis.body_verdicts import GREATEST_LENGTH
from kindsl.judgement.diagnosis.counterparts import (
    are_near,
    bodies_with,
    counterparts,
    is_mirror_image,
    is_same_body,
    may_be_image,
    namesakes,
    telling_numbers,
)
from kindsl.judgement.diagnosis.evidence import ELONGATED, MassShape
from kindsl.judgement.diagnosis.fitted import EXPECTED, MIRRORED
from kindsl.judgement.diagnosis.judgements import Judgement, is_impossible, is_moving
from kindsl.judgement.diagnosis.slips import Hypothesis, Slip
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.declarations import Link
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.numbers import mass_distribution, pose_of_com, written_pose
from kindsl.language.text.facts import Fact, kept
from kindsl.mechanics.rigid.body import MassDistribution
from kindsl.mechanics.rigid.pose import ORIGIN, Rotation, Vector3, dot, transposed, turned
from kindsl.robots.limbs.attachments import links_above
from kindsl.robots.limbs.names import are_named_alike, label_of
from kindsl.robots.limbs.peer_frames import peer_frames
from kindsl.robots.limbs.weighing import seen_by

_Inertia = tuple[Link, MassDistribution]
_FRAMES = Fact[tuple[object, dict[tuple[str, str], list[Rotation]]]]("frames of peers, by names")
_PLACED = Aspect.STRUCTURE | Aspect.PLACES
_FEWEST_MASSES = 3
_NEAR = 0.02
_ALONG = 0.85
_ACROSS = 0.2


class Peer(NamedTuple):
    """A link of the same part whose inertia is possible.

    Attributes:
        body: Its inertia.
        expected: The inertia that the link should have for its sake, None if that is not known.
        origin: Where the frame of its inertia is, from the link's origin and along its own axes.
    """

    name: str
    body: MassDistribution
    expected: MassDistribution | None
    origin: Vector3 = ORIGIN

    @property
    def placed(self) -> MassDistribution:
        """Its body with the CoM from the link's origin, the moments as they are."""
        return _placed(self.body, self.origin)


class LinkSurroundings(NamedTuple):
    """The known facts of a link besides its inertia.

    Attributes:
        points: Origins of its frames and of its children's joints, from the link's origin and
            along the axes of its inertia, m.
        peers: Links of the same part whose mirror image it may be but for a mistake.
        mass: The middle one of the robot's links, kg; zero if there are few.
        copies: Unlike links that have the same moments, or CoM, and which of these.
        origin: Where the frame of its inertia is, likewise.
    """

    points: tuple[Vector3, ...]
    peers: tuple[Peer, ...]
    mass: float = 0.0
    copies: tuple[tuple[str, str], ...] = ()
    origin: Vector3 = ORIGIN

    def placed(self, body: MassDistribution) -> MassDistribution:
        """Return a body with its CoM from the link's origin, its moments as they are."""
        return _placed(body, self.origin)

    @property
    def end(self) -> Vector3 | None:
        """The farthest of its points, None where none is known."""
        return max(self.points, key=lambda point: hypot(*point), default=None)


def _placed(body: MassDistribution, origin: Vector3) -> MassDistribution:
    x, y, z = map(add, body.com, origin)
    return body._replace(com=(x, y, z))


_SURROUNDINGS = Fact[tuple[object, LinkSurroundings]]("surroundings")


class Evidence(NamedTuple):
    """The evidence for a hypothesis.

    Attributes:
        log_weight: A logarithm to add.
        reasons: Why, in words.
        agreement: Of a body with its counterparts: 1 with one but for its signs, 2 with all.
    """

    log_weight: float
    reasons: tuple[str, ...] = ()
    agreement: int = 0


def surroundings(model: Model, values: Mapping[str, float], found: Judgement) -> LinkSurroundings:
    """Return what is known of a link besides its inertia; looked at again where that changes."""
    link, named = found.link, namesakes(model, found.link)
    made_of = (
        found,
        values,
        model.edition.facts(_PLACED),
        model.tree.joints_on(link),
        named,
        [bodies_with(model, telling) for telling in telling_numbers(link)],
        middle_mass(model),
    )
    look = partial(_surroundings, model, values, found, named)
    return link.facts.made_of(_SURROUNDINGS, made_of, look)


def _surroundings(
    model: Model, values: Mapping[str, float], found: Judgement, named: Sequence[Link]
) -> LinkSurroundings:
    link = found.link
    T = pose_of_com(link, values)
    points = _points(model, values, link)
    if T is not None:
        points = tuple(turned(transposed(T.rotation), point) for point in points)
    alike = _with_inertia(counterparts(model, link), values)
    possible = [each for each in alike if not is_impossible(each[0], values)]
    peers = _peers(model, values, found, possible, named)
    names = {peer.name for peer in peers}
    return LinkSurroundings(
        points,
        peers,
        middle_mass(model),
        tuple(each for each in copies(model, values, link) if each[0] not in names),
        _origin(link, values),
    )


def _origin(link: Link, values: Mapping[str, float]) -> Vector3:
    """Return where the frame of an inertia is, from the link's origin and along its own axes."""
    T = pose_of_com(link, values)
    return turned(transposed(T.rotation), T.translation) if T is not None else ORIGIN


def _points(model: Model, values: Mapping[str, float], link: Link) -> tuple[Vector3, ...]:
    """Return where a link's frames and its children's joints are, none beside its origin."""
    if link.inertia is None or (link.inertia.frame is not None and not model.document.is_xml):
        return ()
    poses = [frame.pose for frame in link.frames if frame.name]
    edges = model.tree.successor_edges(link)
    poses += [edge.joint.pose for edge in edges if edge.joint is not None]
    placed = (written_pose(pose, values) for pose in poses)
    points = [place.translation for place in placed if place is not None]
    if model.document.is_xml:
        points += _carried(model).get(str(link.name), ())
    return tuple(point for point in points if _NEAR < hypot(*point) < GREATEST_LENGTH)


@kept
def _carried(model: Model) -> dict[str, list[Vector3]]:
    """Return where the joints of a robot in XML are in the links that carry them."""
    found: dict[str, list[Vector3]] = {}
    for each in getattr(model.document, "connections", ()):
        joint = each.parent_T_child.then(each.child_T_joint)
        found.setdefault(each.parent, []).append(joint.translation)
    return found


def farthest_end(model: Model, values: Mapping[str, float], link: Link) -> Vector3 | None:
    """Return the farthest of a link's frames and children's joints, None where none is known."""
    return LinkSurroundings(_points(model, values, link), ()).end


def reasons_of_end(h: Hypothesis, shape: MassShape, end: Vector3 | None) -> Iterator[str]:
    """Yield in words what the place of a link's end says of a hypothesis."""
    if end is None:
        return
    _, middle, long = shape.pairs
    if long.value > ELONGATED * max(middle.value, 0.0):
        along = abs(dot(long.axis, end)) / hypot(*end)
        if along > _ALONG:
            yield "long towards its next joint"
        elif along < _ACROSS:
            yield "though then long across its link"
    if {Slip.COM_SIGN, Slip.COM_ORDER} & set(h.slips) and dot(h.body.com, end) > 0.0:
        yield "CoM on the side of its next joint"


def of_counterparts(body: MassDistribution, around: LinkSurroundings) -> Evidence:
    """Return what the counterpart that says most says of a body."""
    images = [peer for peer in around.peers if is_mirror_image(body, peer.body)]
    said = [_of_image(body, peer, around) for peer in images]
    return max(said, key=lambda each: each.log_weight, default=Evidence(0.0))


def _of_image(body: MassDistribution, peer: Peer, around: LinkSurroundings) -> Evidence:
    """Return what a mirror image says: most where the body is as it expects it."""
    is_equal = is_same_body(around.placed(body), peer.placed)
    is_expected = peer.expected is not None and is_same_body(body, peer.expected)
    return Evidence(
        EXPECTED if is_expected else MIRRORED,
        (f"{'equal to' if is_equal else 'mirror image of'} '{peer.name}'",),
        2 if is_expected else 1,
    )


@kept
def middle_mass(model: Model) -> float:
    """Return the lower median of the masses that are written as numbers, zero of one or two."""
    moving = [b.inertia.mass for b in model.bodies if b.inertia is not None and is_moving(b)]
    masses = sorted(m.literal for m in moving if m is not None and m.literal)
    middle = masses[(len(masses) - 1) // 2] if len(masses) >= _FEWEST_MASSES else 0.0
    return max(middle, 0.0)


def copies(model: Model, values: Mapping[str, float], link: Link) -> Iterator[tuple[str, str]]:
    """Yield the possible links of other parts that have the moments, or the CoM, of a link.

    What a peer of the link has besides, but for signs, is their own.
    """
    owned = [numbers for peer in namesakes(model, link) for numbers in telling_numbers(peer)]
    part = label_of(str(link.name)).part
    for telling in telling_numbers(link):
        if not any(telling.is_as(each, abs) for each in owned):
            for other in bodies_with(model, telling):
                is_other = label_of(str(other.name)).part != part
                if is_other and not is_impossible(other, values):
                    yield str(other.name), telling.what


def same_moments(model: Model, link: Link) -> Iterator[str]:
    """Yield the names of links that a link may have its moments from, not its peers by name.

    Links that are called alike and are as far from the base may be one part as well. Of two that
    share them, the one that is less like its own peers has those of the other.
    """
    words = label_of(str(link.name)).words
    for telling in telling_numbers(link)[:1]:
        for other in bodies_with(model, telling) if telling.what == "moments" else ():
            names = str(link.name), str(other.name)
            is_other = label_of(names[1]).words != words and not (
                are_named_alike(names) and len({*map(_depths(model).get, names)}) == 1
            )
            if is_other and _unlikeness(model, other) <= _unlikeness(model, link):
                yield str(other.name)


@kept
def _depths(model: Model) -> dict[str, int]:
    """Return how many joints are between the base and each link."""
    parents = {str(e.child.link): str(e.predecessor.name) for e in model.tree.edges}
    if model.document.is_xml:
        parents = {e.child: e.parent for e in getattr(model.document, "connections", ())}
    return {link: len(links_above(link, parents)) for link in parents}


def _unlikeness(model: Model, link: Link) -> float:
    """Return how far a link's moments are from those of its nearest namesake, as a share."""
    namesake = namesakes(model, link)
    known = {o: [*map(abs, body.moments)] for o, body in _with_inertia((link, *namesake), {})}
    own = known.pop(link, [])
    apart = (dist(own, each) / max(*own, *each) for each in known.values() if own)
    return min(apart, default=0.0)


def _with_inertia(links: Iterable[Link], values: Mapping[str, float]) -> Iterator[_Inertia]:
    """Yield the links that have a mass, with their inertias."""
    for other in links:
        if other.inertia is not None:
            body = mass_distribution(other.inertia, values)
            if body is not None and body.mass > 0.0:
                yield other, body


def _peers(
    model: Model,
    values: Mapping[str, float],
    found: Judgement,
    possible: Sequence[_Inertia],
    namesakes: Sequence[Link],
) -> tuple[Peer, ...]:
    """Return those that may be images, and what all possible namesakes let expect of this one."""
    peers = [each for each in possible if may_be_image(found.body, each[1])]
    named = [each for each in possible if each[0] in namesakes] if peers else ()
    expected = _expected(model, values, found.link, named)
    return tuple(Peer(str(o.name), body, expected, _origin(o, values)) for o, body in peers)


def _expected(
    model: Model, values: Mapping[str, float], link: Link, peers: Sequence[_Inertia]
) -> MassDistribution | None:
    """Return the inertia that all peers let expect, None where they do not agree.

    Where those of both sides are written alike, limbs are copies however they are mounted.
    """
    others = [other for other, _ in peers]
    is_plain = all(o.inertia is None or o.inertia.frame is None for o in (link, *others))
    side = label_of(str(link.name)).side
    is_of_side = is_plain and any(label_of(str(other.name)).side == side for other in others)
    if len(peers) > 1 and is_of_side and all(is_same_body(b, peers[0][1]) for _, b in peers):
        return peers[0][1]
    masses = [body.mass for _, body in peers]
    agreed: list[MassDistribution] | None = None
    for other, body in peers if are_near(masses, masses[:1] * len(masses)) else ():
        seen = [seen_by(body, transposed(C)) for C in _frames(model, values, link, other)]
        if agreed is None:
            agreed = seen
        agreed = [each for each in agreed if any(is_same_body(each, own) for own in seen)]
        if not agreed:
            return None
    return agreed[0] if agreed else None


def _frames(model: Model, values: Mapping[str, float], link: Link, other: Link) -> list[Rotation]:
    """Return `peer_frames`, none where an inertia is given in a frame that is not the link's."""
    inertias = [body.inertia for body in (link, other) if body.inertia is not None]
    if any(inertia.frame is not None for inertia in inertias):
        return []
    places = model.edition.facts(_PLACED)
    known = places.made_of(_FRAMES, values, dict)
    names = str(link.name), str(other.name)
    if names not in known:
        known[names] = peer_frames(model.tree, link, other, values)
    return known[names]
