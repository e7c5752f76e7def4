"""Arithmetic that neither generator supports.

## What it does
Reports sums, parentheses, functions, products of two names and products that do not begin with a
number. Nothing else is reported about them.

## Why is this bad?
A value in the language is at most one product or one quotient: `PI/2.0`, `2.0 x`, `-x/2.0`.

## Example
```kindsl
rotation = (3.0*PI/4.0, 0.0, 0.0)
```

## Fix
Writes the number, if the expression contains no name. Unsafe: it is rounded to 15 digits.
Parentheses around a supported value are removed, which is safe.
"""

from kindsl.judgement.rules.base import Example, Rule, Severity
from kindsl.judgement.rules.examples import pitched_joint

RULE = Rule(
    __name__,
    Severity.ERROR,
    good=(pitched_joint("PI/4.0"),),
    bad=(
        Example(pitched_joint("3.0*PI/4.0"), fixed=pitched_joint("2.356194490192345")),
        Example(pitched_joint("(PI/4.0)"), fixed=pitched_joint("PI/4.0")),
        pitched_joint("tilt+0.1"),
        pitched_joint("atan(1.0)"),
    ),
)
