"""A block has no closing brace.

## What it does
Reports the `{` of a block that the next block, or the end of the document, cuts off.

## Why is this bad?
Generators report such a block at the end of the file, far from the mistake.

## Example
```kindsl
link upper {
    id = 1
    children { lower via elbow
}
```

## Fix
Inserts the brace where the indentation says that the block ends. Unsafe: it is a guess.
"""

from kindsl.judgement.rules.base import Rule, Severity

RULE = Rule(__name__, Severity.ERROR)
