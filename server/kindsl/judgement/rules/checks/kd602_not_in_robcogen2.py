"""A construct that RobCoGen2 does not support.

## What it does
Reports constructs of the language that RobCoGen2 refuses: block comments, escaped names, products
without `*`, names that begin with `pi`, and so on. An error for the target robcogen2; else it is
off, and a hint if it is selected. For the target robcogen2 it also reports the first defect of
names, ids or the tree at which RobCoGen2 stops with `KeyError` or `Inconsistent arguments` while it
loads the document; other rules report that defect too.

## Why is this bad?
RobCoGen2 stops and generates nothing.

## Example
```kindsl
translation = (2.0 reach, 0.0, 0.0)
```

## Fix
Writes an equivalent that both generators support, if there is one. Safe: the value stays.
"""

from kindsl.judgement.rules.context import ROBCOGEN2
from kindsl.judgement.rules.refusals import rule_of_refusals

RULE = rule_of_refusals(__name__, ROBCOGEN2)
