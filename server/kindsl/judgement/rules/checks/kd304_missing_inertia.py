"""A link has no inertia.

## What it does
Reports a moving link without an `inertia_params` section: a warning, and an error for a floating
base and for the target robcogen. KD601 reports the section missing in a fixed base, which robcogen
requires too.

## Why is this bad?
RobCoGen2 reads the document and takes zero for everything, so all dynamics are wrong; RobCoGen
rejects it.

## Example
```kindsl
link upper {
    id = 1
    children {}
}
```
"""

from collections.abc import Iterator

from kindsl.judgement.rules.base import Finding, Rule, Severity
from kindsl.judgement.rules.context import ROBCOGEN, Context
from kindsl.judgement.rules.examples import link, robot
from kindsl.judgement.rules.inertia.judgements import is_moving
from kindsl.language.semantics.declarations import Declarations


def check_island(declared: Declarations, context: Context) -> Iterator[Finding]:
    """Yield a finding for each body without inertia whose inertia matters."""
    is_required = ROBCOGEN in context.targets
    for body in declared.bodies():
        if body.inertia is None and is_moving(body) and not body.island.problems:
            what = "floating base" if body.is_base else "link"
            is_error = is_required or body.is_base
            severity = Severity.ERROR if is_error else Severity.WARNING
            yield Finding(body.name, f"{what} '{body.name}' has no inertia", severity=severity)


_FLOATING = robot(link("leg", 1), base="leg via hip", joints="hip").replace(
    "ground {", "ground floating {"
)

RULE = Rule(
    "KD304",
    "missing-inertia",
    Severity.WARNING,
    check_island=check_island,
    good=(link("upper", 1),),
    bad=(link("upper", 1, inertia=""), _FLOATING),
)
