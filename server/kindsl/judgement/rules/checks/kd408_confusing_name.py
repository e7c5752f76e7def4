"""A name in a value is easily mistaken for something else.

## What it does
Reports `pi`, `Pi` and `pI`, `π` where it has no value, a parameter with the name of a link or a
joint, a parameter whose name begins with `pi` where the document is not for one target alone, and a
unit behind a number, unless that name has a value.

## Why is this bad?
`pi` is a parameter of that name for RobCoGen and the number for RobCoGen2: one text with two
meanings. Of `pitch` RobCoGen2 reads `pi` and stops at `tch`. `π` is a parameter like any other, not
the number. `2.275kg` is the product of 2.275 and a parameter `kg`.

## Example
```kindsl
rotation = (pi/2.0, 0.0, 0.0)
```

## Fix
Writes `PI`, or the number in kilograms, metres or radians. Unsafe: for RobCoGen the parameter
disappears.
"""

from collections.abc import Iterator

from kindsl.judgement.rules.base import Finding, Fix, Related, Replacement, Rule, Severity, renaming
from kindsl.judgement.rules.broken_text import is_doubtful, is_greek_pi
from kindsl.judgement.rules.context import Context
from kindsl.judgement.rules.subject import parameter_subject
from kindsl.judgement.rules.units import numbers_with_unit
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.places import Place
from kindsl.language.syntax.readings import two_readings


def check_document(model: Model, context: Context) -> Iterator[Finding]:
    yield from _small_pi(model)
    for parameter in model.parameters:
        if is_doubtful(parameter):
            continue
        name, subject = str(parameter.name), parameter_subject(parameter.name)
        if is_greek_pi(name) and name not in context.values:
            message = f"'{name}' is a parameter, not the constant PI"
            for use in parameter.uses:
                fix = renaming(use.name, name, "PI")
                yield Finding(use.name, message, fix=fix, subject=subject)
            continue
        units = numbers_with_unit(parameter, context.values)
        for found in units:
            message = (
                f"'{found.text}' is {found.number} times a parameter '{name}': numbers have no unit"
            )
            fix = Fix(f"Write {found.in_si}", (Replacement(found.place, found.in_si),))
            yield Finding(found.place, message, fix=fix, subject=subject)
        if units:
            continue
        other = model.body_named.get(name) or model.joint_named.get(name)
        if other is not None:
            what = "link" if name in model.body_named else "joint"
            related = Related(other.name, f"{what} '{name}'")
            message = f"parameter '{name}' has the same name as a {what}"
            yield Finding(parameter.name, message, (related,), subject=subject)
        elif name[:2].lower() == "pi" and not context.targets:
            message = f"robcogen2 reads parameter '{name}' as '{name[:2]}' and stops"
            yield Finding(parameter.name, message, subject=subject)


def _small_pi(model: Model) -> Iterator[Finding]:
    for island in model.islands:
        for found in two_readings(island):
            if found.kind == "pi":
                place = Place(island, found.start, found.end)
                message = f"'{found.text}' is a parameter for robcogen and the number for robcogen2"
                yield Finding(place, message, fix=renaming(place, found.text, "PI"))


RULE = Rule(__name__, Severity.WARNING, check_document=check_document, reads=Aspect.SYMBOLS)
