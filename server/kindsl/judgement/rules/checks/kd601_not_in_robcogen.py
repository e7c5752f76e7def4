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

from functools import partial

from kindsl.judgement.rules.base import Rule, Severity
from kindsl.judgement.rules.context import ROBCOGEN
from kindsl.judgement.rules.refusals import refused_by
from kindsl.language.semantics.aspects import Aspect

RULE = Rule(
    __name__,
    Severity.ERROR,
    check_document=partial(refused_by, ROBCOGEN),
    reads=Aspect.SYMBOLS | Aspect.LAYOUT,
    is_default=False,
)
