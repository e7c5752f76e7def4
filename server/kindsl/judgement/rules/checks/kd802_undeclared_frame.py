"""A transform uses a frame that is not listed under `Frames`.

## What it does
Reports, in a `.dtdsl` document, frames of transforms and Jacobians that are not under `Frames`.

## Why is this bad?
RobCoGen resolves names against that list only.

## Example
```
Frames { fr_trunk }
Transforms {
    base=fr_trunk, target=fr_foot
}
```
"""

from kindsl.judgement.rules.base import Rule, Severity

RULE = Rule(__name__, Severity.ERROR)
