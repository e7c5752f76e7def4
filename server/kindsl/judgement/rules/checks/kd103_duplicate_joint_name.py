"""Two joints have the same name.

## What it does
Reports a joint with the name of an earlier joint.

## Why is this bad?
References to that name resolve to the first one; the second is not used. RobCoGen accepts the
document and fails later: "Joint has no predecessor".

## Example
```kindsl
r_joint wrist { ref_frame { translation = (0.0, 0.0, 0.1) rotation = (0.0, 0.0, 0.0) } }
r_joint wrist { ref_frame { translation = (0.0, 0.0, 0.1) rotation = (PI/2.0, 0.0, 0.0) } }
```
"""

from collections.abc import Iterator

from kindsl.judgement.rules.base import Finding, Related, Rule, Severity
from kindsl.judgement.rules.duplicates import repeated_names
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.model import Model


def check_document(model: Model, _: object) -> Iterator[Finding]:
    for first, again in repeated_names(model.joints):
        message = f"joint '{again.name}' is already defined"
        yield Finding(again.name, message, (Related(first.name, f"joint '{first.name}'"),))


RULE = Rule(__name__, Severity.ERROR, check_document=check_document, reads=Aspect.STRUCTURE)
