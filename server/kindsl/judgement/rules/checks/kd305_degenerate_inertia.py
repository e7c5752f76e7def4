"""A body has no extent in some direction.

## What it does
Reports an inertia about the centre of mass that describes an infinitely thin plate, a rod without
radius, or a point.

## Why is this bad?
It is possible and often meant. But a rod has no inertia about its own axis: if that is the axis of
the last joint, the joint-space inertia matrix is singular.

## Example
```kindsl
inertia_params {
    mass = 1.0
    CoM = (0.0, 0.0, 0.5)
    Ix=0.25 Iy=0.25 Iz=0.0 Ixy=0.0 Ixz=0.0 Iyz=0.0
}
```
is 1 kg in one point.
"""

from collections.abc import Iterator

from kindsl.judgement.diagnosis.judgements import Judgement, Verdict, judgements, keyword
from kindsl.judgement.rules.base import Finding, Rule, Severity
from kindsl.judgement.rules.context import Context
from kindsl.language.semantics.declarations import Declarations

_NEGLIGIBLE = 1e-9


def check_island(declared: Declarations, context: Context) -> Iterator[Finding]:
    for found in judgements(declared, context.values):
        if found.verdict is Verdict.SINGULAR:
            message = f"inertia of '{found.link.name}' describes {_shape(found)}"
            yield Finding(keyword(found.inertia), message)


def _shape(found: Judgement) -> str:
    _, middle, large = (pair.value for pair in found.second_moments)
    about_origin = max(map(abs, found.body.moments))
    about_origin += found.body.mass * sum(c * c for c in found.body.com)
    if large <= _NEGLIGIBLE * about_origin:
        return "a point mass"
    if middle <= _NEGLIGIBLE * large:
        return "an infinitely thin rod"
    return "an infinitely thin plate"


RULE = Rule(__name__, Severity.INFORMATION, check_island=check_island)
