"""Limbs of a robot in XML that differ from their counterparts."""

from collections.abc import Iterator, Mapping, Sequence

from kindsl.judgement.rules.base import Finding, Related
from kindsl.judgement.rules.limb_attachments import crossed_findings, elsewhere_findings
from kindsl.judgement.rules.limb_places import OF_A_LINK, told
from kindsl.judgement.rules.xml_bodies import XmlBody
from kindsl.language.semantics.declarations import Link
from kindsl.language.semantics.numbers import written_pose
from kindsl.language.semantics.places import Located
from kindsl.mechanics.rigid.body import seen_from
from kindsl.mechanics.rigid.pose import angles
from kindsl.robots.interchange.robot_island import RobotIsland
from kindsl.robots.limbs.attachments import Attachment, LimbNames
from kindsl.robots.limbs.limb import Body, Limbs, assembled, groups_of
from kindsl.robots.limbs.verdicts import ComparedLimbs, LimbVerdict, verdicts
from kindsl.robots.limbs.weighing import Suspect

_WITHIN = 1e-9


def limb_findings(
    bodies: Sequence[XmlBody], odd: set[Link]
) -> Iterator[tuple[str, Finding, tuple[Link, ...]]]:
    """Yield numbers of limbs that do not fit the others, and the links that these are of."""
    named = {str(body.link.name): body for body in bodies}
    names = LimbNames(
        [
            Attachment(*(str(each.name) for each in (b.link, bodies[b.parent].link, b.joint)))
            for b in bodies
            if b.parent is not None and b.joint is not None
        ]
    )
    if names.elsewhere or names.crossed:
        elsewhere = elsewhere_findings(names, lambda name: _parent_name(named[name]))
        crossed = crossed_findings(names, lambda name: _joint_name(named[name]))
        yield from (("KD208", finding, ()) for finding, _ in elsewhere)
        yield from (("KD209", finding, ()) for finding, _ in crossed)
        return
    masses = {
        name: seen_from(body.mass, body.axis_pose.inverse())
        for name, body in named.items()
        if body.mass is not None
    }
    for limbs in _limbs_in(bodies):
        compared = ComparedLimbs(limbs)
        for group in (compared, *compared.held):
            for verdict in verdicts(group, masses):
                links = tuple(part.link for p in verdict.places for part in named[p.link].parts)
                if odd.isdisjoint(links):
                    yield from ((*each, links) for each in _told(verdict, named, bodies))


def _joint_name(body: XmlBody) -> Located:
    return body.joint.name if body.joint is not None else body.link.name


def _parent_name(body: XmlBody) -> Located:
    """Return where the joint that carries a body names its parent."""
    island = body.carrier.joint.island if body.carrier is not None else None
    return island.reference("parent") if isinstance(island, RobotIsland) else body.link.name


def _told(
    verdict: LimbVerdict, named: Mapping[str, XmlBody], bodies: Sequence[XmlBody]
) -> Iterator[tuple[str, Finding]]:
    # The one of which it is known what is meant comes first.
    place = verdict.repairs[0].place if verdict.repairs else verdict.places[0]
    body = named[place.link]
    meant = _meant(verdict, body, bodies[body.parent or 0])
    others = [(p, f"or {told(p)}") for p in verdict.places if p != place]
    if verdict.is_convicted:
        verb = "differ" if place.what == "moments" else "differs"
        message = f"{told(place)} {verb} from its twins{meant}"
        twins = [place._replace(link=twin) for twin in verdict.twins if twin in named]
        others += [(p, f"the same of '{p.link}'") for p in twins]
        code = "KD210" if place.what == "kind" else "KD509"
    elif meant:
        message = f"{told(place)} does not mirror the other side{meant}"
        code = "KD510"
    else:
        return
    related = (Related(_located(named[p.link], p), words) for p, words in others)
    yield code, Finding(_located(body, place), message, tuple(related))


def _meant(verdict: LimbVerdict, body: XmlBody, parent: XmlBody) -> str:
    """Return a translation as it would be written, nothing of anything else."""
    carrier = body.carrier
    if not verdict.repairs or carrier is None or not carrier.is_told:
        return ""
    (_, _, what), (meant, *_) = verdict.repairs[0]
    if what != "translation" or written_pose(carrier.joint.pose, {}) is None:
        return ""
    x, y, z = meant
    part = next(p for p in parent.parts if p.link.name == carrier.parent)
    there = part.pose.inverse().point(parent.axis_pose.turn((x, y, z)))
    return f": it would be {' '.join(f'{round(each, 9) + 0.0:.5g}' for each in there)}"


def _located(body: XmlBody, place: Suspect) -> Located:
    """Return where a finding on numbers of a limb is shown."""
    inertia = body.heaviest.link.inertia
    if place.what in OF_A_LINK and inertia is not None:
        return inertia
    return (body.joint.pose.translation if body.joint is not None else None) or _joint_name(body)


def _limbs_in(bodies: Sequence[XmlBody]) -> Iterator[Limbs]:
    """Yield the groups of limbs of a robot that are meant to be alike.

    In each limb a link's frame is turned with its joint's axis, which is z.
    """
    carried: list[list[Body | None]] = [[] for _ in bodies]
    for body, below in zip(reversed(bodies), reversed(carried), strict=True):
        known = [each for each in reversed(below) if each is not None]
        yield from groups_of(known)
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
    return assembled(*names, carrier.joint.kind, pose, turns, carried)
