"""A link is listed twice as a child of one body.

## What it does
Reports a child that the same body already lists, with the same joint or with another. With another
joint it is an error for the target robcogen2.

## Why is this bad?
A link has one supporting joint. RobCoGen silently ignores one of the two; RobCoGen2 stops
with "Inconsistent arguments".

## Example
```kindsl
children {
    lower via elbow
    lower via elbow
}
```

## Fix
Removes the repetition if it names the same joint. Safe: it adds nothing.
"""

from collections.abc import Iterator

from kindsl.judgement.rules.base import Finding, Fix, Related, Replacement, Rule, Severity, Tag
from kindsl.judgement.rules.context import ROBCOGEN2, Context
from kindsl.judgement.rules.reference_defects import reference_defects
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.places import with_lines


def check_document(model: Model, context: Context) -> Iterator[Finding]:
    for first, again in reference_defects(model).repeated:
        message = (
            f"link '{again.child.link}' is listed twice as a child of '{again.predecessor.name}'"
        )
        related = Related(first.child, f"'{first.child.link}' via '{first.child.joint}'")
        is_same = again.child.joint == first.child.joint
        removed = Fix(
            "Remove the repetition", (Replacement(with_lines(again.child), ""),), is_safe=True
        )
        fix, tag = (removed, Tag.UNNECESSARY) if is_same else (None, None)
        is_fatal = not is_same and ROBCOGEN2 in context.targets
        severity = Severity.ERROR if is_fatal else Severity.WARNING
        yield Finding(again.child, message, (related,), fix, severity, tag)


RULE = Rule(__name__, Severity.WARNING, check_document=check_document, reads=Aspect.STRUCTURE)
