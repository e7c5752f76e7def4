"""A joint is not used.

## What it does
Reports a joint that no `link via joint` names. It is not reported if a wrong name elsewhere may
mean it.

## Why is this bad?
RobCoGen accepts the document and fails later with "Joint has no predecessor"; RobCoGen2 with
`KeyError`; neither names a place.

## Example
```kindsl
r_joint spare { ref_frame { translation = (0.0, 0.0, 0.1) rotation = (0.0, 0.0, 0.0) } }
```
"""

from collections.abc import Iterator

from kindsl.judgement.rules.base import Finding, Rule, Severity
from kindsl.judgement.rules.reference_defects import reference_defects
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.model import Model


def check_document(model: Model, _: object) -> Iterator[Finding]:
    for joint in reference_defects(model).unused_joints:
        yield Finding(joint.name, f"joint '{joint.name}' is not used")


RULE = Rule(__name__, Severity.ERROR, check_document=check_document, reads=Aspect.STRUCTURE)
