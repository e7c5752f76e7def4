"""A number of one limb differs from its twins.

## What it does
Compares limbs that are meant to be alike: three or more legs, arms or fingers of one body, told
apart by sides and rows (`LF_hip`, `RH_hip`) or by numbers (`leg3_coxa`). Link frames of mirrored
limbs may lie in other ways; what counts is whether some mirroring or turning of the limb makes all
numbers those of its twins. Where all limbs agree but one, and one translation or rotation of it,
or the axis of one joint in XML, would make it agree too, that one is reported; where all joints
agree, the mass, the centre of mass and the moments that one limb only has so.
Bodies whose numbers are not copied but measured each by itself may differ by 5 %, and by five times
what the others do among themselves.

Links that two others or more are images of but for one mistake, such as a sign, a unit or two
moments swapped, count as twins whatever their names: equal digits tell that parts are equal. The
mistake is told with its probability.

## Why is this bad?
Limbs are copied and then edited by hand. A sign that was forgotten or a number that was changed in
one limb only makes a robot that looks right and moves wrong.

Limbs that differ in several places are meant to differ, and are left in peace. Hands and tools are
compared by themselves: they may be mounted in any way. Parameters count as equal where they have
the same name.

## Example
```kindsl
r_joint LF_HFE { ref_frame { translation = (0.08, 0.0, 0.0) ... } }
r_joint RF_HFE { ref_frame { translation = (0.08, 0.0, 0.0) ... } }
r_joint LH_HFE { ref_frame { translation = (0.08, 0.0, 0.0) ... } }
r_joint RH_HFE { ref_frame { translation = (0.8, 0.0, 0.0) ... } }
```

## Fix
Writes what the twins have at the place, if it is the only one that explains the difference. The
fix is unsafe: it changes the robot. There is none where the twins' inertias are impossible, nor
where the whole limb is a copy of the other side (KD510).
"""

from collections.abc import Iterator

from kindsl.judgement.diagnosis.judgements import TEN, is_impossible, is_round, keyword
from kindsl.judgement.rules.base import Finding, Fix, Related, Rule, Severity
from kindsl.judgement.rules.context import Context
from kindsl.judgement.rules.inertia.told_causes import explained, has_cause, told_causes
from kindsl.judgement.rules.limb_places import (
    OF_A_LINK,
    PARTS,
    located,
    numbers_at,
    phrase,
    place_at,
)
from kindsl.judgement.rules.limb_verdicts import copied_limbs, limb_slips
from kindsl.judgement.rules.limb_writing import as_numbers, retyped, rewriting
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.declarations import Link
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.numbers import frame_of_com, written_pose
from kindsl.mechanics.rigid.body import MassDistribution, seen_from
from kindsl.robots.limbs.comparison import LOOSE
from kindsl.robots.limbs.limb import names_of
from kindsl.robots.limbs.weighing import LimbVerdict
from kindsl.robots.mechanism.link_inertia import link_inertia, written_inertia

_MOST_NAMED = 2
# Of where a CoM lies, which the peers tell with the number that is meant.
_OF_A_COM = frozenset(("KD309", "KD511"))
_THEIRS = "would be theirs"


def check_document(model: Model, context: Context) -> Iterator[Finding]:
    verdicts = limb_slips(model, context).verdicts
    accused = [model.body_named[v.places[0].link].inertia for v in verdicts if v.is_convicted]
    places = {keyword(inertia) for inertia in accused if inertia is not None}
    for finding in explained(model, context, "KD509"):
        # Limbs lie in known ways: what they say of one of them is surer than what may be.
        if finding.fix or places.isdisjoint((finding.at, *(each.at for each in finding.related))):
            yield finding
    for verdict in verdicts:
        place = verdict.places[0]
        if verdict.is_convicted and place.what != "kind":
            if place.what in OF_A_LINK and _is_told_better(model, context, verdict):
                continue
            message, fix = _message(model, context, verdict)
            if fix is not None and _is_of_copy(model, context, place.link):
                fix = None
            if fix is None and has_cause(model, context, model.body_named[place.link]):
                continue
            others = [Related(located(model, p), f"or {phrase(p)}") for p in verdict.places[1:]]
            peers = [place_at(model, peer, place.what) for peer in verdict.peers]
            others += [Related(located(model, p), phrase(p)) for p in peers]
            explains = _OF_A_COM if place.what == "com" else frozenset()
            yield Finding(located(model, place), message, tuple(others), fix, explains=explains)


def _is_of_copy(model: Model, context: Context, link: str) -> bool:
    """Return whether a link is of a limb that is a copy of the other side as a whole (KD510)."""
    sides = (side for pair in copied_limbs(model, context) for side in (pair.left, pair.right))
    return any(link in names_of(side) for side in sides)


def _message(model: Model, context: Context, verdict: LimbVerdict) -> tuple[str, Fix | None]:
    place = verdict.places[0]
    own, texts = numbers_at(model, place), _texts(model, context, verdict, LOOSE.share)
    changed = [i for i, text in enumerate(texts) if text != own[i].text]
    is_of_many = place.what in ("moments", "inertia")
    verb = "differ" if place.what == "moments" else "differs"
    if not changed:
        why = _why(model, context, verdict) if is_of_many and verdict.repairs else ""
        return f"{' or '.join(map(phrase, verdict.places))} {verb} from its twins{why}", None
    may_be_right = place.what in OF_A_LINK and _are_impossible(model, context, verdict.peers)
    if place.what == "inertia" and all(
        x.text.lstrip("-") == y.lstrip("-") for x, y in zip(own, texts, strict=True)
    ):
        turned = phrase(place._replace(what="angles"))
        return f"signs of {phrase(place)} differ from its twins, unless {turned} is wrong", None
    name, here, there = phrase(place), as_numbers(own), as_numbers(texts)
    # Where moments are about the CoM, those of another part have another place as well.
    is_about_com = frame_of_com(model.body_named[place.link]) is not None
    is_alone = place.what in ("mass", "com") and not is_about_com
    if is_alone and (copy := _copied(model, verdict)):
        whole = phrase(place._replace(what="inertia"))
        return f"{whole} differs from its twins: {copy}", None
    if is_of_many and is_about_com:
        return f"{name} {verb} from its twins", _taken_over(model, context, verdict, may_be_right)
    if is_of_many:
        why = _why(model, context, verdict)
        if why or len(changed) > _MOST_NAMED:
            fix = _taken_over(model, context, verdict, may_be_right)
            return f"{name} {verb} from its twins{why}", fix
        names = [TEN[PARTS[place.what]][i] for i in changed]
        name = f"{' and '.join(names)} of '{place.link}'"
        here = " and ".join(own[i].text for i in changed)
        there = " and ".join(texts[i] for i in changed)
    message = f"{name} {'are' if ' and ' in here else 'is'} {here}, by its twins {there}"
    if may_be_right:
        return f"{message}, which are physically impossible", None
    return message, rewriting(f"Set {name} to {there}", own, texts)


def _taken_over(
    model: Model, context: Context, verdict: LimbVerdict, may_be_right: bool
) -> Fix | None:
    place = verdict.places[0]
    own, texts = numbers_at(model, place), _texts(model, context, verdict, 0.0)
    if may_be_right or not texts:
        return None
    return rewriting(f"Set {phrase(place)} to that of its twins", own, texts)


def _texts(model: Model, context: Context, verdict: LimbVerdict, share: float) -> tuple[str, ...]:
    """Return the numbers of the peers as they should be written, none where that is not known.

    Inertias are compared loosely, and so the peer's last digits are not those meant: the author's
    own are kept that differ by no more than a share of the greatest.
    """
    place = verdict.places[0]
    own = numbers_at(model, place)
    if not own or not verdict.repairs:
        return ()
    places = [place_at(model, peer, place.what) for peer in verdict.peers]
    peers = [numbers for p in places if (numbers := numbers_at(model, p))]
    assignments = limb_slips(model, context).assignments
    kinds = list(PARTS.values())[:3] if place.what == "inertia" else [slice(len(own))]
    kinds = kinds if place.what in OF_A_LINK else []
    meant = verdict.repairs[0].meant
    return retyped(own, peers, meant, assignments, kinds, share, place.what) or ()


def _copied(model: Model, verdict: LimbVerdict) -> str:
    # Imported for a misfit only, since it delays the linter's start.
    from kindsl.judgement.rules.inertia.unlike_peers import copied_from

    return copied_from(model, model.body_named[verdict.places[0].link], verdict.peers)


def _why(model: Model, context: Context, verdict: LimbVerdict) -> str:
    """Return what was done to the moments of a body, if its peers and other links tell."""
    # Imported for a misfit only, since it delays the linter's start.
    from kindsl.judgement.rules.inertia.told import clause
    from kindsl.judgement.rules.inertia.unlike_peers import copied_from, slip_of

    place, body = verdict.places[0], model.body_named[verdict.places[0].link]
    said = f"{'they' if place.what == 'moments' else 'it'} {_THEIRS}"
    why = copied_from(model, body, verdict.peers)
    seen, own = link_inertia(body, context.values), body.inertia
    written = written_inertia(own, context.values) if own is not None else None
    if not why and isinstance(seen, MassDistribution) and isinstance(written, MassDistribution):
        if is_round(written.moments):
            return f": Ix, Iy and Iz are all {written.moments[0]:g}, a placeholder"
        meant = [*seen.numbers]
        meant[PARTS[place.what]] = verdict.repairs[0].meant[0]
        slip = slip_of(written, _as_written(body, MassDistribution.of(meant), context))
        why = f"{said} if {clause(slip)}" if slip is not None else ""
    return why and f": {why}"


def _as_written(body: Link, meant: MassDistribution, context: Context) -> MassDistribution:
    """Return a mass distribution in the frame in which that of a body is written."""
    name = body.inertia.frame if body.inertia is not None else None
    frame = next((f for f in body.frames if name is not None and f.name == name), None)
    pose = written_pose(frame.pose, context.values) if frame is not None else None
    return seen_from(meant, pose.inverse()) if pose is not None else meant


def _is_told_better(model: Model, context: Context, verdict: LimbVerdict) -> bool:
    """Return whether a cause is told that makes one of the limbs as the others, or looked for."""
    body = model.body_named[verdict.places[0].link]
    at = keyword(body.inertia) if body.inertia is not None else None
    for _, finding in told_causes(model, context):
        if finding.fix is not None and at in (finding.at, *(each.at for each in finding.related)):
            return True
    is_told = is_impossible(body, context.values)
    return is_told and not _are_impossible(model, context, verdict.peers)


def _are_impossible(model: Model, context: Context, peers: tuple[str, ...]) -> bool:
    return any(is_impossible(model.body_named[name], context.values) for name in peers)


RULE = Rule(__name__, Severity.WARNING, check_document=check_document, reads=Aspect.NUMBERS)
