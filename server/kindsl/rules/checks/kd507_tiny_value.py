"""A value so small that RobCoGen2 takes it for zero.

## What it does
Reports a value other than zero below 0.000005, unless the document is for robcogen alone.

## Why is this bad?
RobCoGen2 rounds to five decimals to decide whether a value is zero, and then simplifies: a product
of inertia of 0.000003 kg·m² is gone without a word.

## Example
```kindsl
Ixy = 0.000003
```
"""

from collections.abc import Iterator

from kindsl.rules.base import Finding, Rule, Severity
from kindsl.rules.context import ROBCOGEN, Context
from kindsl.rules.examples import STEEL_BALL, link
from kindsl.semantics.declarations import Declarations, link_values, pose_values
from kindsl.semantics.expressions import Expression

_TINY = 5e-6


def check_island(declared: Declarations, context: Context) -> Iterator[Finding]:
    """Yield a finding for each value that RobCoGen2 takes for zero."""
    if context.targets == {ROBCOGEN}:
        return
    for body in declared.bodies():
        for value, _ in link_values(body):
            if value.literal is not None and -_TINY < value.literal < _TINY and value.literal:
                yield _finding(value)
    for moved in declared.joints:
        for value, _ in pose_values(moved.pose):
            if value.literal is not None and -_TINY < value.literal < _TINY and value.literal:
                yield _finding(value)


def _finding(value: Expression) -> Finding:
    return Finding(value, f"robcogen2 takes {value.text} for zero")


def _ball(product: str) -> str:
    return link("ball", 1, inertia=STEEL_BALL.replace("Ixy=0.0", f"Ixy={product}"))


RULE = Rule(
    "KD507",
    "tiny-value",
    Severity.WARNING,
    check_island=check_island,
    good=(_ball("0.000006"),),
    bad=(_ball("0.000003"), _ball("-0.000001")),
)
