"""The links are not in the order of their ids.

## What it does
Reports a link that follows one with a greater id.

## Why is this bad?
All generated code is ordered by id. A reader who looks for the fourth joint variable looks for the
fourth link.

## Example
```kindsl
link lower { id = 2 children {} }
link upper { id = 1 children { lower via elbow } }
```
"""

from collections.abc import Iterator
from itertools import pairwise

from kindsl.judgement.rules.base import Finding, Related, Rule, Severity
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.model import Model


def check_document(model: Model, _: object) -> Iterator[Finding]:
    for before, body in pairwise(body for body in model.links if body.name):
        if before.id is not None and body.id is not None and body.id < before.id:
            message = f"links are not in order of id: '{body.name}' ({body.id}) follows"
            related = Related(before.name, f"id {before.id}")
            yield Finding(body.name, f"{message} '{before.name}' ({before.id})", (related,))
            return


RULE = Rule(__name__, Severity.INFORMATION, check_document=check_document, reads=Aspect.STRUCTURE)
