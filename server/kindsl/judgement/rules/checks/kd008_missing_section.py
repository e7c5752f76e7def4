"""A block lacks a required section.

## What it does
Reports a link without `id` or `children`, an inertia without mass, centre of mass or one of its six
moments, a pose without translation or rotation, a joint without `ref_frame`, a robot without base.

## Why is this bad?
No section has a default: even a zero must be written.

## Example
```kindsl
link upper { children {} }
```

## Fix
Removes a `frames` section without a frame. Unsafe: a frame may be missing.
"""

from kindsl.judgement.rules.base import Rule, Severity

RULE = Rule(__name__, Severity.ERROR)
