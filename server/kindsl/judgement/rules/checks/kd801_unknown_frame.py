"""A transforms document names a frame that the robot does not have.

## What it does
Reports, in a `.dtdsl` document, frames that are neither `fr_` with a link's or the base's name, nor
an optional frame of the model beside it.

## Why is this bad?
RobCoGen has nothing to generate and stops, in some versions without saying why.

## Example
```
Transforms {
    base=fr_trunk, target=fr_LF_fot
}
```
"""

from kindsl.judgement.rules.base import Rule, Severity

RULE = Rule("KD801", "unknown-frame", Severity.ERROR)
