"""Something stands where a transforms document has no place for it.

## What it does
Reports, in a `.dtdsl` document, the first word that cannot stand where it stands.

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
