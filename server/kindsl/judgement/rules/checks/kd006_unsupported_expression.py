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

from kindsl.judgement.rules.base import Rule, Severity

RULE = Rule(__name__, Severity.ERROR)
