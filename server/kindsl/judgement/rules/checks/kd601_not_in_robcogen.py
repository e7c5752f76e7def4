"""A construct that RobCoGen does not support.

## What it does
Reports constructs of the language that RobCoGen 0.x refuses: products with `*`, defaults such as
`x[1.0]`, constants `<k=1.0>`, numbers with exponents, keywords as names, and so on. An error for
the target robcogen; else it is off, and a hint if it is selected.

## Why is this bad?
RobCoGen answers "no viable alternative" and generates nothing. A base that is listed as a child,
which it does not resolve, is reported here too.

## Example
```kindsl
translation = (1.0e-3, 0.0, 0.0)
```

## Fix
Writes an equivalent that both generators support, if there is one: `0.001`. Safe: the value stays.
"""

from kindsl.judgement.rules.context import ROBCOGEN
from kindsl.judgement.rules.refusals import rule_of_refusals

RULE = rule_of_refusals(__name__, ROBCOGEN)
