"""A word of a transforms document does not fit.

## What it does
Reports, in a `.dtdsl` document, each word that cannot stand where it is, a missing word or bracket
at the word behind it, and sections that are repeated or out of order.

## Why is this bad?
RobCoGen stops there.

## Example
```
Transforms {
    base=fr_trunk target=fr_foot
}
```
A comma is missing between the frames.
"""

from kindsl.rules.base import Rule, Severity

RULE = Rule("KD800", "transforms-syntax-error", Severity.ERROR)
