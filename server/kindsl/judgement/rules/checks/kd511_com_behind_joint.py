"""The centre of mass lies behind the joint, on the side away from the next one.

## What it does
Compares a moving link whose mass is a rod along the way from its joint to the next one, or to its
only frame, with that way. Reports a rod about as long as the way whose centre of mass is not on it,
but behind the link's own joint or beyond the next.

## Why is this bad?
A sign was forgotten, in the centre of mass or in the next joint's place: the link is drawn one way
and weighs the other. Arms fall where they should be balanced.

Counterweights and motors behind a joint are left in peace: they are not as long as the link. Only
the author can tell whether the sign of the centre of mass is wrong or that of the next joint's
place: editors offer both.

## Example
```kindsl
link forearm {
    id = 2
    inertia_params { mass = 1.2 CoM = (0.0, 0.0, -0.15)
        Ix=0.036 Iy=0.036 Iz=0.001 Ixy=0.0 Ixz=0.0 Iyz=0.0 }
    children { hand via wrist }
}
```
with a wrist at 0.3 m along z.
"""

from collections.abc import Iterator

from kindsl.judgement.rules.base import Finding, Fix, Replacement, Rule, Severity
from kindsl.judgement.rules.context import Context
from kindsl.judgement.rules.inertia.shapes import link_ends, shape_doubts
from kindsl.judgement.rules.number_writing import opposite
from kindsl.language.semantics.declarations import Joint, Link, Vector
from kindsl.mechanics.rigid.pose import Vector3

_MOST = 0.9


def check_body(body: Link, joints: tuple[Joint, ...], context: Context) -> Iterator[Finding]:
    for at, verdict in shape_doubts(body, joints, context, "KD511"):
        choices = tuple(_choices(body, joints, context)) if verdict.number < 0.0 else ()
        yield Finding(at, verdict.sentence, choices=choices)


def _choices(body: Link, joints: tuple[Joint, ...], context: Context) -> Iterator[Fix]:
    """Yield the changes of a sign that turn CoM or way round, where an axis is along the link."""
    children, frames = link_ends(body, joints, context)
    axis = _main_axis((children or frames)[0])
    if axis is None or body.inertia is None or body.inertia.frame is not None:
        return
    if body.inertia.com is not None:
        yield _reversed(body.inertia.com, axis, f"the CoM of '{body.name}'")
    for below in joints:
        if below.pose.translation is not None:
            yield _reversed(below.pose.translation, axis, f"the translation of '{below.name}'")


def _main_axis(end: Vector3) -> int | None:
    """Return the axis along which a way goes, None where it goes obliquely."""
    sizes = [x * x for x in end]
    axis = sizes.index(max(sizes))
    return axis if sizes[axis] > _MOST * sum(sizes) else None


def _reversed(vector: Vector, axis: int, what: str) -> Fix:
    component = vector.components[axis]
    title = f"Change sign of {'xyz'[axis]} in {what}"
    return Fix(title, (Replacement(component, opposite(component)),))


RULE = Rule(__name__, Severity.WARNING, check_body=check_body)
