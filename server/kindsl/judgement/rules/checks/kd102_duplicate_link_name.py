"""Two links, or a link and the base, have the same name.

## What it does
Reports a link with the name of an earlier link or of the base.

## Why is this bad?
References to that name resolve to the first one; the second link is not connected. RobCoGen accepts
the document and fails later, in its geometry: "Joint has no predecessor".

## Example
```kindsl
link finger { id = 1 children {} }
link finger { id = 2 children {} }
```
"""

from collections.abc import Iterator

from kindsl.judgement.rules.base import Finding, Related, Rule, Severity
from kindsl.judgement.rules.duplicates import repeated_names
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.model import Model


def check_document(model: Model, _: object) -> Iterator[Finding]:
    for first, again in repeated_names(model.bodies):
        if not again.is_base:
            what = "the base" if first.is_base else "another link"
            message = f"'{again.name}' is already the name of {what}"
            yield Finding(again.name, message, (Related(first.name, f"{what} '{first.name}'"),))


RULE = Rule(__name__, Severity.ERROR, check_document=check_document, reads=Aspect.STRUCTURE)
