"""A parameter has no value.

## What it does
Reports each parameter that has neither a default in the document nor a value from outside: from
`kindsl.toml`, from `--param`, or from the editor's settings. A parameter with the name of a link or
a joint, and a unit behind a number, are left to KD408.

## Why is this bad?
The document is valid, and RobCoGen generates code that asks for the value at run time. But nothing
can be drawn or computed from it here, and an inertia with a parameter is not checked.

## Example
```kindsl
translation = (forearm_length, 0.0, 0.0)
```
is bound by
```toml
[parameters]
forearm_length = 0.35
```
in `kindsl.toml`.

## Fix
For the target robcogen2 alone: writes a default behind the name, `forearm_length[0.0]`. Unsafe: the
number is to be replaced by the right one.
"""

from collections.abc import Iterator

from kindsl.judgement.rules.base import Finding, Fix, Replacement, Rule, Severity
from kindsl.judgement.rules.broken_text import is_doubtful, is_greek_pi
from kindsl.judgement.rules.context import ROBCOGEN2, Context
from kindsl.judgement.rules.subject import parameter_subject
from kindsl.judgement.rules.units import numbers_with_unit
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.parameters import Parameter
from kindsl.language.semantics.places import Place


def check_document(model: Model, context: Context) -> Iterator[Finding]:
    for parameter in model.parameters:
        name = str(parameter.name)
        is_known = name in context.values or name in model.body_named or name in model.joint_named
        is_known = is_known or is_doubtful(parameter) or is_greek_pi(name)
        if not is_known and not numbers_with_unit(parameter, context.values):
            message = f"parameter '{parameter.name}' ({parameter.kind}) has no value"
            fix = _default(parameter) if context.targets == {ROBCOGEN2} else None
            yield Finding(
                parameter.name, message, fix=fix, subject=parameter_subject(parameter.name)
            )


def _default(parameter: Parameter) -> Fix:
    name = parameter.name
    behind = Place(name.island, name.end, name.end)
    return Fix(f"Give '{name}' a default", (Replacement(behind, "[0.0]"),))


RULE = Rule(__name__, Severity.WARNING, check_document=check_document, reads=Aspect.SYMBOLS)
