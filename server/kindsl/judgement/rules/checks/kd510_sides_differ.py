"""A number of the left limb does not mirror the right one.

## What it does
Compares a left and a right limb, when there are no more that could outvote one of them. Where a
single translation or rotation keeps them from being mirror images, or copies, and a sign, an order,
a unit or a quarter turn explains it, or in limbs of three links and more one number that was typed
otherwise, both are reported in one finding; so are two limbs that are at one place, away from the
plane in which they turn, or with bodies that would be alike on both sides of one. In XML the axis
of one joint may differ as well, in limbs of three links and more. Where all joints agree, it is one
CoM that a sign or an order of its coordinates keeps from that of the other side.

A right limb that is a copy of the left one is reported where the robot's other limbs are mirrored,
unless the limb is flat. A base that lies at one of the two limbs is left in peace: no plane is
between them.

## Why is this bad?
One of the two is wrong: the robot is not symmetric, though it looks so. Which of them is right
only the author can tell.

## Example
```kindsl
r_joint left_elbow  { ref_frame { translation = (0.3, 0.0, 0.02) ... } }
r_joint right_elbow { ref_frame { translation = (0.03, 0.0, 0.02) ... } }
```
"""

from collections.abc import Iterator
from itertools import chain

from kindsl.judgement.rules.base import Finding, Fix, Related, Rule, Severity
from kindsl.judgement.rules.context import Context
from kindsl.judgement.rules.inertia.shapes import is_told_of
from kindsl.judgement.rules.limb_places import OF_A_LINK, joint_of, located, numbers_at, phrase
from kindsl.judgement.rules.limb_verdicts import copied_limbs, limb_slips
from kindsl.judgement.rules.limb_writing import as_numbers, retyped, rewriting
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.model import Model
from kindsl.robots.limbs.limb import names_of
from kindsl.robots.limbs.weighing import LimbVerdict, MeantNumbers


def check_document(model: Model, context: Context) -> Iterator[Finding]:
    yield from _of_copies(model, context)
    for verdict in limb_slips(model, context).verdicts:
        if not verdict.is_convicted and verdict.repairs:
            (here, meant), (there, _) = verdict.repairs
            bodies = [model.body_named[p.link] for p in verdict.places if p.what in OF_A_LINK]
            if any(is_told_of(body, model, context) for body in bodies):
                continue
            own, peer = numbers_at(model, here), numbers_at(model, there)
            if own and peer:
                like_peer = _texts(model, context, *verdict.repairs)
                message = f"{phrase(here)} is {as_numbers(own)}, " + (
                    f"by {phrase(there)} it would be {as_numbers(like_peer)}"
                    if like_peer
                    else f"and {phrase(there)} {as_numbers(peer)}"
                )
                if not meant:
                    message = f"{phrase(here)} and {phrase(there)} differ"
                message += ": one slip keeps the two sides from being alike"
                places = [place for place in verdict.places if place != here]
                others = [Related(located(model, place), phrase(place)) for place in places]
                choices = tuple(_choices(model, context, verdict))
                yield Finding(located(model, here), message, tuple(others), choices=choices)


def _of_copies(model: Model, context: Context) -> Iterator[Finding]:
    """Yield a finding for a right limb that is a copy where all others are mirrored.

    One number that keeps it from being mirrored is told better.
    """
    verdicts = (v for v in limb_slips(model, context).verdicts if not v.is_convicted)
    slips = {place.link for each in verdicts for place in each.places}
    for pair in copied_limbs(model, context):
        left, right = (joint_of(model, body.name) for body in (pair.left, pair.right))
        is_told = not slips.isdisjoint(chain(names_of(pair.left), names_of(pair.right)))
        if left is not None and right is not None and not is_told:
            message = f"limb '{pair.right.name}' is a copy of '{pair.left.name}', not its mirror "
            message += "image as the other limbs of this robot are"
            related = Related(left.name, f"joint '{left.name}' of the other side")
            yield Finding(right.name, message, (related,))


def _choices(model: Model, context: Context, verdict: LimbVerdict) -> Iterator[Fix]:
    """Yield what makes the sides alike, if the place is known: the one written as the other."""
    for repair, other in (verdict.repairs, verdict.repairs[::-1]):
        fix = _fix(model, context, repair, other)
        if fix is not None and len(verdict.places) == 2:
            yield fix


def _fix(model: Model, context: Context, repair: MeantNumbers, other: MeantNumbers) -> Fix | None:
    texts = _texts(model, context, repair, other)
    if texts is None:
        return None
    title = f"Set {phrase(repair.place)} to {as_numbers(texts)}"
    return rewriting(title, numbers_at(model, repair.place), texts)


def _texts(
    model: Model, context: Context, repair: MeantNumbers, other: MeantNumbers
) -> tuple[str, ...] | None:
    """Return the numbers at a place as the other side has them, None where none can be written."""
    if not repair.meant:
        return None
    own, peer = numbers_at(model, repair.place), numbers_at(model, other.place)
    assignments, what = limb_slips(model, context).assignments, repair.place.what
    return retyped(own, [peer], repair.meant, assignments, what=what)


RULE = Rule(__name__, Severity.WARNING, check_document=check_document, reads=Aspect.NUMBERS)
