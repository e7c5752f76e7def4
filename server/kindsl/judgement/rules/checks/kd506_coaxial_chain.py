"""Two successive joints have the same axis.

## What it does
Reports a revolute joint about the axis of the revolute joint before it, and a prismatic joint along
the direction of the prismatic joint before it.

## Why is this bad?
Only the sum of the two joint variables changes the pose: the Jacobian loses a rank everywhere. It
is sometimes meant, in telescopes for example.

## Example
```kindsl
r_joint wrist { ref_frame { translation = (0.0, 0.0, 0.1) rotation = (0.0, 0.0, 0.0) } }
```
moved by a revolute joint: its axis is the z axis of the link that carries it.
"""

from collections.abc import Iterator
from math import hypot

from kindsl.judgement.rules.base import Finding, Related, Rule, Severity
from kindsl.judgement.rules.context import Context
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.declarations import Joint
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.numbers import written_pose

_PARALLEL = 1e-6
_COINCIDENT = 1e-6


def check_document(model: Model, context: Context) -> Iterator[Finding]:
    for edge in model.tree.edges:
        above = model.tree.supporting_edge(edge.predecessor)
        joint, before = edge.joint, above.joint if above is not None else None
        if joint is None or before is None or joint is before or joint.kind != before.kind:
            continue
        if _is_coaxial(joint, context):
            how = "turns about" if joint.kind == "revolute" else "slides along"
            message = f"joint '{joint.name}' {how} the axis of joint '{before.name}' before it"
            yield Finding(joint.name, message, (Related(before.name, f"joint '{before.name}'"),))


def _is_coaxial(joint: Joint, context: Context) -> bool:
    """Return whether a joint's axis is the z axis of the frame that it is given in."""
    here = written_pose(joint.pose, context.values)
    if here is None:
        return False
    (_, _, x), (_, _, y), _ = here.rotation
    offset = hypot(here.translation[0], here.translation[1])
    return hypot(x, y) < _PARALLEL and (joint.kind == "prismatic" or offset < _COINCIDENT)


RULE = Rule(__name__, Severity.INFORMATION, check_document=check_document, reads=Aspect.PLACES)
