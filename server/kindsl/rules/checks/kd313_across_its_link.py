"""A rod lies across its link.

## What it does
Compares the shape of a moving link's mass with the way from its joint to the next one, or to its
only frame. Reports a body that is a slender rod about as long as that way, but lies at right angles
to it, with its centre of mass between the two ends, or obliquely with its centre of mass beside it.

## Why is this bad?
A link's mass lies along the link. Usually the moments are about other axes: the CAD program had
x where the link frame has z. Moments given about the wrong point often hide it (KD306); the
totals then look whole, and the joint torques are wrong.

## Example
```kindsl
link upper {
    id = 1
    inertia_params { mass = 2.0 CoM = (0.0, 0.0, 0.2)
        Ix=0.081 Iy=0.107 Iz=0.027 Ixy=0.0 Ixz=0.0 Iyz=0.0 }
    children { lower via elbow }
}
```
with an elbow at 0.4 m along z: the rod is 0.4 m long, but along x.
"""

from collections.abc import Iterator

from kindsl.rules.base import Finding, Rule, Severity
from kindsl.rules.context import Context
from kindsl.rules.examples import joint, link, robot
from kindsl.rules.inertia.judgements import keyword
from kindsl.rules.inertia.shapes import doubtful_bodies
from kindsl.semantics.model import Model


def check_document(model: Model, context: Context) -> Iterator[Finding]:
    """Yield a finding for each link whose mass is a rod across the way to its only end."""
    for body, verdict in doubtful_bodies(model, context, "KD313"):
        if body.inertia is not None:
            yield Finding(keyword(body.inertia), verdict.sentence)


_INERTIA = """inertia_params {
        mass = 2.0
        CoM = (0.0, 0.0, 0.2)
        Ix=%s Iy=%s Iz=%s Ixy=0.0 Ixz=0.0 Iyz=0.0
    }"""


def _arm(*moments: str) -> str:
    upper = link("upper", 1, "lower via elbow", _INERTIA % moments)
    joints = joint("shoulder"), joint("elbow", 0.4)
    return robot(upper, link("lower", 2), *joints, base="upper via shoulder")


RULE = Rule(
    "KD313",
    "across-its-link",
    Severity.WARNING,
    check_document=check_document,
    good=(_arm("0.107", "0.107", "0.001"), _arm("0.10", "0.11", "0.02")),
    bad=(_arm("0.081", "0.107", "0.027"),),
)
