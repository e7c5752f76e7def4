"""Arithmetic that neither generator can read.

## What it does
Reports sums, parentheses, products of two names and products that do not begin with a number. They
are understood, so nothing else is reported of them.

## Why is this bad?
The language has values of one product or one quotient at most: `PI/2.0`, `2.0 x`, `-x/2.0`.

## Example
```kindsl
rotation = (3.0*PI/4.0, 0.0, 0.0)
```

## Fix
Writes the number, where no name is in it. Safe: the value stays, to all digits that are kept.
"""

from kindsl.rules.base import Rule, Severity
from kindsl.rules.examples import joint

RULE = Rule(
    "KD006",
    "unsupported-expression",
    Severity.ERROR,
    good=(joint("elbow", rotation="PI/4.0, 0.0, 0.0"),),
    bad=(joint("elbow", rotation="3.0*PI/4.0, 0.0, 0.0"),),
)
