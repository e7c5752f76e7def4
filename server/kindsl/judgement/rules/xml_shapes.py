"""Doubts about the shape of bodies in XML, and parts of two sides that differ, in XML's words."""

from collections.abc import Container, Iterator, Sequence
from math import sqrt

from kindsl.judgement.diagnosis.body_verdicts import (
    GREATEST_LENGTH,
    OF_LENGTH,
    BodyDoubt,
    body_verdicts,
)
from kindsl.judgement.diagnosis.counterparts import (
    images,
    is_mirror_image,
    is_same_body,
    unlike_numbers,
)
from kindsl.judgement.diagnosis.unlike import APART, EXACTLY, unlike_among
from kindsl.judgement.rules.base import Finding, Related, Severity
from kindsl.judgement.rules.context import Context
from kindsl.judgement.rules.geometry import converted, is_partly_in_metres
from kindsl.judgement.rules.inertia.mirror_images import sided_pairs, unlike_pairs
from kindsl.judgement.rules.inertia.told_causes import told_causes
from kindsl.judgement.rules.limb_places import numbers_at
from kindsl.judgement.rules.limb_writing import as_numbers, rewriting
from kindsl.judgement.rules.registry import rules_with
from kindsl.judgement.rules.units import LENGTH_UNITS
from kindsl.judgement.rules.xml_bodies import XmlBody, far_coms, far_joint, odd_links, reach_of
from kindsl.judgement.rules.xml_elements import in_words_of_xml, is_without_limits, limited_joints
from kindsl.judgement.rules.xml_fixes import set_as
from kindsl.language.semantics.declarations import Link, Vector
from kindsl.language.semantics.expressions import Expression
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.numbers import mass_distribution, pose_of_com
from kindsl.language.semantics.unknown import Unknown
from kindsl.language.text.phrases import alternatives
from kindsl.mechanics.rigid.body import MassDistribution
from kindsl.mechanics.rigid.pose import IDENTITY
from kindsl.robots.interchange.xml_document import xml_of
from kindsl.robots.limbs.names import label_of
from kindsl.robots.limbs.weighing import Suspect
from kindsl.robots.mechanism.link_inertia import link_inertia

_OF_LIMBS = frozenset(("KD208", "KD209", "KD210", "KD509", "KD510"))
# Of names that are there twice nobody knows which is meant.
_BY_NAME = frozenset(("KD208", "KD209"))
_MILLIMETRES = 1000.0  # in a metre
_SHAPES = ("KD309", "KD313", "KD511")
_CAUSES = ("KD307", "KD308", "KD314")
# From which probability on a cause is told, signs of an impossible body apart, and fixed: of those
# at 90 to 95 % 6 of 9 restore the robot, of likelier ones 89 of 93.
LIKELY = 0.95
# Of two parts either may be wrong.
_ENOUGH = 2

Found = Iterator[tuple[str, Finding]]


def body_findings(model: Model, bodies: Sequence[XmlBody], context: Context) -> Found:
    """Yield what is found of bodies and limbs, with the codes of the rules that tell it.

    Args:
        context: Without values, since XML has no parameters.
    """
    far = [_in_another_unit(model, com, is_com=True) for _, com in far_coms(bodies)]
    joints = filter(None, (far_joint(body, bodies) for body in bodies))
    far += (_in_another_unit(model, joint, is_com=False) for joint in joints)
    odd = odd_links(model, bodies)
    far += _far_slides(model, bodies)
    yield from (("KD502", finding) for finding in far)
    for code, cause in told_causes(model, context):
        is_sign_of_impossible = code == "KD307" and cause.severity is Severity.INFORMATION
        is_likely = bool(cause.also) or (cause.probability or 0.0) >= LIKELY
        if code in _CAUSES and (is_sign_of_impossible or is_likely):
            others = (
                each._replace(message=in_words_of_xml(each.message)) for each in cause.related
            )
            told = in_words_of_xml(cause.message)
            yield code, cause._replace(message=told, related=tuple(others))
    told_of, branches = set(odd), _branches(bodies)
    yield from _limb_findings(model, context) if branches else ()
    accused = _accused(model, context) if branches else set()
    # What a misplaced joint is an end of has another shape than its own.
    of_joints = [b.parent for b in bodies if (b.link.name, "translation") in accused]
    slides = (b for b in bodies if b.joint is not None and b.joint.kind == "prismatic")
    rails = {b.parent for b in slides}
    for n, body in enumerate(bodies):
        links = {part.link for part in body.parts}
        is_shaped = body.moves and not links & odd and n not in of_joints
        left_out = OF_LENGTH if n in rails else frozenset[BodyDoubt]()
        shapes = list(_shapes(body, left_out)) if is_shaped else []
        yield from shapes
        if shapes or any(body.link.name == name for name, _ in accused):
            told_of |= links
    for link, finding in _unlike(model, told_of):
        told_of.add(link)
        yield "KD509", finding
    massless = (b for b in bodies if b.moves and b.mass is not None and not b.mass.mass)
    told_of |= {part.link for body in massless for part in body.parts}
    for finding in unlike_pairs(model, {}, _as_written, told_of.__contains__):
        yield "KD312", finding._replace(message=in_words_of_xml(finding.message))
    for finding in _moved_unmirrored(model, told_of):
        yield "KD312", finding


def _branches(bodies: Sequence[XmlBody]) -> bool:
    parents = [body.parent for body in bodies if body.parent is not None]
    return len(parents) > len(set(parents))


def _limb_findings(model: Model, context: Context) -> Found:
    """Yield what does not fit in limbs, as the rules of a document tell it."""
    # Imported for branches only, since they delay the linter's start.
    codes = {flaw.code for flaw in xml_of(model.document).flaws}
    if "KD202" in codes:
        return  # One of its limbs carries what is another's.
    is_unique = codes.isdisjoint(("KD102", "KD103"))
    for rule in rules_with(_OF_LIMBS if is_unique else _OF_LIMBS - _BY_NAME):
        for finding in rule.check_document(model, context) if rule.check_document else ():
            yield rule.code, finding._replace(message=in_words_of_xml(finding.message))


def _accused(model: Model, context: Context) -> set[tuple[str, str]]:
    """Return the links of which limbs tell something, and what of them."""
    from kindsl.judgement.rules.limb_verdicts import limb_slips

    verdicts = limb_slips(model, context).verdicts
    return {(place.link, place.what) for verdict in verdicts for place in verdict.places}


def _shapes(body: XmlBody, left_out: Container[BodyDoubt]) -> Found:
    """Yield what is doubtful about where a body's mass is; the greatest part is to blame."""
    mass, inertia = body.mass, body.heaviest.link.inertia
    if mass is None or inertia is None or not body.ends:
        return  # A frame alone tells no length: it may be a sensor's.
    frames = tuple(part.pose.translation for part in body.parts[1:])
    for verdict in body_verdicts(str(body.link.name), mass, body.ends, frames):
        if verdict.code in _SHAPES and verdict.kind not in left_out:
            yield verdict.code, Finding(inertia, verdict.sentence)


def _greatest(vector: Vector) -> float:
    return max(abs(component.literal or 0.0) for component in vector.components)


def _in_another_unit(model: Model, vector: Vector, is_com: bool) -> Finding:
    # Imported for these only, since it delays the linter's start.
    from kindsl.judgement.diagnosis.slips import likely_lengths

    likely = likely_lengths(_greatest(vector))
    units, probability = [LENGTH_UNITS[unit] for unit, _ in likely], likely[0][1]
    farthest = max(vector.components, key=lambda each: abs(each.literal or 0.0))
    told = f"length {farthest.text} m is implausible"
    if not is_com and is_partly_in_metres(model, vector):
        return Finding(farthest, told)
    told += f"; is it in {alternatives(n for n, _ in units)}?"
    fixes = [converted(vector, factor, is_com=is_com) for _, factor in units]
    if probability >= LIKELY:
        return Finding(farthest, told, fix=fixes[0], probability=probability)
    choices = (
        fix._replace(title=f"Convert {name} to metres")
        for fix, (name, _) in zip(fixes, units, strict=True)
        if fix is not None
    )
    return Finding(farthest, told, choices=tuple(choices), probability=probability)


def _far_slides(model: Model, bodies: Sequence[XmlBody]) -> Iterator[Finding]:
    """Yield the slides whose way in millimetres is nearer to the robot's reach than in metres."""
    carriers = {
        str(b.joint.name): bodies[b.parent] for b in bodies if b.joint and b.parent is not None
    }
    reach = reach_of(bodies)
    for joint in limited_joints(model):
        ends = [end for end in (joint.lower, joint.upper) if end is not None]
        carrier, far = carriers.get(joint.name), max(map(abs, ends), default=0.0)
        is_far = far > GREATEST_LENGTH and reach > 0.0 and far > sqrt(_MILLIMETRES) * reach
        # What stands in a world may go anywhere.
        is_carried = carrier is not None and carrier.mass is not None
        if joint.kind == "prismatic" and is_far and is_carried and not is_without_limits(ends):
            worst = max(ends, key=abs)
            at = joint.at("upper" if worst == joint.upper else "lower")
            told = f"limit {worst:g} m of joint '{joint.name}' is implausible; "
            yield Finding(at, f"{told}is it in millimetres?")


def _unlike(model: Model, told_of: Container[Link]) -> Iterator[tuple[Link, Finding]]:
    """Yield the parts that differ in one way from two others or more, which are all alike."""
    for link, body, peers, within, _ in unlike_among(model, _as_written):
        inertia = link.inertia
        if link in told_of or inertia is None or len(peers) < _ENOUGH:
            continue
        odd = min(([*unlike_numbers(body, i, within)] for i in images(peers[0][1])), key=len)
        others = [Related(t.inertia, f"inertia of '{t.name}'") for t, _ in peers if t.inertia]
        verb = "differ" if odd[-1] == "moments" else "differs"
        name = f"{' and '.join(odd)} of '{link.name}'"
        what, fix = f"{name} {verb} from its twins", None
        if len(odd) == 1 and (like := _of_same_side(model, link, odd[0], peers)):
            own, theirs = like
            fix = rewriting(f"Set {name} to that of its twins", own, [e.text for e in theirs])
            if odd[0] != "moments":
                what = f"{name} is {as_numbers(own)}, by its twins {as_numbers(theirs)}"
        elif made := set_as(model, link, [peer for peer, _ in peers]):
            fix = made.fix
        yield link, Finding(inertia, what, tuple(others), fix)


def _moved_unmirrored(model: Model, told_of: Container[Link]) -> Iterator[Finding]:
    """Yield the pairs that had either CoM or products mirrored before these were moved to it."""
    for left, right in sided_pairs(model):
        if left in told_of or right in told_of:
            continue
        here, there = _as_written(left), _as_written(right)
        if here is None or there is None or is_mirror_image(here, there, APART):
            continue
        ours, theirs = link_inertia(left, {}), link_inertia(right, {})
        if isinstance(ours, Unknown) or isinstance(theirs, Unknown):
            continue
        is_apart = not is_same_body(_sizes(here), _sizes(there), EXACTLY)
        if is_apart and is_same_body(_sizes(ours), _sizes(theirs), EXACTLY):
            told = f"'{right.name}' is not the mirror image of '{left.name}': about the links' "
            told += "origins they agree but for signs of the CoM or the products"
            related = Related(left.inertia or left, f"inertia of '{left.name}'")
            yield Finding(right.inertia or right, told, (related,))


def _sizes(body: MassDistribution) -> MassDistribution:
    x, y, z = map(abs, body.com)
    xx, yy, zz, xy, xz, yz = map(abs, body.moments)
    return MassDistribution(body.mass, (x, y, z), (xx, yy, zz, xy, xz, yz))


def _of_same_side(
    model: Model, link: Link, odd: str, peers: Sequence[tuple[Link, MassDistribution]]
) -> tuple[Sequence[Expression], Sequence[Expression]] | None:
    """Return numbers of a part and those of its peers of the same side, None if these differ.

    On the other side, or in other rows, frames may lie in other ways.
    """
    place = Suspect(str(link.name), "", odd.lower())
    side = label_of(place.link).side
    same = [str(t.name) for t, _ in peers if label_of(str(t.name)).side == side]
    own, *like = (numbers_at(model, place._replace(link=each)) for each in (place.link, *same))
    as_read = {tuple(e.literal for e in numbers) for numbers in like}
    return (own, like[0]) if len(like) >= _ENOUGH and len(as_read) == 1 and own else None


def _as_written(link: Link, _: object = None) -> MassDistribution | None:
    """Return mass, CoM and the six numbers as they stand in the file; None if axes are turned."""
    inertia, pose = link.inertia, pose_of_com(link, {})
    written = mass_distribution(inertia, {}) if inertia is not None else None
    if written is None or pose is None or pose.rotation != IDENTITY.rotation:
        return None
    xx, yy, zz, xy, xz, yz = written.moments
    return MassDistribution(
        written.mass, pose.translation, (xx, yy, zz, 0.0 - xy, 0.0 - xz, 0.0 - yz)
    )
