"""Two links have the same supporting joint.

## What it does
Reports a `link via joint` whose joint already connects another link.

## Why is this bad?
A joint supports one link: it is the link's degree of freedom. RobCoGen accepts the document and
fails later; RobCoGen2 with "Inconsistent arguments"; neither names a place.

## Example
```kindsl
children { left via finger right via finger }
```
"""

from collections.abc import Iterator

from kindsl.judgement.rules.base import Finding, Related, Rule, Severity
from kindsl.judgement.rules.reference_defects import reference_defects
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.model import Model


def check_document(model: Model, _: object) -> Iterator[Finding]:
    defects = reference_defects(model)
    spare = defects.idle_joints if len(defects.idle_joints) == 1 else []
    for first, again in defects.reused_joints:
        name = again.child.joint
        message = f"joint '{name}' already connects link '{first.child.link}'"
        related = [Related(first.child, f"'{first.child.link}' moves by '{name}'")]
        related += [Related(j.name, f"joint '{j.name}' is not used") for j in spare]
        yield Finding(name, message, tuple(related))


RULE = Rule(__name__, Severity.ERROR, check_document=check_document, reads=Aspect.STRUCTURE)
