"""The inertias of a left part and its right twin differ.

## What it does
Compares links whose names are mirror images, `LF_hip` and `RF_hip`, `left_arm` and `right_arm`.
Where nearly all of the ten numbers of their inertias agree, it reports one or two that differ, and
signs that are not those of any turn or reflection of the axes.

## Why is this bad?
Such parts are copied and then edited by hand. One number that was changed on one side only, or one
sign that was forgotten, makes the robot drift to that side.

A slip that explains the difference, such as a sign, a unit or moments shifted twice, is told
instead, with its rivals, and where many numbers differ, moments that are those of another part.
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

from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING

from kindsl.judgement.diagnosis.judgements import keyword
from kindsl.judgement.diagnosis.suspects import suspects_of
from kindsl.judgement.rules.base import Finding, Related, Rule, Severity
from kindsl.judgement.rules.context import Context
from kindsl.judgement.rules.examples import link, robot
from kindsl.judgement.rules.inertia.mirror_images import mirror_difference
from kindsl.judgement.rules.inertia.shapes import is_told_of
from kindsl.judgement.rules.limb_places import OF_A_LINK
from kindsl.judgement.rules.limb_verdicts import limb_slips
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.declarations import Link
from kindsl.language.semantics.model import Model, model_part
from kindsl.language.semantics.unknown import Unknown
from kindsl.language.syntax.document import Chunk
from kindsl.language.text.facts import Fact, kept
from kindsl.robots.limbs.comparison import Tolerance
from kindsl.robots.limbs.mounts import REFLECTIONS
from kindsl.robots.limbs.names import label_of, other_side
from kindsl.robots.limbs.weighing import differing, seen_by
from kindsl.robots.mechanism.link_inertia import link_inertia

if TYPE_CHECKING:
    from kindsl.judgement.diagnosis.slips import Hypothesis

_NEARLY = Tolerance(5e-4, 0.05, 0.05)
# How the two are no mirror images: the numbers that differ, or the slip of either.
_Slips = list["Hypothesis"]
_Unlike = tuple[str, tuple[_Slips, ...]]
_UNLIKE = Fact[tuple[object, _Unlike]]("unlike twins")


def check_document(model: Model, context: Context) -> Iterator[Finding]:
    """Yield a finding for each mirrored pair in which one part has a slip."""
    verdicts = limb_slips(model, context).verdicts
    told = {place.link for v in verdicts for place in v.places if place.what in OF_A_LINK}
    for left, name in (pair for chunk in model.document.chunks for pair in _twins(chunk)):
        right = model.body_named.get(name)
        if right is None or left.inertia is None or right.inertia is None:
            continue
        given, compare = (right, context.values), partial(_unlike, left, right, context.values)
        numbers, slips = left.facts.made_of(_UNLIKE, given, compare)
        if not (numbers or slips) or any(
            b.name in told or is_told_of(b, model, context) for b in (left, right)
        ):
            continue
        is_suspect = any(
            found.link in (left, right) for found in suspects_of(model, context.values)
        )
        explained = None if is_suspect else _explained(model, slips, left, right)
        if explained is not None:
            yield explained
        elif numbers:
            yield _finding(right, left, numbers)


def _unlike(left: Link, right: Link, values: Mapping[str, float]) -> _Unlike:
    here, there = (link_inertia(body, values) for body in (left, right))
    if isinstance(here, Unknown) or isinstance(there, Unknown):
        return "", ()
    numbers = mirror_difference((str(left.name), str(right.name)), here, there)
    if not numbers and any(not differing(seen_by(here, C), there, _NEARLY) for C in REFLECTIONS):
        return "", ()
    # Imported for twins that are unlike only, since it delays the linter's start.
    from kindsl.judgement.diagnosis.surroundings import images
    from kindsl.judgement.rules.inertia.unlike_twins import slips_of

    return numbers, (slips_of(here, images(there)), slips_of(there, images(here)))


def _explained(model: Model, slips: Sequence[_Slips], *pair: Link) -> Finding | None:
    """Return what explains numbers that differ: slips, or else another part's moments."""
    from kindsl.judgement.rules.inertia.unlike_twins import copied_from, without

    sides = list(zip(pair, pair[::-1], slips, strict=True))
    likely = sorted((side for side in sides if side[2]), key=lambda side: -side[2][0].weight)
    copied = [(own, twin, why) for own, twin, _ in sides if (why := copied_from(model, own, ()))]
    if likely:
        own, twin, found = likely[0]
        why, *others = without(found, "it would be")
        rivals = [(own, each) for each in others]
        rivals += [
            (o, each) for o, _, s in likely[1:] for each in without(s, f"'{o.name}' would be")
        ]
    elif len(copied) == 1:
        (own, twin, why), rivals = copied[0], []
    else:
        return None
    return _finding(
        own, twin, f"'{own.name}' is not the mirror image of '{twin.name}': {why}", rivals
    )


def _finding(
    own: Link, twin: Link, message: str, rivals: Sequence[tuple[Link, str]] = ()
) -> Finding:
    told = [*((link, f"or {rival}") for link, rival in rivals), (twin, f"inertia of '{twin.name}'")]
    related = (Related(keyword(b.inertia), each) for b, each in told if b.inertia is not None)
    assert own.inertia is not None
    return Finding(keyword(own.inertia), message, tuple(related))


@kept
def _twins(chunk: Chunk) -> list[tuple[Link, str]]:
    """Return the left parts of a chunk with the names that their twins would have."""
    part = model_part(chunk)
    named = ((body, str(body.name)) for body in (*part.bases, *part.links))
    left = ((body, other_side(name)) for body, name in named if label_of(name).side == "L")
    return [(body, twin) for body, twin in left if twin]


_INERTIA = """inertia_params {
        mass = %s
        CoM = (0.1, %s, 0.0)
        Ix=0.021 Iy=0.031 Iz=0.041 Ixy=%s Ixz=0.0 Iyz=0.0
    }"""


def _pair(mass: str, product: str) -> str:
    links = (
        link("left_arm", 1, inertia=_INERTIA % ("1.24", "0.05", "0.004")),
        link("right_arm", 2, inertia=_INERTIA % (mass, "-0.05", product)),
    )
    return robot(*links, base="left_arm via one right_arm via other", joints="one other")


RULE = Rule(
    __name__,
    Severity.WARNING,
    check_document=check_document,
    reads=Aspect.STRUCTURE | Aspect.PLACES | Aspect.MASSES,
    good=(_pair("1.24", "-0.004"),),
    bad=(_pair("1.42", "-0.004"), _pair("1.24", "0.004")),
)
