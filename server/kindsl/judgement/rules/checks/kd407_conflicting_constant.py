"""A named constant has two different values.

## What it does
Reports a `<k=...>` whose value differs from the first one of the same name.

## Why is this bad?
RobCoGen2 silently takes one of them.

## Example
```kindsl
translation = (<reach=0.5>, 0.0, <reach=0.4>)
```
"""

from collections.abc import Iterator

from kindsl.judgement.rules.base import Finding, Related, Rule, Severity
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.model import Model


def check_document(model: Model, _: object) -> Iterator[Finding]:
    for constant in model.constants:
        values = [use.value for use in constant.uses if use.value is not None]
        for other in values[1:]:
            if other.value({}) != values[0].value({}):
                message = f"constant '{constant.name}' is {other.text} here"
                message += f" and {values[0].text} elsewhere"
                yield Finding(other, message, (Related(values[0], "the first value"),))


RULE = Rule(__name__, Severity.ERROR, check_document=check_document, reads=Aspect.SYMBOLS)
