"""A mass that is negative or zero.

## What it does
Reports a negative mass of a moving link as an error, and a mass of zero as a warning. The value may
be an expression; parameters are taken at their bound values. A fixed base may have any mass.

## Why is this bad?
A link without mass at the end of a chain makes the joint-space inertia matrix singular: forward
dynamics divides by zero. Both generators accept it in silence.

## Example
```kindsl
mass = -1.5
```
"""

from collections.abc import Iterator

from kindsl.rules.base import Finding, Rule, Severity
from kindsl.rules.broken_text import has_problem_within
from kindsl.rules.context import Context
from kindsl.rules.examples import STEEL_BALL, link
from kindsl.rules.inertia.judgements import is_moving
from kindsl.rules.inertia.wording import with_unit
from kindsl.semantics.declarations import Declarations, Link
from kindsl.semantics.expressions import Expression


def check_island(declared: Declarations, context: Context) -> Iterator[Finding]:
    """Yield a finding for each mass that is not positive."""
    for body in declared.bodies():
        mass = body.inertia.mass if body.inertia is not None else None
        value = mass.value(context.values) if mass is not None else None
        if mass is None or value is None or value > 0.0:
            continue
        if is_moving(body) and not has_problem_within(mass):
            yield _finding(body, mass, value)


def _finding(body: Link, mass: Expression, value: float) -> Finding:
    if value < 0.0:
        message = f"mass of '{body.name}' is negative: {with_unit(value, 'kg')}"
        return Finding(mass, message, severity=Severity.ERROR)
    message = f"mass of the moving link '{body.name}' is zero"
    return Finding(mass, message, severity=Severity.WARNING)


def _ball(mass: str) -> str:
    return link("ball", 1, inertia=STEEL_BALL.replace("4.1", mass, 1))


RULE = Rule(
    "KD303",
    "non-positive-mass",
    Severity.ERROR,
    check_island=check_island,
    good=(_ball("4.1"), _ball("m_ball")),
    bad=(_ball("-4.1"), _ball("0.0"), _ball("-m_ball[4.1]")),
)
