"""Mass and moments of inertia imply an implausible density.

## What it does
Reports a moving link whose equivalent ellipsoid, the homogeneous one with the same mass and moments
about the centre of mass, has a density outside 10 to 30 000 kg/m³. Where a cause is told (KD308,
KD310, KD314), the density is evidence for that, and not told twice.

## Why is this bad?
Foam has 15 kg/m³, water 1000, aluminium 2700, steel 7850, tungsten 19 300. Robots' links, hollow as
they are, lie between 50 and 3000. A density far outside points to moments or a mass in another
unit (KD308), or to a digit too many.

## Example
```kindsl
inertia_params {
    mass = 0.5
    CoM = (0.0, 0.0, 0.0)
    Ix=150.0 Iy=150.0 Iz=90.0 Ixy=0.0 Ixz=0.0 Iyz=0.0
}
```
is half a kilogram spread over 30 metres.
"""

from collections.abc import Iterator

from kindsl.judgement.diagnosis.body_verdicts import density_verdict
from kindsl.judgement.diagnosis.judgements import Verdict, judgements, keyword
from kindsl.judgement.rules.base import Finding, Rule, Severity
from kindsl.judgement.rules.context import Context
from kindsl.language.semantics.declarations import Declarations


def check_island(declared: Declarations, context: Context) -> Iterator[Finding]:
    for found in judgements(declared, context.values):
        if found.verdict is Verdict.IMPLAUSIBLE:
            verdict = density_verdict(str(found.link.name), found.body)
            if verdict is not None:
                yield Finding(keyword(found.inertia), verdict.sentence)


RULE = Rule(__name__, Severity.WARNING, check_island=check_island)
