"""A parameter's value lies outside its range.

## What it does
Reports a parameter whose value, from the document or from outside, is below `min` or above `max`
in `kindsl.toml`.

## Why is this bad?
Either the value or the range is wrong. The preview's sliders cannot show such a value, and the
checks over the range do not cover it.

## Example
```toml
[parameters.forearm_length]
value = 0.9
min = 0.2
max = 0.5
```
"""

from collections.abc import Iterator

from kindsl.judgement.rules.base import Finding, Rule, Severity
from kindsl.judgement.rules.context import Context
from kindsl.judgement.rules.subject import parameter_subject
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.parameters import Binding


def check_document(model: Model, context: Context) -> Iterator[Finding]:
    for parameter in model.parameters:
        binding = context.bindings.get(parameter.name)
        value = context.values.get(parameter.name)
        if binding is not None and value is not None:
            limit = _broken_limit(binding, value)
            if limit:
                message = f"parameter '{parameter.name}' is {value:g}, {limit}"
                subject = parameter_subject(parameter.name)
                yield Finding(parameter.name, message, subject=subject)


def _broken_limit(binding: Binding, value: float) -> str:
    if binding.minimum is not None and value < binding.minimum:
        return f"below its minimum {binding.minimum:g}"
    if binding.maximum is not None and value > binding.maximum:
        return f"above its maximum {binding.maximum:g}"
    return ""


RULE = Rule(__name__, Severity.WARNING, check_document=check_document, reads=Aspect.SYMBOLS)
