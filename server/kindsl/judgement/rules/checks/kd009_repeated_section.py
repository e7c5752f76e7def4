"""A block has the same section twice.

## What it does
Reports the second `children`, `id`, `Ix`, and so on. The first one counts.

## Why is this bad?
Both generators reject it. If the two differ, one of them is a leftover.

## Example
```kindsl
link upper {
    id = 1
    id = 2
    children {}
}
```

## Fix
Removes the second one, or gives it the keyword of the section that is missing. Unsafe: each is a
guess. No whole block is removed but in an editor, by hand.
"""

from kindsl.judgement.rules.base import Rule, Severity

RULE = Rule(__name__, Severity.ERROR)
