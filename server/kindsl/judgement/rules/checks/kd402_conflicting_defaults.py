"""A parameter has two different defaults.

## What it does
Reports a default that differs from the first one of the same parameter.

## Why is this bad?
RobCoGen2 silently takes the first and ignores the others.

## Example
```kindsl
translation = (reach[0.5], 0.0, reach[0.4])
```
"""

from collections.abc import Iterator

from kindsl.judgement.rules.base import Finding, Related, Rule, Severity
from kindsl.judgement.rules.subject import parameter_subject
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.model import Model


def check_document(model: Model, _: object) -> Iterator[Finding]:
    for parameter in model.parameters:
        defaults = [use.default for use in parameter.uses if use.default is not None]
        for other in defaults[1:]:
            if other.value({}) != defaults[0].value({}):
                message = f"parameter '{parameter.name}' has conflicting defaults: "
                message += f"{defaults[0].text} and {other.text}"
                related = Related(defaults[0], "the first default")
                subject = parameter_subject(parameter.name)
                yield Finding(other, message, (related,), subject=subject)


RULE = Rule(__name__, Severity.ERROR, check_document=check_document, reads=Aspect.SYMBOLS)
