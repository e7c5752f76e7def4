"""A block lacks a section that it must have.

## What it does
Reports a link without `id` or `children`, an inertia without mass, centre of mass or one of its six
moments, a pose without translation or rotation, a joint without `ref_frame`, a robot without base.

## Why is this bad?
Nothing has a default: a zero must be written too.

## Example
```kindsl
link upper { children {} }
```

## Fix
Inserts the section where it belongs, with zeros. Unsafe: zeros are seldom what is meant.
"""

from kindsl.rules.base import Rule, Severity
from kindsl.rules.examples import link

RULE = Rule(
    "KD008",
    "missing-section",
    Severity.ERROR,
    good=(link("upper", 1),),
    bad=(link("upper", 1).replace("id = 1", ""),),
)
