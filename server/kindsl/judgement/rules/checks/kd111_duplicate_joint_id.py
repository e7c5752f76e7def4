"""Two joints have the same id.

## What it does
Reports a joint that reuses the `id` of an earlier joint.

## Why is this bad?
It does no harm: ids of joints are obsolete, and both generators ignore them, since a joint has the
id of its link. But a reader will trust the number.

## Example
```kindsl
r_joint shoulder { id = 1 ref_frame { translation = (0.0, 0.0, 0.1) rotation = (0.0, 0.0, 0.0) } }
r_joint elbow    { id = 1 ref_frame { translation = (0.0, 0.0, 0.3) rotation = (0.0, 0.0, 0.0) } }
```
"""

from collections.abc import Iterator

from kindsl.judgement.rules.base import Finding, Related, Rule, Severity
from kindsl.judgement.rules.duplicates import repeats
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.model import Model


def check_document(model: Model, _: object) -> Iterator[Finding]:
    for first, again in repeats(model.joints, lambda joint: joint.id):
        if first.name == again.name:
            continue
        message = f"joint '{again.name}' reuses id {again.id} of joint '{first.name}'"
        related = Related(first.id_place or first.name, f"id {first.id} of joint '{first.name}'")
        yield Finding(again.id_place or again.name, message, (related,))


RULE = Rule(__name__, Severity.INFORMATION, check_document=check_document, reads=Aspect.STRUCTURE)
