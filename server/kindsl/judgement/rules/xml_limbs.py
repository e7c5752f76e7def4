"""The limbs of a robot in XML, and what its own numbers would be by their counterparts."""

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence, Set
from itertools import chain
from math import dist, pi, remainder

from kindsl.judgement.diagnosis.counterparts import are_near
from kindsl.judgement.rules.limb_places import OF_A_LINK, PARTS, numbers_at, place_at
from kindsl.judgement.rules.xml_axes import odd_axes
from kindsl.judgement.rules.xml_bodies import XmlBody, XmlPart, odd_links, xml_bodies
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.numbers import pose_of_com, triple
from kindsl.language.text.facts import kept
from kindsl.mechanics.rigid.body import MassDistribution, less, seen_from, shifted
from kindsl.mechanics.rigid.pose import IDENTITY, RigidPose, Vector3, angles, turned
from kindsl.robots.limbs.attachments import Attachment, LimbNames
from kindsl.robots.limbs.limb import (
    Body,
    JointAsWritten,
    Limbs,
    assembled,
    base_origin,
    groups_of,
    names_of,
)
from kindsl.robots.limbs.mirrored import PairOfLimbs, pairs_of, unmirrored
from kindsl.robots.limbs.names import label_of
from kindsl.robots.limbs.odd_masses import AS_DRAWN
from kindsl.robots.limbs.slips import is_near
from kindsl.robots.limbs.verdicts import ComparedLimbs, verdicts
from kindsl.robots.limbs.weighing import LimbVerdict, MeantNumbers

_WITHIN = 1e-9
# Right angles are written with five digits or more: what is as near to a number is that number.
_ROUNDED = 2e-5
_Z = (0.0, 0.0, 1.0)
# Bodies of a left and a right limb whose other axes agree: of fewer, both may be meant.
_FEWEST = 3


@kept
def xml_limb_names(model: Model) -> LimbNames:
    """Return the names of links and joints, links that are fixed together as one.

    Where one limb hangs on a part of the other side, which is fixed to what is of none, the parts
    that carry limbs called so are told apart.
    """
    bodies = xml_bodies(model)
    names = [
        (str(b.link.name), str(bodies[b.parent].link.name), b.carrier.parent, str(b.joint.name))
        for b in bodies
        if b.parent is not None and b.carrier is not None and b.joint is not None
    ]
    count = Counter(label_of(link).words for link, *above, _ in names if _is_across(link, *above))
    across = {words for words, number in count.items() if number == 1}
    attachments = [
        Attachment(link, part if label_of(link).words in across else body, joint)
        for link, body, part, joint in names
    ]
    for body in bodies if across else ():
        fixed = (str(part.link.name) for part in body.parts[1:])
        attachments += (Attachment(name, str(body.link.name), "") for name in fixed)
    return LimbNames(attachments)


def _is_across(link: str, body: str, part: str) -> bool:
    """Return whether a link hangs on a part of the other side, in a body that is of no side."""
    own, whole, side = (label_of(name).side for name in (link, body, part))
    return bool(own and side) and own != side and not whole


def xml_limb_verdicts(model: Model) -> list[LimbVerdict]:
    """Return what does not fit in the limbs of a robot, with the numbers that would be written.

    Inertias that are impossible by themselves, or of no material, are left out.
    """
    written, found = _LimbsAsWritten(model), []
    bodies, named, masses = written.bodies, written.named, written.masses
    odd = odd_links(model, bodies)
    for verdict in _verdicts(bodies, masses):
        weighed = (p.link for p in verdict.places if p.what in OF_A_LINK)
        links = (part.link for name in weighed for part in named[name].parts)
        is_zero = verdict.may_be_zero and _is_turned_on_one_side(verdict, bodies, named)
        if odd.isdisjoint(links) and not is_zero:
            is_exact = verdict.is_convicted
            repairs = tuple(written.repair(each, is_exact) for each in verdict.repairs)
            known = tuple(each for each in repairs if each is not None)
            untold = () if verdict.is_convicted else verdict.repairs
            nothing = tuple(each._replace(meant=()) for each in untold)
            whole = known if len(known) == len(repairs) else nothing
            found.append(verdict._replace(repairs=whole))
    return found


def _verdicts(
    bodies: Sequence[XmlBody], masses: Mapping[str, MassDistribution]
) -> Iterator[LimbVerdict]:
    """Yield what is told of limbs; of one axis alone where all frames agree."""
    carried = list(map(_compared, _limbs_in(bodies)))
    in_file = carried
    if not all(map(_are_alike, chain(*carried))):
        in_file = list(map(_compared, _limbs_in([body.with_axis(_Z) for body in bodies])))
    axes = {str(b.link.name): b.carrier.axis for b in bodies if b.carrier and b.carrier.axis}
    for groups, as_placed in zip(carried, in_file, strict=True):
        told = verdicts(groups, masses)
        for limbs, placed, own in zip(groups, as_placed, told, strict=True):
            if _are_alike(limbs):
                yield from own
                continue
            is_turned = any(_tells(each, "angles") for each in own)
            is_long = any(len(pair.rows) >= _FEWEST for pair in limbs.pairs.values())
            odd = [v for v in odd_axes(placed, axes) if v.is_convicted or is_long or is_turned]
            # Frames that are written alike are right, and the axis is wrong; else the frame is.
            unlike = [v for v in own if _tells(v, "angles") and not _are_turned_alike(placed, v)]
            is_placed = _are_alike(placed)
            others = [v for v in own if not (is_placed and _tells(v, "translation"))]
            yield from unlike or odd or [v for v in others if not _tells(v, "angles")]


def _tells(verdict: LimbVerdict, what: str) -> bool:
    return all(place.what == what for place in verdict.places)


def _are_turned_alike(limbs: ComparedLimbs, verdict: LimbVerdict) -> bool:
    """Return whether the joint frames of what is accused, and of its peers, are written alike.

    Of what is mirrored they may be half a turn apart.
    """
    rows = (row for pair in limbs.pairs.values() for row in pair.rows)
    bodies = {body.name: body for _, *both in rows for body in both}
    links = (*(place.link for place in verdict.places), *verdict.peers)
    angles = (bodies[link].as_written("angles") for link in links)
    own, *others = ([abs(remainder(x, pi)) for x in each] for each in angles)
    return all(all(map(is_near, own, each)) for each in others)


def _compared(groups: Sequence[Limbs]) -> list[ComparedLimbs]:
    return [each for limbs in map(ComparedLimbs, groups) for each in (limbs, *limbs.held)]


def _are_alike(limbs: ComparedLimbs) -> bool:
    return all(any(r.slip is None for r in pair.readings()) for pair in limbs.pairs.values())


def xml_copied_limbs(model: Model, told_of: Set[str]) -> list[PairOfLimbs]:
    """Return the pair of limbs that is copied where all others are mirrored, if there is one.

    Args:
        told_of: Links of which one place is told that makes their limbs alike.
    """
    names, bodies = xml_limb_names(model), xml_bodies(model)
    if names.elsewhere or names.crossed:
        return []
    pairs = unmirrored(pairs_of(_limbs_in(bodies), _masses(bodies)))
    return [p for p in pairs if told_of.isdisjoint((*names_of(p.left), *names_of(p.right)))]


def _masses(bodies: Sequence[XmlBody]) -> dict[str, MassDistribution]:
    """Return what is known of bodies by name, in the frame of the joint's axis.

    Moments are about the CoM, as they are written: a slip in the latter is no slip in them.
    """
    return {
        str(body.link.name): shifted(seen_from(body.mass, body.axis_pose.inverse()), -1.0)
        for body in bodies
        if body.mass is not None
    }


class _LimbsAsWritten:
    """Translates numbers of limbs into those of the file."""

    def __init__(self, model: Model) -> None:
        self._model, self.bodies = model, xml_bodies(model)
        self.named = {str(body.link.name): body for body in self.bodies}
        self.masses = _masses(self.bodies)

    def repair(self, repair: MeantNumbers, is_exact: bool) -> MeantNumbers | None:
        """Return what is to be written at a place, None where its numbers do not tell alone.

        Args:
            is_exact: Whether peers tell all digits; else what is nearly another sign is that.
        """
        place = repair.place
        own = [value.literal or 0.0 for value in numbers_at(self._model, place)]
        if place.what in ("kind", "axis"):
            return repair
        found = self._of_link(repair) if place.what in OF_A_LINK else self._of_joint(repair)
        if found is None or len(found) != len(own):
            return None
        peers = (place_at(self._model, name, place.what) for name in self.named)
        near = [*own, *(v.literal or 0.0 for t in peers for v in numbers_at(self._model, t))]
        size = 1.0 if place.what == "angles" else max(map(abs, (*found, *own)))
        meant = tuple(_rounded(x, near, _ROUNDED * size) for x in found)
        if place.what == "com" and not is_exact:
            # A sign in the frame of a tilted axis is none in that of the file.
            meant = _with_other_sign(own, meant) or meant
        # What is fixed to a link may be wrong instead: its own numbers stand at a peer then.
        is_alone = place.what not in OF_A_LINK or len(_heavy(self.named[place.link])) == 1
        is_known = is_alone or {*map(abs, meant)} <= {*map(abs, near)}
        return MeantNumbers(place, (meant,)) if is_known else None

    def _of_joint(self, repair: MeantNumbers) -> Vector3 | None:
        (link, _, what), (meant, *_) = repair
        body = self.named[link]
        written = _as_written(body, self.bodies[body.parent or 0])
        if written is None or len(meant) != 3:
            return None
        x, y, z = meant
        return written.to_write(what, (x, y, z))

    def _of_link(self, repair: MeantNumbers) -> Sequence[float] | None:
        (link, _, what), (meant, *_) = repair
        body = self.named[link]
        pose = pose_of_com(body.link, {})
        own, *others = _heavy(body) or body.parts
        if pose is None or own.link is not body.link:
            return None
        seen = self.masses[link]
        ten = [*seen.numbers]
        ten[PARTS[what]] = meant
        limb = seen_from(shifted(MassDistribution.of(ten)), body.axis_pose)
        rest = [seen_from(p.mass, p.pose) for p in others if p.mass is not None]
        in_link = seen_from(less(limb, rest), own.pose.inverse())
        turned = RigidPose(pose.rotation, in_link.com)
        there = seen_from(in_link, turned.inverse())
        return [ten[0], *in_link.com, *there.moments][PARTS[what]]


def _is_turned_on_one_side(
    verdict: LimbVerdict, bodies: Sequence[XmlBody], named: Mapping[str, XmlBody]
) -> bool:
    """Return whether only one side turns by half a turn, about its axis, what carries a joint.

    A file tells so what a document does not: that its zero is there, not a number wrong.
    """
    places = (named[place.link] for place in verdict.places if place.what == "translation")
    above = (bodies[body.parent] for body in places if body.parent is not None)
    return {*map(_is_half_turned, above)} == {False, True}


def _is_half_turned(body: XmlBody) -> bool:
    rotation, axis = body.placement.rotation, body.carrier.axis if body.carrier else None
    is_half = abs(1.0 + sum(rotation[i][i] for i in range(3))) < _ROUNDED
    return is_half and axis is not None and dist(turned(rotation, axis), axis) < _ROUNDED


def _heavy(body: XmlBody) -> list[XmlPart]:
    return [part for part in body.parts if part.mass is not None and part.mass.mass]


def _with_other_sign(own: Sequence[float], meant: Sequence[float]) -> tuple[float, ...]:
    """Return the numbers that stand there, one sign changed, if they are nearly what is meant."""
    odd = max(range(len(own)), key=lambda n: abs(own[n] - meant[n]))
    signed = tuple(-x if n == odd else x for n, x in enumerate(own))
    return signed if are_near(signed, meant, AS_DRAWN) else ()


def _rounded(value: float, near: Sequence[float], within: float) -> float:
    """Return the number that is meant, of those that stand there and their opposites."""
    signed = (sign * each for each in near for sign in (1.0, -1.0))
    nearest = min(signed, key=lambda each: abs(each - value))
    return nearest if abs(nearest - value) <= within else value


def _limbs_in(bodies: Sequence[XmlBody]) -> Iterator[list[Limbs]]:
    """Yield the groups of limbs that each body carries and that are meant to be alike.

    In each limb a link's frame is turned with its joint's axis, which is z.
    """
    carried: list[list[Body | None]] = [[] for _ in bodies]
    poses: list[RigidPose] = []
    for body in bodies:
        above = IDENTITY if body.parent is None else poses[body.parent]
        poses.append(above.then(body.placement))
    for body, pose, below in zip(reversed(bodies), reversed(poses), reversed(carried), strict=True):
        known = [each for each in reversed(below) if each is not None]
        if groups := list(groups_of(known)):
            base = base_origin(pose.then(body.axis_pose))
            yield [limbs._replace(base=base) for limbs in groups]
        if body.parent is not None:
            parent = bodies[body.parent]
            made = _limb_body(body, parent, tuple(known)) if len(known) == len(below) else None
            carried[body.parent].append(made)


def _limb_body(body: XmlBody, parent: XmlBody, carried: tuple[Body, ...]) -> Body | None:
    carrier = body.carrier
    if carrier is None or carrier.axis is None:
        return None
    pose = parent.axis_pose.inverse().then(body.placement).then(body.axis_pose)
    turns = angles(pose.rotation, _WITHIN)
    names = str(body.link.name), str(carrier.joint.name)
    made = assembled(*names, carrier.joint.kind, pose, turns, carried)
    return None if made is None else made._replace(written=_as_written(body, parent))


def _as_written(body: XmlBody, parent: XmlBody) -> JointAsWritten | None:
    """Return the numbers of a joint in its frame, None where others place it."""
    carrier = body.carrier
    if carrier is None or not carrier.is_told:
        return None
    part = next(p for p in parent.parts if p.link.name == carrier.parent)
    above = part.pose.inverse().then(parent.axis_pose)
    at, turns = (triple(each, {}) for each in carrier.joint.pose)
    if at is None or turns is None:
        return None
    return JointAsWritten(above, body.axis_pose.rotation, at, turns)
