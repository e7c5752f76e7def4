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

## Fix
Lets centre of mass and moments take the place of those of the next axis, or of the one after that,
where this lays the rod along the link. The fix is unsafe: it changes the robot.
"""

from collections.abc import Iterator

from kindsl.judgement.diagnosis.body_verdicts import lies_along
from kindsl.judgement.rules.base import Finding, Fix, Replacement, Rule, Severity
from kindsl.judgement.rules.context import Context
from kindsl.judgement.rules.inertia.shapes import link_ends, shape_doubts
from kindsl.language.semantics.declarations import Joint, Link
from kindsl.language.semantics.numbers import mass_distribution
from kindsl.language.semantics.unknown import inertia_expressions
from kindsl.mechanics.rigid.body import MassDistribution

_AXES = "xyz"
# Of each of the ten numbers but the mass, where what takes its place stands: x for y, y for z.
_NEXT = (2, 0, 1, 5, 3, 4, 7, 8, 6)


def check_body(body: Link, joints: tuple[Joint, ...], context: Context) -> Iterator[Finding]:
    for at, verdict in shape_doubts(body, joints, context, "KD313"):
        fix = _laid_along(body, joints, context)
        yield Finding(at, verdict.sentence, fix=fix)


def _laid_along(body: Link, joints: tuple[Joint, ...], context: Context) -> Fix | None:
    """Return the fix that turns the axes round, None where that lays no rod along the link."""
    inertia = body.inertia
    written = mass_distribution(inertia, context.values) if inertia is not None else None
    children, frames = link_ends(body, joints, context)
    if inertia is None or inertia.com is None or written is None or inertia.frame is not None:
        return None
    values = inertia_expressions(inertia)[1:]
    numbers, texts = written.numbers[1:], [value.text for value in values]
    for axis in _AXES[1:]:
        numbers, texts = tuple(numbers[i] for i in _NEXT), [texts[i] for i in _NEXT]
        turned = MassDistribution.of((written.mass, *numbers))
        if lies_along(turned, (children or frames)[0]):
            pairs = zip(values, texts, strict=True)
            changes = tuple(Replacement(old, new) for old, new in pairs if old.text != new)
            title = f"Turn the axes of '{body.name}': what was along x goes to {axis}"
            return Fix(title, changes)
    return None


RULE = Rule(__name__, Severity.WARNING, check_body=check_body)
