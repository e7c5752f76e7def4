"""A block has the same section twice.

## What it does
Reports the second `children`, `id`, `Ix`, and so on. The first one counts.

## Why is this bad?
Both generators reject it. Where the two differ, one of them is a left-over.

## Example
```kindsl
link upper {
    id = 1
    id = 2
    children {}
}
```

## Fix
Removes the repetition if it says the same, which is safe.
"""

from kindsl.rules.base import Rule, Severity
from kindsl.rules.examples import link

RULE = Rule(
    "KD009",
    "repeated-section",
    Severity.ERROR,
    good=(link("upper", 1),),
    bad=(link("upper", 1).replace("id = 1", "id = 1 id = 1"),),
)
