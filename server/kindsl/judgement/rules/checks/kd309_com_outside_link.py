"""The centre of mass is far away from the link.

## What it does
Compares a moving link's centre of mass with the known places of the link: its own joint, the
joints of its children, its frames. Reports a distance of more than the link's length and three
times its radius of gyration together, and a radius of gyration of more than five times the length,
unless its density is reported (KD311): both come from the same moments. The radius of a
link that carries a slide is left out: a rail may have any length.

## Why is this bad?
A body's mass is where the body is. Mostly a digit is lost, a unit is wrong, or the numbers
belong to another frame.

## Example
```kindsl
link forearm {
    id = 2
    inertia_params { mass = 1.2 CoM = (0.0, 0.0, 1.5)
        Ix=2.71 Iy=2.71 Iz=0.001 Ixy=0.0 Ixz=0.0 Iyz=0.0 }
    children { hand via wrist }
}
```
with a wrist at 0.3 m.
"""

from collections.abc import Iterator

from kindsl.judgement.rules.base import Finding, Rule, Severity
from kindsl.judgement.rules.context import Context
from kindsl.judgement.rules.inertia.shapes import shape_doubts
from kindsl.language.semantics.declarations import Joint, Link


def check_body(body: Link, joints: tuple[Joint, ...], context: Context) -> Iterator[Finding]:
    for at, verdict in shape_doubts(body, joints, context, "KD309"):
        yield Finding(at, verdict.sentence)


RULE = Rule(__name__, Severity.WARNING, check_body=check_body)
