"""A syntax error in a transforms document.

## What it does
Reports, in a `.dtdsl` document, each word that is not allowed at its place, a missing word or
bracket at the next word, and sections that are repeated or out of order.

## Why is this bad?
RobCoGen stops at the first one.

## Example
```
Frames { fr_trunk fr_foot }
Transforms {
    fr_trunk <- fr_foot
}
```
A comma is missing between the frames of the list.
"""

from kindsl.judgement.rules.base import Rule, Severity

RULE = Rule(__name__, Severity.ERROR)
