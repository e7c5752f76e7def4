"""A value that the generators read differently, or not as it seems.

## What it does
Reports `1.0e3`, which RobCoGen reads as 1.0 times a parameter `e3` and RobCoGen2 as 1000, and `2.0
- PI`, which RobCoGen reads as the product of 2.0 and -PI and RobCoGen2 not at all. With one target
named it reports the reading of that target. `pi` has a rule of its own, KD408.

## Why is this bad?
One text, two robots, and neither generator reports it. Without a target `1.0e3` has no value here:
nothing is computed from it until `kindsl.toml` names a target or the text is changed.

## Example
```kindsl
mass = 1.0e3
```

## Fix
Writes the number that RobCoGen2 reads. Safe where that is the only target, else unsafe.
"""

from collections.abc import Iterator

from kindsl.judgement.rules.base import Finding, Fix, Replacement, Rule, Severity
from kindsl.judgement.rules.context import ROBCOGEN, ROBCOGEN2, Context
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.places import Place
from kindsl.language.syntax.readings import TwoReadings, two_readings
from kindsl.language.syntax.tree import Island
from kindsl.language.text.decimals import exact_decimal


def check_document(model: Model, context: Context) -> Iterator[Finding]:
    for island in model.islands:
        for found in two_readings(island):
            is_refused = found.kind == "product" and context.targets == {ROBCOGEN2}
            if found.kind != "pi" and not is_refused:
                yield _finding(island, found, context.targets)


def _finding(island: Island, found: TwoReadings, targets: frozenset[str]) -> Finding:
    place = Place(island, found.start, found.end)
    if found.kind == "product":
        return Finding(place, f"robcogen reads '{found.text}' as {found.robcogen}")
    number = exact_decimal(float(found.text))
    fix = Fix(f"Write {number}", (Replacement(place, number),), targets == {ROBCOGEN2})
    if targets == {ROBCOGEN}:
        return Finding(place, f"robcogen reads '{found.text}' as {found.robcogen}", fix=fix)
    message = f"robcogen2 reads '{found.text}' as {found.other}"
    if targets != {ROBCOGEN2}:
        message += f", robcogen as {found.robcogen}"
    return Finding(place, message, fix=fix)


RULE = Rule(__name__, Severity.WARNING, check_document=check_document, reads=Aspect.SYMBOLS)
