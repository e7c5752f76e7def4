"""A mass is negative or zero.

## What it does
Reports a negative mass of a moving link as an error, and a mass of zero as a warning. The value may
be an expression; parameters are taken at their bound values. A fixed base may have any mass.

## Why is this bad?
A link without mass at the end of a chain makes the joint-space inertia matrix singular: forward
dynamics divides by zero. Both generators accept it silently.

## Example
```kindsl
mass = -1.5
```

## Fix
Writes the mass without its sign where the body is possible then. Unsafe: it is a guess.
"""

from collections.abc import Iterator

from kindsl.judgement.diagnosis.judgements import Verdict, is_moving, verdict_of
from kindsl.judgement.rules.base import Finding, Fix, Replacement, Rule, Severity
from kindsl.judgement.rules.context import Context
from kindsl.language.semantics.declarations import Declarations, Inertia
from kindsl.language.semantics.expressions import Expression, Values
from kindsl.language.semantics.numbers import mass_distribution
from kindsl.language.semantics.places import has_problem_within
from kindsl.language.text.quantities import with_unit
from kindsl.mechanics.rigid.body import eigensystem, second_moments_about_com


def check_island(declared: Declarations, context: Context) -> Iterator[Finding]:
    for body in declared.bodies():
        inertia = body.inertia
        mass = inertia.mass if inertia is not None else None
        value = mass.value(context.values) if mass is not None else None
        if inertia is None or mass is None or value is None or value > 0.0:
            continue
        if not is_moving(body) or has_problem_within(mass):
            continue
        if value < 0.0:
            message = f"mass of '{body.name}' is negative: {with_unit(value, 'kg')}"
            yield Finding(mass, message, fix=_without_sign(inertia, mass, context.values))
        else:
            message = f"mass of the moving link '{body.name}' is zero"
            yield Finding(mass, message, severity=Severity.WARNING)


def _without_sign(inertia: Inertia, mass: Expression, values: Values) -> Fix | None:
    """Return the fix that takes the sign away, None where the body would be impossible still."""
    # Imported for a mass below zero only, since it delays the linter's start.
    from kindsl.judgement.diagnosis.digits import likely_half_widths, numbers_written

    written = mass_distribution(inertia, values)
    if written is None or mass.literal is None or has_problem_within(inertia):
        return None
    body = written._replace(mass=-written.mass)
    pairs = eigensystem(second_moments_about_com(body))
    half = likely_half_widths(numbers_written(inertia, values))
    if verdict_of(body, half, pairs) is not Verdict.POSSIBLE:
        return None
    text = mass.text.removeprefix("-")
    return Fix(f"Write {text}", (Replacement(mass, text),))


RULE = Rule(__name__, Severity.ERROR, check_island=check_island)
