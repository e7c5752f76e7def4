"""The inertias of a left part and its right twin differ.

## What it does
Compares links whose names are mirror images, `LF_hip` and `RF_hip`, `left_arm` and `right_arm`.
Where nearly all of the ten numbers of their inertias agree, it reports one or two that differ, and
signs that are not those of any turn or reflection of the axes.

## Why is this bad?
Such parts are copied and then edited by hand. One number that was changed on one side only, or one
sign that was forgotten, makes the robot drift to that side.

A pair in which many numbers differ was measured part by part and is not reported, nor are
differences below 5 % of the greatest number of their kind. Impossible inertias are left to KD301
and KD302, a centre of mass behind its joint to KD511, and where more limbs than two are alike and
one differs, that is left to KD509.

## Example
```kindsl
link left_arm  { id = 1 inertia_params { mass = 1.24 ... } children {} }
link right_arm { id = 2 inertia_params { mass = 1.42 ... } children {} }
```
"""

from collections.abc import Iterator

from kindsl.rules.base import Finding, Related, Rule, Severity
from kindsl.rules.context import Context
from kindsl.rules.examples import link, robot
from kindsl.rules.inertia.judgements import keyword
from kindsl.rules.inertia.mirror_images import mirror_difference
from kindsl.rules.inertia.shapes import is_told_of
from kindsl.rules.inertia.twins import right_twin_of
from kindsl.rules.limb_places import OF_A_LINK
from kindsl.rules.limb_verdicts import limb_slips
from kindsl.semantics.aspects import Aspect
from kindsl.semantics.declarations import Link
from kindsl.semantics.model import Model, model_part
from kindsl.syntax.document import Chunk
from kindsl.text.facts import kept


def check_document(model: Model, context: Context) -> Iterator[Finding]:
    """Yield a finding for each pair of parts that is nearly the same."""
    verdicts = limb_slips(model, context).verdicts
    outvoted = {p.link for v in verdicts if v.is_convicted for p in v.places if p.what in OF_A_LINK}
    for left, name in (pair for chunk in model.document.chunks for pair in _twins(chunk)):
        right = model.body_named.get(name)
        if right is None or left.inertia is None or right.inertia is None:
            continue
        message = mirror_difference(left, right)
        pair = (left, right)
        if message and not any(is_told_of(b, model, context) or b.name in outvoted for b in pair):
            related = Related(keyword(left.inertia), f"inertia of '{left.name}'")
            yield Finding(keyword(right.inertia), message, (related,))


@kept
def _twins(chunk: Chunk) -> list[tuple[Link, str]]:
    """Return the left parts of a chunk with the names that their twins would have."""
    part = model_part(chunk)
    named = ((body, right_twin_of(body)) for body in (*part.bases, *part.links))
    return [(body, twin) for body, twin in named if twin]


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
    "KD312",
    "mirrored-pair-differs",
    Severity.WARNING,
    check_document=check_document,
    reads=Aspect.STRUCTURE | Aspect.PLACES | Aspect.MASSES,
    good=(_pair("1.24", "-0.004"),),
    bad=(_pair("1.42", "-0.004"), _pair("1.24", "0.004")),
)
