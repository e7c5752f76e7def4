"""A number of one limb differs from its twins.

## What it does
Compares limbs that are meant to be alike: three or more legs, arms or fingers of one body, told
apart by sides and rows (`LF_hip`, `RH_hip`) or by numbers (`leg3_coxa`). Link frames of mirrored
limbs may lie in other ways; what counts is whether some mirroring or turning of the limb makes all
numbers those of its twins. Where all limbs agree but one, and one translation, rotation or centre
of mass of it would make it agree too, that one is reported.

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
fix is unsafe: it changes the robot. There is none where the twins' inertias are impossible.
"""

from collections.abc import Iterator

from kindsl.limbs.comparison import LOOSE
from kindsl.limbs.verdicts import LimbVerdict
from kindsl.rules.base import Example, Finding, Fix, Related, Rule, Severity
from kindsl.rules.context import Context
from kindsl.rules.examples import four_legs
from kindsl.rules.inertia.judgements import is_impossible
from kindsl.rules.inertia.mirror_images import mirror_difference
from kindsl.rules.inertia.shapes import shape_doubts
from kindsl.rules.inertia.twins import right_twin_of
from kindsl.rules.limb_places import OF_A_LINK, located, place_at, told, vector_at
from kindsl.rules.limb_verdicts import limb_slips
from kindsl.rules.limb_writing import as_triple, rewriting, written
from kindsl.semantics.aspects import Aspect
from kindsl.semantics.model import Model


def check_document(model: Model, context: Context) -> Iterator[Finding]:
    """Yield a finding for each limb that its twins outvote."""
    slips = limb_slips(model, context)
    for verdict in slips.verdicts:
        place = verdict.places[0]
        if verdict.is_convicted and place.what != "kind":
            if place.what in OF_A_LINK and _is_told_elsewhere(model, context, verdict):
                continue
            message, fix = _message(model, context, verdict)
            others = [Related(located(model, p), f"or {told(p)}") for p in verdict.places[1:]]
            twins = [place_at(model, twin, place.what) for twin in verdict.twins]
            others += [Related(located(model, p), told(p)) for p in twins]
            yield Finding(located(model, place), message, tuple(others), fix)


def _message(model: Model, context: Context, verdict: LimbVerdict) -> tuple[str, Fix | None]:
    place = verdict.places[0]
    own = vector_at(model, place)
    if own is None or not verdict.repairs:
        return f"{' or '.join(map(told, verdict.places))} differs from its twins", None
    places = [place_at(model, twin, place.what) for twin in verdict.twins]
    twins = [vector for p in places if (vector := vector_at(model, p)) is not None]
    assignments = limb_slips(model, context).assignments
    # Centres of mass are compared loosely, and so the twin's last digits are not those meant.
    within = (LOOSE,) if place.what in OF_A_LINK else ()
    texts = written(own, twins, verdict.repairs[0].meant, assignments, *within)
    if texts is None or texts == tuple(component.text for component in own.components):
        return f"{told(place)} differs from its twins", None
    message = f"{told(place)} is {as_triple(own)}, by its twins {as_triple(texts)}"
    if place.what in OF_A_LINK and _are_impossible(model, context, verdict.twins):
        return f"{message}, which are physically impossible", None
    return message, rewriting(f"Set {told(place)} to {as_triple(texts)}", own, texts)


def _is_told_elsewhere(model: Model, context: Context, verdict: LimbVerdict) -> bool:
    """Return whether the mass is reported as impossible, behind its joint, or beside its twin."""
    body = model.body_named[verdict.places[0].link]
    twins = [model.body_named[name] for name in verdict.twins]
    mirrored = [(body, t) for t in twins if right_twin_of(body) == t.name]
    mirrored += [(t, body) for t in twins if right_twin_of(t) == body.name]
    is_told = any(mirror_difference(left, right) for left, right in mirrored)
    is_behind = any(shape_doubts(body, model.tree.joints_on(body), context, "KD511"))
    return is_told or is_behind or is_impossible(body, context)


def _are_impossible(model: Model, context: Context, twins: tuple[str, ...]) -> bool:
    return any(is_impossible(model.body_named[name], context) for name in twins)


RULE = Rule(
    "KD509",
    "differs-from-twins",
    Severity.WARNING,
    check_document=check_document,
    reads=Aspect.STRUCTURE | Aspect.PLACES | Aspect.MASSES,
    good=(four_legs(), four_legs(LH="0.1, 0.0, 0.0", RH="0.1, 0.0, 0.0")),
    bad=(Example(four_legs(RH="0.8, 0.0, 0.0"), fixed=four_legs()),),
)
