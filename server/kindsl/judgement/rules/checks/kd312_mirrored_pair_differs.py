"""The inertias of a left part and its right twin differ.

## What it does
Compares links whose names are mirror images, `LF_hip` and `RF_hip`, `left_arm` and `right_arm`.
Where nearly all of the ten numbers of their inertias agree, it reports one or two that differ, and
signs that are not those of any turn or reflection of the axes.

## Why is this bad?
Such parts are copied and then edited by hand. One number that was changed on one side only, or one
sign that was forgotten, makes the robot drift to that side.

A slip that explains the difference, such as a sign, a unit or moments shifted twice, is told
instead, with its probability and its rivals on either side, and where many numbers differ, moments
that are those of another part. Parts with equal digits are compared whatever their names. Where
more pairs of a robot differ than agree, they are meant to.
Else many that differ were measured part by part and are not reported, nor are differences below 5 %
of the greatest number of their kind. Impossible inertias are left to
KD301 and KD302, a centre of mass behind its joint to KD511, and where more limbs than two are alike
and one differs, that is left to KD509.

## Example
```kindsl
link left_arm  { id = 1 inertia_params { mass = 1.24 ... } children {} }
link right_arm { id = 2 inertia_params { mass = 1.42 ... } children {} }
```
"""

from collections.abc import Iterator, Mapping
from functools import partial

from kindsl.judgement.diagnosis.counterparts import is_mirror_image
from kindsl.judgement.diagnosis.judgements import keyword
from kindsl.judgement.rules.base import Finding, Related, Rule, Severity
from kindsl.judgement.rules.context import Context
from kindsl.judgement.rules.inertia.mirror_images import mirror_difference, sided_pairs
from kindsl.judgement.rules.inertia.shapes import is_told_of
from kindsl.judgement.rules.inertia.told_causes import explained, has_cause
from kindsl.judgement.rules.limb_places import OF_A_LINK
from kindsl.judgement.rules.limb_verdicts import limb_slips
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.declarations import Link
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.unknown import Unknown
from kindsl.language.text.facts import Fact
from kindsl.robots.mechanism.link_inertia import link_inertia

_DIFFERENCES = Fact[tuple[object, tuple[str, bool]]]("differences of pairs")
_NEARLY = 0.05


def check_document(model: Model, context: Context) -> Iterator[Finding]:
    """Yield a finding for each mirrored pair in which one part has a slip."""
    yield from explained(model, context, "KD312")
    verdicts = limb_slips(model, context).verdicts
    told = {place.link for v in verdicts for place in v.places if place.what in OF_A_LINK}
    for left, right in sided_pairs(model):
        compare = partial(_difference, left, right, context.values)
        numbers, are_images = left.facts.made_of(_DIFFERENCES, (right, context.values), compare)
        if are_images or any(
            body.name in told
            or is_told_of(body, model, context)
            or has_cause(model, context, body, "KD312", "KD502", "KD509")
            for body in (left, right)
        ):
            continue
        found = _copied(model, left, right)
        if len(found) == 1:
            own, twin, message = found[0]
            yield _finding(own, twin, message)
        elif numbers:
            yield _finding(right, left, numbers)


def _difference(left: Link, right: Link, values: Mapping[str, float]) -> tuple[str, bool]:
    """Return the numbers that differ, in words, and whether all is alike or not known."""
    here, there = (link_inertia(body, values) for body in (left, right))
    if isinstance(here, Unknown) or isinstance(there, Unknown):
        return "", True
    numbers = mirror_difference((str(left.name), str(right.name)), here, there)
    return numbers, not numbers and is_mirror_image(here, there, _NEARLY)


def _copied(model: Model, *pair: Link) -> list[tuple[Link, Link, str]]:
    """Return each side that has another part's moments, with its twin and what is said of it."""
    # Imported for twins that are unlike only, since it delays the linter's start.
    from kindsl.judgement.diagnosis.surroundings import same_moments

    found = []
    for own, twin in (pair, pair[::-1]):
        copy = next(same_moments(model, own), None)
        said = f"its moments are those of '{copy}', which is another part"
        if copy:
            found.append(
                (own, twin, f"'{own.name}' is not the mirror image of '{twin.name}': {said}")
            )
    return found


def _finding(own: Link, twin: Link, message: str) -> Finding:
    assert own.inertia is not None and twin.inertia is not None
    related = Related(keyword(twin.inertia), f"inertia of '{twin.name}'")
    return Finding(keyword(own.inertia), message, (related,))


RULE = Rule(
    __name__, Severity.WARNING, check_document=check_document, reads=Aspect.PLACES | Aspect.MASSES
)
