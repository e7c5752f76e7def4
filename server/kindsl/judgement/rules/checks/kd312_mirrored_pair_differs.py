"""The inertias of a left part and its right twin differ.

## What it does
Compares links whose names are mirror images, `LF_hip` and `RF_hip`, `left_arm` and `right_arm`.
Where nearly all of the ten numbers of their inertias agree, it reports one or two that differ, or
all three of the centre of mass, and signs that are not those of any turn or reflection of the axes.

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

from collections.abc import Iterator

from kindsl.judgement.diagnosis.judgements import keyword
from kindsl.judgement.rules.base import Finding, Rule, Severity
from kindsl.judgement.rules.context import Context
from kindsl.judgement.rules.inertia.mirror_images import unlike_pairs
from kindsl.judgement.rules.inertia.shapes import is_told_of
from kindsl.judgement.rules.inertia.told_causes import explained, has_cause
from kindsl.judgement.rules.limb_places import OF_A_LINK
from kindsl.judgement.rules.limb_verdicts import limb_slips
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.declarations import Link
from kindsl.language.semantics.model import Model
from kindsl.robots.mechanism.link_inertia import link_inertia


def check_document(model: Model, context: Context) -> Iterator[Finding]:
    verdicts = limb_slips(model, context).verdicts
    told = {place.link for v in verdicts for place in v.places if place.what in OF_A_LINK}
    # What KD510 tells with a fix for either side; what KD509 leaves to a cause is told here.
    pairs = (v for v in verdicts if not v.is_convicted and v.repairs)
    links = {place.link for v in pairs for place in v.places if place.what in OF_A_LINK}
    inertias = (model.body_named[name].inertia for name in links)
    of_limbs = {keyword(inertia) for inertia in inertias if inertia is not None}
    yield from (f for f in explained(model, context, "KD312") if f.at not in of_limbs)

    def is_told(body: Link) -> bool:
        is_of_limbs = body.name in told or is_told_of(body, model, context)
        return is_of_limbs or has_cause(model, context, body, "KD312", "KD502", "KD509")

    yield from unlike_pairs(model, context.values, link_inertia, is_told)


RULE = Rule(__name__, Severity.WARNING, check_document=check_document, reads=Aspect.NUMBERS)
