"""The base is the child of a link.

## What it does
Reports a `link via joint` that names the robot's base.

## Why is this bad?
The base is the root of the tree and has no parent. Both generators reject the document, with the
message that no such link exists.

## Example
```kindsl
RobotBase trunk { children { leg via hip } }
link leg { id = 1 children { trunk via knee } }
```
"""

from collections.abc import Iterator

from kindsl.judgement.rules.base import Finding, Related, Rule, Severity
from kindsl.judgement.rules.reference_defects import reference_defects
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.model import Model


def check_document(model: Model, _: object) -> Iterator[Finding]:
    for edge in reference_defects(model).bases:
        base = model.body_named[edge.child.link]
        message = f"the base '{base.name}' cannot be a child of '{edge.predecessor.name}'"
        yield Finding(edge.child.link, message, (Related(base.name, "the base"),))


RULE = Rule(__name__, Severity.ERROR, check_document=check_document, reads=Aspect.STRUCTURE)
