"""An inertia is given in a frame of another link.

## What it does
Reports a `ref_frame` of an inertia that names a frame of another link.

## Why is this bad?
The frames of two links move against each other, so the numbers hold in one configuration only.
RobCoGen rejects it. RobCoGen2 accepts it and takes the numbers as if they were given in the link
frame.

## Example
```kindsl
link upper {
    id = 1
    inertia_params { mass = 1.0 CoM = (0.0, 0.0, 0.0)
        Ix=0.01 Iy=0.01 Iz=0.01 Ixy=0.0 Ixz=0.0 Iyz=0.0 ref_frame = fr_lower }
    children { lower via elbow }
}
```
where `fr_lower` is a frame of the link `lower`.
"""

from collections.abc import Iterator

from kindsl.judgement.rules.base import Finding, Related, Rule, Severity
from kindsl.judgement.rules.context import ROBCOGEN2, Context
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.model import Model


def check_document(model: Model, context: Context) -> Iterator[Finding]:
    named = {str(frame.name): frame for frame in reversed(model.frames)}
    severity = Severity.WARNING if context.targets == {ROBCOGEN2} else Severity.ERROR
    for body in model.bodies:
        if body.inertia is not None and body.inertia.frame:
            name = body.inertia.frame
            is_own = any(frame.name == name for frame in body.frames)
            owner = None if is_own else named.get(name)
            if owner is not None and owner.link and body.name:
                message = f"frame '{name}' belongs to link '{owner.link}', not to '{body.name}'"
                related = Related(owner.name, f"frame '{name}' of link '{owner.link}'")
                yield Finding(name, message, (related,), severity=severity)


RULE = Rule(__name__, Severity.ERROR, check_document=check_document, reads=Aspect.STRUCTURE)
