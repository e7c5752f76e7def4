"""A supporting joint does not exist.

## What it does
Reports a `link via joint` whose joint is not defined.

## Why is this bad?
The motion of the link is undefined, and both generators reject the document.

## Example
```kindsl
children { forearm via elbwo }
```
where the joint is called `elbow`.

## Fix
Writes the name that is probably meant if no other pair has it (of equally near names one is to be
chosen), or else adds a revolute joint of that name. Unsafe: each is a guess.
"""

from collections.abc import Iterator
from functools import partial

from kindsl.judgement.rules.base import Finding, Rule, Severity
from kindsl.judgement.rules.missing_names import missing_names
from kindsl.judgement.rules.new_blocks import new_joint
from kindsl.judgement.rules.reference_defects import reference_defects
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.model import Model


def check_document(model: Model, _: object) -> Iterator[Finding]:
    defects = reference_defects(model)
    names = (edge.child.joint for edge in defects.undefined_joints)
    add = partial(new_joint, model)
    yield from missing_names(names, "joint", defects.idle_joints, model.joints, add)


RULE = Rule(__name__, Severity.ERROR, check_document=check_document, reads=Aspect.STRUCTURE)
