"""Arithmetic that neither generator can read.

## What it does
Reports sums, parentheses, functions, products of two names and products that do not begin with a
number. Nothing else is reported of them.

## Why is this bad?
The language has values of one product or one quotient at most: `PI/2.0`, `2.0 x`, `-x/2.0`.

## Example
```kindsl
rotation = (3.0*PI/4.0, 0.0, 0.0)
```

## Fix
Writes the number, where no name is in it. Unsafe: it is rounded to 15 digits. Parentheses around
what the language has are removed, which is safe.
"""

from kindsl.rules.base import Example, Rule, Severity
from kindsl.rules.examples import pitched_joint

RULE = Rule(
    "KD006",
    "unsupported-expression",
    Severity.ERROR,
    good=(pitched_joint("PI/4.0"),),
    bad=(
        Example(pitched_joint("3.0*PI/4.0"), fixed=pitched_joint("2.356194490192345")),
        Example(pitched_joint("(PI/4.0)"), fixed=pitched_joint("PI/4.0")),
        pitched_joint("tilt+0.1"),
        pitched_joint("atan(1.0)"),
    ),
)
