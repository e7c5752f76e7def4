"""Doubts about the shape of bodies in XML, and parts of two sides that differ, in XML's words."""

import re
from collections.abc import Iterator, Mapping, Sequence

from kindsl.judgement.diagnosis.judgements import IMPOSSIBLE, Verdict, judgements
from kindsl.judgement.rules.base import Finding, Related
from kindsl.judgement.rules.context import Context
from kindsl.judgement.rules.inertia.mirror_images import mirror_difference
from kindsl.judgement.rules.inertia.told_causes import told_causes
from kindsl.judgement.rules.limb_places import OF_A_LINK, told
from kindsl.judgement.rules.xml_bodies import XmlBody, limbs_in, moving_joint
from kindsl.language.semantics.declarations import Link
from kindsl.language.semantics.lowering import declarations
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.numbers import mass_distribution, written_pose
from kindsl.language.semantics.places import Located
from kindsl.mechanics.rigid.body import (
    MassDistribution,
    seen_from,
)
from kindsl.mechanics.rigid.pose import IDENTITY
from kindsl.robots.limbs.attachments import Attachment, LimbNames
from kindsl.robots.limbs.comparison import Tolerance
from kindsl.robots.limbs.mounts import REFLECTIONS
from kindsl.robots.limbs.names import label_of, other_side
from kindsl.robots.limbs.slips import n_retyped
from kindsl.robots.limbs.verdicts import ComparedLimbs, LimbVerdict, verdicts
from kindsl.robots.limbs.weighing import Suspect, differing, seen_by
from kindsl.robots.mechanism.body_verdicts import body_verdicts

_NEARLY = Tolerance(5e-4, 0.05, 0.05)
_MOMENT = re.compile(r"\bI([xyz])([xyz]?)\b(?=(?:[^']*'[^']*')*[^']*$)")
_SHAPES = ("KD309", "KD313", "KD511")
_CAUSES = ("KD307",)

Found = Iterator[tuple[str, Finding]]


def body_findings(model: Model, bodies: Sequence[XmlBody], context: Context) -> Found:
    """Yield what is found of bodies and limbs, with the codes of the rules that tell it.

    Args:
        model: A robot in XML.
        bodies: Its bodies.
        context: Without values, since XML has no parameters.
    """
    odd = _odd(model, context)
    for code, cause in told_causes(model, context):
        if code in _CAUSES:
            yield code, cause._replace(message=in_words_of_xml(cause.message))
    for body in bodies:
        if body.moves and not any(part.link in odd for part in body.parts):
            yield from _shapes(body)
    limbs = list(_limb_findings(bodies, odd))
    yield from ((code, finding) for code, finding, _ in limbs)
    yield from _mirrored(model, {*odd, *(link for *_, links in limbs for link in links)})


def in_words_of_xml(message: str) -> str:
    """Return a sentence with moments as XML calls them, names in quotes as they are."""
    return _MOMENT.sub(lambda found: f"i{found[1]}{found[2] or found[1]}", message)


def _odd(model: Model, context: Context) -> set[Link]:
    """Return the parts whose inertia is impossible, or of no material: more is not said of them."""
    odd = {*IMPOSSIBLE, Verdict.IMPLAUSIBLE}
    found = (j for i in model.islands for j in judgements(declarations(i), context.values))
    return {each.link for each in found if each.verdict in odd}


def _shapes(body: XmlBody) -> Found:
    """Yield what is doubtful about where a body's mass is; the greatest part is to blame."""
    mass, inertia = body.mass, body.heaviest.link.inertia
    if mass is None or inertia is None or not body.ends:
        return  # A frame alone tells no length: it may be a sensor's.
    frames = tuple(part.pose.translation for part in body.parts[1:])
    for verdict in body_verdicts(str(body.link.name), mass, body.ends, frames):
        if verdict.code in _SHAPES:
            yield verdict.code, Finding(inertia, verdict.sentence)


def _mirrored(model: Model, told_of: set[Link]) -> Found:
    """Yield parts of the right side whose numbers are nearly those of the left one."""
    links = {str(link.name): link for link in reversed(model.links)}
    for name, left in links.items():
        right = links.get(other_side(name) or "") if label_of(name).side == "L" else None
        if right is None or left in told_of or right in told_of:
            continue
        here, there = _as_written(left), _as_written(right)
        if here is None or there is None or _are_images(left, right):
            continue
        difference = mirror_difference((name, str(right.name)), here, there)
        if difference and right.inertia is not None and left.inertia is not None:
            related = Related(left.inertia, f"inertia of '{name}'")
            yield "KD312", Finding(right.inertia, in_words_of_xml(difference), (related,))


def _as_written(link: Link) -> MassDistribution | None:
    """Return mass, CoM and the six numbers as they stand in the file; None if axes are turned."""
    inertia, frame = link.inertia, next(iter(link.frames), None)
    written = mass_distribution(inertia, {}) if inertia is not None else None
    pose = written_pose(frame.pose, {}) if frame is not None else None
    if written is None or pose is None or pose.rotation != IDENTITY.rotation:
        return None
    xx, yy, zz, xy, xz, yz = written.moments
    return MassDistribution(
        written.mass, pose.translation, (xx, yy, zz, 0.0 - xy, 0.0 - xz, 0.0 - yz)
    )


def _are_images(left: Link, right: Link) -> bool:
    here, there = (_as_written(link) for link in (left, right))
    assert here is not None and there is not None, "else nothing is compared"
    return any(not differing(seen_by(here, C), there, _NEARLY) for C in REFLECTIONS)


def _limb_findings(
    bodies: Sequence[XmlBody], odd: set[Link]
) -> Iterator[tuple[str, Finding, tuple[Link, ...]]]:
    """Yield numbers of limbs that do not fit the others, and the links that these are of."""
    named = {str(body.link.name): body for body in bodies}
    pairs = ((body, bodies[body.parent]) for body in bodies if body.parent is not None)
    names = LimbNames(
        [
            Attachment(str(b.link.name), str(parent.link.name), str(joint.name))
            for b, parent in pairs
            if (joint := moving_joint(b)) is not None
        ]
    )
    if names.elsewhere or names.crossed:
        return
    masses = {
        name: seen_from(body.mass, body.axis_pose.inverse())
        for name, body in named.items()
        if body.mass is not None
    }
    for limbs in limbs_in(bodies):
        compared = ComparedLimbs(limbs)
        for group in (compared, *compared.held):
            for verdict in verdicts(group, masses):
                links = tuple(part.link for p in verdict.places for part in named[p.link].parts)
                if not any(link in odd for link in links):
                    body = named[_accused(verdict).link]
                    meant = _meant(verdict, body, bodies[body.parent or 0])
                    for code, finding in _of_limbs(verdict, named, meant):
                        yield code, finding, links


def _of_limbs(verdict: LimbVerdict, named: Mapping[str, XmlBody], meant: str) -> Found:
    place = _accused(verdict)
    at = _located(named[place.link], place)
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
    yield code, Finding(at, message, tuple(related))


def _accused(verdict: LimbVerdict) -> Suspect:
    """Return the place that is told first: the one of which it is known what is meant."""
    return verdict.repairs[0].place if verdict.repairs else verdict.places[0]


def _meant(verdict: LimbVerdict, body: XmlBody, parent: XmlBody) -> str:
    """Return a translation as it would be written, nothing of anything else.

    Of two sides only a sign, an order or a unit tells that one is wrong.
    """
    meant = verdict.repairs[0].meant[0] if verdict.repairs else ()
    if _accused(verdict).what != "translation" or len(meant) != 3 or body.carrier is None:
        return ""
    if not body.carrier.is_told:
        return ""
    x, y, z = meant
    carrier = next(p for p in parent.parts if p.link.name == body.carrier.parent)
    there = carrier.pose.inverse().point(parent.axis_pose.turn((x, y, z)))
    own = written_pose(body.carrier.joint.pose, {})
    if own is None or (not verdict.is_convicted and n_retyped(own.translation, there)):
        return ""
    return f": it would be {' '.join(f'{_clean(each):.5g}' for each in there)}"


def _clean(value: float) -> float:
    return round(value, 9) + 0.0


def _located(body: XmlBody, place: Suspect) -> Located:
    """Return where a finding on numbers of a limb is shown."""
    joint, inertia = moving_joint(body), body.heaviest.link.inertia
    if place.what in OF_A_LINK and inertia is not None:
        return inertia
    vector = joint.pose.translation if joint is not None else None
    return vector or (joint.name if joint is not None else body.link.name)
