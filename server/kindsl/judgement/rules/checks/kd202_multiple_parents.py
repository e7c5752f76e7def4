"""A link has two parents.

## What it does
Reports a link that is a child of more than one body.

## Why is this bad?
The language describes trees, in which a link has one parent: a closed linkage cannot be expressed.
RobCoGen accepts the document and fails later without a place; RobCoGen2 with "Inconsistent
arguments".

## Example
```kindsl
link left  { id = 1 children { coupler via pin_left } }
link right { id = 2 children { coupler via pin_right } }
```
"""

from collections.abc import Iterator

from kindsl.judgement.rules.base import Finding, Related, Rule, Severity
from kindsl.judgement.rules.reference_defects import reference_defects
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.model import Model


def check_document(model: Model, _: object) -> Iterator[Finding]:
    for first, again in reference_defects(model).extra_parents:
        name, other = again.child.link, first.predecessor.name
        message = f"link '{name}' has two parents: '{other}' and '{again.predecessor.name}'"
        related = Related(first.child, f"'{other}' carries '{name}'")
        yield Finding(name, message, (related,))


RULE = Rule(__name__, Severity.ERROR, check_document=check_document, reads=Aspect.STRUCTURE)
