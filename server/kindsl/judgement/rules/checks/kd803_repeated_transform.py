"""A frame, transform or Jacobian is listed twice.

## What it does
Reports, in a `.dtdsl` document, a frame or a pair of frames that is already listed in the same
section.

## Why is this bad?
The second one has no effect; perhaps another frame was meant.

## Example
```
Frames { fr_trunk, fr_foot, fr_trunk }
Transforms {
    base=fr_trunk, target=fr_foot
    base=fr_trunk, target=fr_foot
}
```
"""

from kindsl.judgement.rules.base import Rule, Severity

RULE = Rule(__name__, Severity.WARNING)
