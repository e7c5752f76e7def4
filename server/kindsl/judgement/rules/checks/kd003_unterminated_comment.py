"""A `/*` has no `*/`.

## What it does
Reports a block comment without end. It is taken to end before the next block, so that the rest of
the document is still understood.

## Why is this bad?
A generator reads everything behind it as comment and complains about the end of the file.

## Example
```kindsl
/* the right leg mirrors the left one
link RF_hip { id = 4 children {} }
```

## Fix
Writes the `*/`. Unsafe: the comment may be meant to end elsewhere. Where a word of the
comment becomes code, only editors offer it.
"""

from kindsl.judgement.rules.base import Rule, Severity

RULE = Rule(__name__, Severity.ERROR)
