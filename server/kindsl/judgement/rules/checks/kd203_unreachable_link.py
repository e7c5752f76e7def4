"""A link has no parent.

## What it does
Reports a link that is not a child of any body, once for its whole subtree. It is not reported if a
wrong name elsewhere may mean it.

## Why is this bad?
The link is not part of the robot. RobCoGen accepts the document and fails later with a
`NullPointerException`; RobCoGen2 with "Inconsistent arguments"; neither names a place.

## Example
```kindsl
RobotBase base { children {} }
link upper { id = 1 children {} }
```
"""

from collections.abc import Iterator

from kindsl.judgement.rules.base import Finding, Related, Rule, Severity
from kindsl.judgement.rules.reference_defects import reference_defects
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.model import Model
from kindsl.language.text.phrases import counted

_MOST_RELATED = 20


def check_document(model: Model, _: object) -> Iterator[Finding]:
    for body in reference_defects(model).orphans:
        below = model.tree.in_topological_order(body)
        message = f"link '{body.name}' has no parent"
        if below:
            message += f"; {counted(len(below), 'more link')} attached to it"
        related = (Related(b.name, f"'{b.name}' is attached to it") for b in below[:_MOST_RELATED])
        yield Finding(body.name, message, tuple(related))


RULE = Rule(__name__, Severity.ERROR, check_document=check_document, reads=Aspect.STRUCTURE)
