"""One parameter stands for quantities of different kinds.

## What it does
Reports a parameter that is a length in one place and an angle or a mass, centre of mass or moment
in another.

## Why is this bad?
The generators sort parameters into lengths, angles and dynamics, one structure each, and put this
one into several: setting one of them leaves the others unchanged. Metres and radians are seldom
meant to be the same number.

## Example
```kindsl
translation = (offset, 0.0, 0.0)
rotation    = (offset, 0.0, 0.0)
```
"""

from collections.abc import Iterator
from typing import assert_never

from kindsl.judgement.rules.base import Finding, Related, Rule, Severity
from kindsl.judgement.rules.subject import parameter_subject
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.declarations import ValueKind
from kindsl.language.semantics.model import Model


def check_document(model: Model, _: object) -> Iterator[Finding]:
    for parameter in model.parameters:
        known = {parameter.kind}
        for use in parameter.uses:
            if use.kind not in known:
                known.add(use.kind)
                here, first = _words(use.kind), _words(parameter.kind)
                message = f"parameter '{parameter.name}' is {here} here and {first} elsewhere: "
                message += "the generators keep two values"
                related = Related(parameter.name, f"{first} here")
                subject = parameter_subject(parameter.name)
                yield Finding(use.name, message, (related,), subject=subject)


def _words(kind: ValueKind) -> str:
    match kind:
        case ValueKind.LENGTH:
            return "a length"
        case ValueKind.ANGLE:
            return "an angle"
        case ValueKind.DYNAMICS:
            return "a property of inertia"
        case _:
            assert_never(kind)


RULE = Rule(__name__, Severity.WARNING, check_document=check_document, reads=Aspect.SYMBOLS)
